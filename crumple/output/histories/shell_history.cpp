// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "output/histories/sampled_history.hpp"
#include "output/results/block_places.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_axes.hpp"
#include "output/results/shell_results.hpp"

namespace crumple::output {

namespace {

constexpr Variable shell_variables[] = {
    {"plane", ""},     {"point", ""},       {"xx", ""},
    {"yy", ""},        {"zz", ""},          {"xy", ""},
    {"yz", ""},        {"zx", ""},          {"plastic_strain", ""},
    {"", "ids", true}, {"", "mat", true},   {"", "nip", true},
    {"", "iop", true}, {"", "state", true}, {"", "sig_xx"},
    {"", "sig_yy"},    {"", "sig_zz"},      {"", "sig_xy"},
    {"", "sig_yz"},    {"", "sig_zx"},      {"", "plastic_strain"},
};
constexpr std::size_t first_component = 2;  ///< of the variables
/// Stresses and plastic strain.
constexpr std::array<std::string_view, 7> means{"sig_xx", "sig_yy", "sig_zz",        "sig_xy",
                                                "sig_yz", "sig_zx", "plastic_strain"};

void print_shells(const HistoryItems&, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p"
                 "{:9}   ( at time{:12.5E} )\n\n element  materl(global)\n"
                 " ipt-shl  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx"
                 "       plastic\n           state{:81}strain \n",
                 sample.cycle(), sample.time(), "");
  std::size_t row = 0;
  for (std::size_t shell = 0; shell < sample.of("ids").size(); ++shell) {
    fmt::format_to(end, "{:8}-{:7}\n", sample.of("ids")[shell], sample.of("mat")[shell]);
    for (int point = 1; point <= sample.of("nip")[shell]; ++point, ++row) {
      fmt::format_to(end, "{:4}-{:3} {:<7} ", point, sample.of("iop")[shell],
                     stress_state_name(sample.of("state")[row]));
      for (std::size_t i = 0; i < 6; ++i) fmt::format_to(end, "{:12.4E}", sample.of(means[i])[row]);
      fmt::format_to(end, "{:14.4E}\n", sample.of("plastic_strain")[row]);
    }
  }
}

constexpr HistoryForm shell_elout{model::HistoryFile::Elout, "elout", "elout/shell", "", print_shells};

/// ELFORM.
double number_of(model::ShellFormulation formulation) {
  using enum model::ShellFormulation;
  switch (formulation) {
    case HughesLiu:
      return 1;
    case Triangle:
      return 4;
    case HughesLiuSelectiveReduced:
      return 6;
    case BelytschkoWongChiang:
      return 10;
    case FullyIntegrated:
      return 16;
    case Membrane:
    case MembraneTriangle:
      return 5;
    case FullyIntegratedMembrane:
      return 9;
    case BelytschkoTsay:
      break;
  }
  return 2;
}

Index layers_of(const domain::ShellBlock& block) {
  return std::max<Index>(1, block.thickness_points);
}

/// Stress and plastic strain of every point; LS-DYNA's forms have the means of the points in plane.
class ShellHistory : public SampledHistory {
 public:
  explicit ShellHistory(const View& view)
      : SampledHistory(shell_elout, shell_variables),
        places_(block_places(view.domain.shells, view.model.shells.size())) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.own_ids = true;
    items.texts = {{"states", stress_states}, {"system", "global"}};
    for (const Index element : view.model.output.history_shells) {
      const domain::ShellBlock& block = view.domain.shells[places_[element].first];
      const auto points = static_cast<std::size_t>(layers_of(block) * block.plane_points);
      items.ids.insert(items.ids.end(), points, view.model.shells[element].id);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const Index element : view.model.output.history_shells) {
      const auto [block_index, place] = places_[element];
      const domain::ShellBlock& block = view.domain.shells[block_index];
      const ShellAxes axes = shell_axes(block, view.domain.nodes, place);
      const Index layers = layers_of(block);
      for (Index point = 0; point < layers * block.plane_points; ++point) {
        const Tensor stress =
            in_global_axes(axes, stress_of<ShellResults::stress_components>(block, place, point));
        const Index plane = point / layers + 1;
        const Index layer = point % layers + 1;
        sample.add_item({static_cast<double>(plane), static_cast<double>(layer), stress[0], stress[1],
                         stress[2], stress[3], stress[4], stress[5], plastic_strain_of(block, place, point)});
      }
    }
  }

  void take_rest(const View& view, Sample& sample) override {
    std::size_t row = 0;
    for (const Index element : view.model.output.history_shells) {
      const model::ShellElement& shell = view.model.shells[element];
      const domain::ShellBlock& block = view.domain.shells[places_[element].first];
      const auto layers = static_cast<std::size_t>(layers_of(block));
      const auto planes = static_cast<std::size_t>(block.plane_points);
      sample.of("ids").push_back(static_cast<double>(shell.id));
      sample.of("mat").push_back(part_id_of(view.model, shell));
      sample.of("nip").push_back(static_cast<double>(layers));
      const model::ShellSection& section = view.model.shell_sections[view.model.parts[shell.part].section];
      sample.of("iop").push_back(number_of(section.formulation));
      for (std::size_t layer = 0; layer < layers; ++layer) add_mean(row + layer, layers, planes, sample);
      row += layers * planes;
    }
  }

 private:
  /// Of rows that lie `step` apart.
  static void add_mean(std::size_t row, std::size_t step, std::size_t rows, Sample& sample) {
    for (std::size_t i = 0; i < means.size(); ++i) {
      const std::vector<double>& values = sample.of(first_component + i);
      double sum = 0;
      for (std::size_t k = 0; k < rows; ++k) sum += values[row + k * step];
      sample.of(means[i]).push_back(sum / static_cast<double>(rows));
    }
    sample.of("state").push_back(stress_state_of(sample.of("plastic_strain").back()));
  }

  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_shell_history(const View& view) {
  return std::make_unique<ShellHistory>(view);
}

}  // namespace crumple::output
