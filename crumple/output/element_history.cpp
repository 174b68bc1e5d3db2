// SPDX-License-Identifier: BSD-3-Clause
// Stresses of single elements.
#include <algorithm>

#include "output/block_places.hpp"
#include "output/history.hpp"
#include "output/line_results.hpp"
#include "output/shell_axes.hpp"
#include "output/shell_results.hpp"

namespace crumple::output {

namespace {

/// Effective plastic strain of a point; zero of a law without.
double plastic_strain_of(const domain::ElementBlock& block, Index place, Index point) {
  const domain::StateItem* const item = block.find("plastic_strain");
  return item == nullptr || point >= item->count ? 0.0 : block.state(place, item->first + point);
}

/// The components of a point as they are kept; zero where none are.
template <std::size_t Count>
std::array<double, Count> stress_of(const domain::ElementBlock& block, Index place, Index point) {
  std::array<double, Count> stress{};
  if (const domain::StateItem* const item = block.find("stress"))
    for (std::size_t c = 0; c < Count; ++c)
      stress[c] = block.state(place, item->first + point * static_cast<Index>(Count) + static_cast<Index>(c));
  return stress;
}

class ShellHistory : public History {
 public:
  explicit ShellHistory(const View& view)
      : places_(block_places(view.domain.shells, view.model.shells.size())) {}

  void add_rows(const View& view, CsvFile& table) override {
    for (const Index element : view.model.output.history_shells) {
      const auto [block_index, place] = places_[element];
      const domain::ShellBlock& block = view.domain.shells[block_index];
      const ShellAxes axes = shell_axes(block, view.domain.nodes, place);
      const Index layers = std::max<Index>(1, block.thickness_points);
      for (Index point = 0; point < layers * block.plane_points; ++point) {
        const Tensor stress =
            in_global_axes(axes, stress_of<ShellResults::stress_components>(block, place, point));
        table.add_row(view.domain.clock.time, view.model.shells[element].id, point / layers + 1,
                      point % layers + 1, stress[0], stress[1], stress[2], stress[3], stress[4], stress[5],
                      plastic_strain_of(block, place, point));
      }
    }
  }

 private:
  BlockPlaces places_;
};

class SolidHistory : public History {
 public:
  explicit SolidHistory(const View& view)
      : places_(block_places(view.domain.solids, view.model.solids.size())) {}

  void add_rows(const View& view, CsvFile& table) override {
    for (const Index element : view.model.output.history_solids) {
      const auto [block_index, place] = places_[element];
      const domain::SolidBlock& block = view.domain.solids[block_index];
      for (Index point = 0; point < block.points; ++point) {
        const Tensor stress = stress_of<std::tuple_size_v<Tensor>>(block, place, point);
        table.add_row(view.domain.clock.time, view.model.solids[element].id, point + 1, stress[0], stress[1],
                      stress[2], stress[3], stress[4], stress[5], plastic_strain_of(block, place, point));
      }
    }
  }

 private:
  BlockPlaces places_;
};

class BeamHistory : public History {
 public:
  explicit BeamHistory(const View& view)
      : places_(block_places(view.domain.beams, view.model.beams.size())) {}

  void add_rows(const View& view, CsvFile& table) override {
    for (const Index element : view.model.output.history_beams) {
      const auto [block_index, place] = places_[element];
      const LineResults results(view.model, view.domain.beams[block_index]);
      const auto value = [&, at = place](Resultant which) { return results.resultant(at, which); };
      // The moments in the middle, as they stand in the states.
      table.add_row(view.domain.clock.time, view.model.beams[element].id, value(Resultant::AxialForce),
                    value(Resultant::ShearS), value(Resultant::ShearT),
                    0.5 * (value(Resultant::SecondMomentS) - value(Resultant::FirstMomentS)),
                    0.5 * (value(Resultant::SecondMomentT) - value(Resultant::FirstMomentT)),
                    value(Resultant::Torsion), results.plastic_strain(place));
    }
  }

 private:
  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_shell_history(const View& view) {
  return std::make_unique<ShellHistory>(view);
}

std::unique_ptr<History> make_solid_history(const View& view) {
  return std::make_unique<SolidHistory>(view);
}

std::unique_ptr<History> make_beam_history(const View& view) {
  return std::make_unique<BeamHistory>(view);
}

}  // namespace crumple::output
