// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "output/histories/sampled_history.hpp"
#include "output/results/block_places.hpp"
#include "output/results/point_results.hpp"
#include "output/results/solid_results.hpp"

namespace crumple::output {

namespace {

constexpr Variable solid_variables[] = {
    {"point", ""},     {"xx", ""},          {"yy", ""},          {"zz", ""},
    {"xy", ""},        {"yz", ""},          {"zx", ""},          {"plastic_strain", ""},
    {"", "ids", true}, {"", "mtype", true}, {"", "state", true}, {"", "sig_xx"},
    {"", "sig_yy"},    {"", "sig_zz"},      {"", "sig_xy"},      {"", "sig_yz"},
    {"", "sig_zx"},    {"", "yield"},       {"", "effsg"},
};
constexpr std::array<std::string_view, 6> stresses{"sig_xx", "sig_yy", "sig_zz",
                                                   "sig_xy", "sig_yz", "sig_zx"};

void print_solids(const HistoryItems&, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n e l e m e n t   s t r e s s   c a l c u l a t i o n s   f o r   t i m e  s t e p"
                 "{:9}   ( at time{:12.5E} )\n\n element  materl\n"
                 "     ipt  stress       sig-xx      sig-yy      sig-zz      sig-xy      sig-yz      sig-zx"
                 "{:23}yield\n           state{:82}effsg      function\n",
                 sample.cycle(), sample.time(), "", "");
  for (std::size_t solid = 0; solid < sample.of("ids").size(); ++solid) {
    fmt::format_to(end, "{:8}-{:7}\n       1 {:<7} ", sample.of("ids")[solid], sample.of("mtype")[solid],
                   stress_state_name(sample.of("state")[solid]));
    for (const std::string_view name : stresses) fmt::format_to(end, "{:12.4E}", sample.of(name)[solid]);
    fmt::format_to(end, "{:14.4E}{:14.4E}\n", sample.of("effsg")[solid], sample.of("yield")[solid]);
  }
}

constexpr HistoryForm solid_elout{model::HistoryFile::Elout, "elout", "elout/solid", "", print_solids};

/// Stress and plastic strain of every point; LS-DYNA's forms have the means of the element.
class SolidHistory : public SampledHistory {
 public:
  explicit SolidHistory(const View& view)
      : SampledHistory(solid_elout, solid_variables),
        places_(block_places(view.domain.solids, view.model.solids.size())) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.own_ids = true;
    items.texts = {{"states", stress_states}};
    for (const Index element : view.model.output.history_solids) {
      const domain::SolidBlock& block = view.domain.solids[places_[element].first];
      items.ids.insert(items.ids.end(), static_cast<std::size_t>(block.points),
                       view.model.solids[element].id);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const Index element : view.model.output.history_solids) {
      const auto [block_index, place] = places_[element];
      const domain::SolidBlock& block = view.domain.solids[block_index];
      for (Index point = 0; point < block.points; ++point) {
        const SolidResults::Stress stress =
            stress_of<std::tuple_size_v<SolidResults::Stress>>(block, place, point);
        sample.add_item({static_cast<double>(point + 1), stress[0], stress[1], stress[2], stress[3],
                         stress[4], stress[5], plastic_strain_of(block, place, point)});
      }
    }
  }

  void take_rest(const View& view, Sample& sample) override {
    for (const Index element : view.model.output.history_solids) {
      const model::SolidElement& solid = view.model.solids[element];
      const auto [block_index, place] = places_[element];
      const SolidResults results(view.domain.solids[block_index]);
      sample.of("ids").push_back(static_cast<double>(solid.id));
      sample.of("mtype").push_back(part_id_of(view.model, solid));
      const double plastic_strain = results.mean_plastic_strain(place);
      sample.of("state").push_back(stress_state_of(plastic_strain));
      const SolidResults::Stress stress = results.mean_stress(place);
      for (std::size_t i = 0; i < stresses.size(); ++i) sample.of(stresses[i]).push_back(stress[i]);
      sample.of("yield").push_back(plastic_strain);
      sample.of("effsg").push_back(results.mean_von_mises(place));
    }
  }

 private:
  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_solid_history(const View& view) {
  return std::make_unique<SolidHistory>(view);
}

}  // namespace crumple::output
