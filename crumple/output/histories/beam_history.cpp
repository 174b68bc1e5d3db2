// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "output/histories/sampled_history.hpp"
#include "output/results/block_places.hpp"
#include "output/results/line_results.hpp"
#include "output/results/point_results.hpp"

namespace crumple::output {

namespace {

constexpr Variable beam_variables[] = {
    {"axial", "axial"},       {"shear_s", "shear_s"}, {"shear_t", "shear_t"}, {"moment_s", "moment_s"},
    {"moment_t", "moment_t"}, {"torsion", "torsion"}, {"plastic_strain", ""}, {"", "ids", true},
    {"", "mat", true},        {"", "nip", true},
};
constexpr std::size_t beam_resultants = 6;  ///< the first of the variables

void print_beams(const HistoryItems&, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n\n r e s u l t a n t s   a n d   s t r e s s e s   f o r   t i m e  s t e p{:9}   "
                 "( at time{:12.5E} )\n",
                 sample.cycle(), sample.time());
  for (std::size_t beam = 0; beam < sample.of("ids").size(); ++beam) {
    fmt::format_to(end,
                   "\n\n\n\n beam/truss # ={:8}      material #  ={:5}\n\n\n"
                   " resultants      axial    shear-s    shear-t    moment-s   moment-t   torsion\n{:11}",
                   sample.of("ids")[beam], sample.of("mat")[beam], "");
    for (std::size_t i = 0; i < beam_resultants; ++i) fmt::format_to(end, "{:11.3E}", sample.of(i)[beam]);
    text += '\n';
  }
}

constexpr HistoryForm beam_elout{model::HistoryFile::Elout, "elout", "elout/beam", "", print_beams};

class BeamHistory : public SampledHistory {
 public:
  explicit BeamHistory(const View& view)
      : SampledHistory(beam_elout, beam_variables),
        places_(block_places(view.domain.beams, view.model.beams.size())) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.own_ids = true;
    for (const Index element : view.model.output.history_beams)
      items.ids.push_back(view.model.beams[element].id);
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const Index element : view.model.output.history_beams) {
      const auto [block_index, place] = places_[element];
      const LineResults results(view.model, view.domain.beams[block_index]);
      const auto value = [&, at = place](Resultant which) { return results.resultant(at, which); };
      // The moments in the middle, as they stand in the states.
      sample.add_item({value(Resultant::AxialForce), value(Resultant::ShearS), value(Resultant::ShearT),
                       0.5 * (value(Resultant::SecondMomentS) - value(Resultant::FirstMomentS)),
                       0.5 * (value(Resultant::SecondMomentT) - value(Resultant::FirstMomentT)),
                       value(Resultant::Torsion), results.plastic_strain(place)});
    }
  }

  void take_rest(const View& view, Sample& sample) override {
    for (const Index element : view.model.output.history_beams) {
      const model::BeamElement& beam = view.model.beams[element];
      sample.of("ids").push_back(static_cast<double>(beam.id));
      sample.of("mat").push_back(part_id_of(view.model, beam));
      // Beams are computed by their resultants and have no points.
      sample.of("nip").push_back(0);
    }
  }

 private:
  BlockPlaces places_;
};

}  // namespace

std::unique_ptr<History> make_beam_history(const View& view) {
  return std::make_unique<BeamHistory>(view);
}

}  // namespace crumple::output
