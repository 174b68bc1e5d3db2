// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/surface/surface.hpp"
#include "domain/node_fields.hpp"

namespace crumple::contact {

/// Height of the solid behind a face as it is deformed now: the undeformed one (Surface::height) times by how
/// much the mean of the solid's other nodes has come nearer to the face. Foam that is crushed is a fraction
/// of what it was [length]. `segment`: one of the faces of solids.
double height_now(const Surface& surface, const domain::NodeFields& nodes, Index segment);

}  // namespace crumple::contact
