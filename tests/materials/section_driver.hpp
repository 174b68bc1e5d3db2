// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/aligned_array.hpp"
#include "materials/common/section_material.hpp"

namespace crumple::materials::testing {

/// One point at the origin of the cross section: its strains are stretch and both shears.
class SectionPoint {
 public:
  explicit SectionPoint(const model::Material& material, Isa isa = default_isa()) : isa_(isa) {
    block_.points = 1;
    block_.elements = 1;
    block_.corners = 2;
    kind_ = section_material_kind(material.law);
    stress_ = domain::add_item(block_, "stress", "stress", section_components);
    history_ = declare_section_history(material.law, block_);
    constants_ = section_material_constants(material);
    block_.allocate(Precision::Double);
  }

  void advance(double axial, double along_s, double along_t, double step) {
    // The kernel reads packs of its own width, one row after the other, on cache lines.
    alignas(cache_line) double rows[section_row::count * lanes] = {};
    alignas(cache_line) double resultant[section_row::count * lanes] = {};
    alignas(cache_line) double intact[lanes] = {};
    const int width = isa_ == Isa::Scalar ? 1 : isa_ == Isa::Baseline ? 2 : isa_ == Isa::Avx2 ? 4 : 8;
    rows[section_row::stretch * width] = axial;
    rows[section_row::shear_s * width] = along_s;
    rows[section_row::shear_t * width] = along_t;
    const double place[] = {0, 0, 1};
    section_material_update(isa_, kind_)({.state = block_.double_state.data(),
                                          .stress = stress_,
                                          .history = history_,
                                          .points = 1,
                                          .place = place,
                                          .constants = constants_.data(),
                                          .step = step,
                                          .strain = rows,
                                          .resultant = resultant,
                                          .intact = intact});
    intact_ = intact[0];
  }

  double stress(Index component) const { return block_.state(0, stress_ + component); }
  double plastic_strain() const { return block_.state(0, block_.find("plastic_strain")->first); }
  double intact() const { return intact_; }

 private:
  Isa isa_;
  domain::ElementBlock block_;
  int kind_ = -1;
  Index stress_ = 0;
  Index history_ = 0;
  std::vector<double> constants_;
  double intact_ = 1;
};

}  // namespace crumple::materials::testing
