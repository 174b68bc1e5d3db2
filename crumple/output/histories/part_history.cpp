// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"
#include "output/results/part_masses.hpp"

namespace crumple::output {

namespace {

constexpr Variable part_variables[] = {
    {"internal", "internal_energy"},
    {"kinetic", "kinetic_energy"},
    {"hourglass", "hourglass_energy"},
    {"vx", "x_rbvelocity"},
    {"vy", "y_rbvelocity"},
    {"vz", "z_rbvelocity"},
    {"mass", ""},
    {"", "x_momentum"},
    {"", "y_momentum"},
    {"", "z_momentum"},
    {"", "eroded_internal_energy"},
    {"", "eroded_kinetic_energy"},
    {"", "mass"},  // LS-DYNA's is what mass scaling adds to the part
};

void print_parts(const HistoryItems& items, const Sample& sample, std::string& text) {
  fmt::format_to(std::back_inserter(text), "\n\n time ={:13.4E}\n", sample.time());
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    const auto value = [&](std::string_view name) { return sample.of(name)[i]; };
    const auto end = std::back_inserter(text);
    if (items.ids[i] < 100000)
      fmt::format_to(end, " mat.#={:5}   ", items.ids[i]);
    else
      fmt::format_to(end, " mat.#={:8}", items.ids[i]);
    fmt::format_to(end,
                   "{:10}inten={:13.4E}     kinen={:13.4E}     eroded_ie={:13.4E}     eroded_ke={:13.4E}\n",
                   "", value("internal_energy"), value("kinetic_energy"), value("eroded_internal_energy"),
                   value("eroded_kinetic_energy"));
    fmt::format_to(end, " x-mom={:13.4E}     y-mom={:13.4E}     z-mom={:13.4E}\n", value("x_momentum"),
                   value("y_momentum"), value("z_momentum"));
    fmt::format_to(end, " x-rbv={:13.4E}     y-rbv={:13.4E}     z-rbv={:13.4E}\n", value("x_rbvelocity"),
                   value("y_rbvelocity"), value("z_rbvelocity"));
    fmt::format_to(end, "{:25}hgeng={:13.4E}     ", "", value("hourglass_energy"));
    if (!sample.of("mass").empty()) fmt::format_to(end, "+mass={:13.4E}", value("mass"));
    text += '\n';
  }
}

constexpr HistoryForm matsum_form{model::HistoryFile::Matsum, "matsum", "matsum", "", print_parts};

class PartHistory : public SampledHistory {
 public:
  explicit PartHistory(const View& view) : SampledHistory(matsum_form, part_variables), masses_(view) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const model::Part& part : view.model.parts) {
      items.ids.push_back(part.id);
      items.titles.push_back(part.title);
    }
    return items;
  }

  void take(const View& view, Sample& sample) override {
    std::vector<double> internal(view.model.parts.size());
    std::vector<double> hourglass(view.model.parts.size());
    std::vector<double> eroded(view.model.parts.size());
    for (const domain::ElementBlock* block : view.domain.blocks()) {
      internal[block->part] += block->internal_energy;
      hourglass[block->part] += block->hourglass_energy;
      eroded[block->part] += block->eroded_energy;
    }
    for (Index part = 0; part < static_cast<Index>(view.model.parts.size()); ++part) {
      const PartMasses::Motion motion = masses_.motion_with_body(view.domain, part);
      const math::Vec3 momentum = motion.mass * motion.velocity;
      sample.add_item({internal[part], motion.kinetic_energy, hourglass[part], motion.velocity.x,
                       motion.velocity.y, motion.velocity.z, motion.mass, momentum.x, momentum.y, momentum.z,
                       eroded[part], 0});
    }
  }

  void take_rest(const View& view, Sample& sample) override {
    // How mass scaling's share is spread over the parts is not kept.
    if (view.domain.added_mass == 0) sample.of("mass").assign(view.model.parts.size(), 0);
  }

 private:
  PartMasses masses_;
};

}  // namespace

std::unique_ptr<History> make_part_history(const View& view) {
  return std::make_unique<PartHistory>(view);
}

}  // namespace crumple::output
