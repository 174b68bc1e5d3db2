// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Finds which nodes the tied contacts of a model join to which segments, into domain.ties. The nodes of ties
/// by constraint are put onto their segments: positions and reference positions change, so that this comes
/// before the elements are prepared. A node that an earlier contact holds by constraint is left out of later
/// ones (as in LS-DYNA).
///
/// A node is tied to the nearest segment of the second side if it is not further away than the larger of
/// 0.60 (t_node + t_segment), with the thicknesses of shells, and 0.05 of the segment's smaller diagonal
/// (LS-DYNA Keyword User's Manual, *CONTACT, remarks on tied contacts), or than the contact's own tolerance.
/// Throws Error for a contact that has no node or no segment, or ties nothing.
void find_ties(const model::Model& model, domain::Domain& domain);

}  // namespace crumple::contact
