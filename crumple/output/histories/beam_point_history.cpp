// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/history.hpp"
#include "output/results/block_places.hpp"
#include "output/results/point_results.hpp"

namespace crumple::output {

namespace {

/// Stresses and plastic strain of every point of integrated beams, with its place in the cross section.
class BeamPointHistory : public History {
 public:
  explicit BeamPointHistory(const View& view)
      : places_(block_places(view.domain.beams, view.model.beams.size())) {}

  void add_rows(const View& view, CsvFile& table) override {
    for (const Index element : view.model.output.history_beams) {
      const auto [block_index, place] = places_[element];
      const domain::BeamBlock& block = view.domain.beams[block_index];
      if (block.formulation != model::BeamFormulation::Integrated) continue;
      const auto& points = view.model.beam_sections[view.model.parts[block.part].beam_section].points;
      for (Index point = 0; point < block.points; ++point) {
        const auto stress = stress_of<section_stresses>(block, place, point);
        const model::SectionPoint& at = points[static_cast<std::size_t>(point)];
        table.add_row(view.domain.clock.time, view.model.beams[element].id, point + 1, at.s, at.t, stress[0],
                      stress[1], stress[2], plastic_strain_of(block, place, point));
      }
    }
  }

 private:
  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_beam_point_history(const View& view) {
  return std::make_unique<BeamPointHistory>(view);
}

}  // namespace crumple::output
