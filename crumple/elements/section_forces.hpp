// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "domain/domain.hpp"
#include "domain/section_report.hpp"
#include "model/model.hpp"

namespace crumple::elements {

/// Forces in cross-sections. The elements of a section are computed a second time, on a copy of their state
/// and alone, so that what they put on the nodes can be told from what others do; the elements' own forces
/// have the same bits with sections and without.
class SectionForces {
 public:
  SectionForces() = default;
  /// Collects the sections of the model; none if output does not ask for their forces. The elements have been
  /// prepared.
  SectionForces(const model::Model& model, const domain::Domain& domain);

  /// To be called right before add_element_forces(), from which nothing differs: state of n-1, nodes of n.
  void measure(domain::Domain& domain);

  /// Of the last measurement, in the order of the model.
  std::span<const domain::SectionReport> reports() const { return reports_; }

  /// Declares the reports, which show time n until the next step.
  void declare(domain::StateList& list) {
    if (!reports_.empty())
      list.add("sections", "force, force * length, length", domain::Entity::Run, 1, std::span(reports_));
  }

 private:
  /// The elements of one section, with their nodes, as a domain of their own.
  struct Section {
    domain::Domain part;
    std::vector<Index> node;  ///< in the whole domain, by node of `part`
    std::vector<Index> cut;   ///< nodes of `part` that the forces are summed over
    std::vector<Index> own;   ///< nodes of the whole domain for the centroid
    /// By block of `part`: the block of the whole domain, and the places there of its elements.
    std::vector<std::pair<Index, std::vector<Index>>> source;
  };
  static Section make_section(const model::CrossSection& given, const domain::Domain& domain);
  static void copy_present(const domain::Domain& domain, Section& section);

  std::vector<Section> sections_;
  std::vector<domain::SectionReport> reports_;
  bool averages_ = false;  ///< elements of sections average at their nodes
};

}  // namespace crumple::elements
