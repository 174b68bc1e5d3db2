// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable energy_variables[] = {
    {"dt", "time_step"},
    {"kinetic", "kinetic_energy"},
    {"internal", ""},
    {"hourglass", "hourglass_energy"},
    {"contact", ""},
    {"friction", ""},
    {"rigidwall", ""},
    {"damping", "system_damping_energy"},
    {"external_work", "external_work"},
    {"eroded", "eroded_internal_energy"},
    {"total", "total_energy"},
    {"ratio", "energy_ratio"},
    {"added_mass", "added_mass"},
    {"", "internal_energy"},
    {"", "sliding_interface_energy"},
    {"", "stonewall_energy"},
    {"", "spring_and_damper_energy"},
    {"", "eroded_kinetic_energy"},
    {"", "eroded_hourglass_energy"},
    {"", "energy_ratio_wo_eroded"},
    {"", "global_x_velocity"},
    {"", "global_y_velocity"},
    {"", "global_z_velocity"},
    {"", "percent_increase"},
    {"", "nzc", true},
    {"", "ts_eltype", true},
    {"", "ts_element", true},
    {"", "ts_part", true},
};

/// Places, from one, are the values of ts_eltype.
constexpr std::array<std::string_view, 4> element_types{"solid", "beam", "shell", "discrete"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> lines_to_walls{{
    {"time", ""},
    {"time step", "time_step"},
    {"kinetic energy", "kinetic_energy"},
    {"internal energy", "internal_energy"},
    {"stonewall energy", "stonewall_energy"},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> lines_after_walls{{
    {"spring and damper energy", "spring_and_damper_energy"},
    {"hourglass energy ", "hourglass_energy"},
    {"system damping energy", "system_damping_energy"},
    {"sliding interface energy", "sliding_interface_energy"},
    {"external work", "external_work"},
    {"eroded kinetic energy", "eroded_kinetic_energy"},
    {"eroded internal energy", "eroded_internal_energy"},
    {"eroded hourglass energy", "eroded_hourglass_energy"},
    {"total energy", "total_energy"},
    {"total energy / initial energy", "energy_ratio"},
    {"energy ratio w/o eroded energy", "energy_ratio_wo_eroded"},
    {"global x velocity", "global_x_velocity"},
    {"global y velocity", "global_y_velocity"},
    {"global z velocity", "global_z_velocity"},
}};

void print_line(std::string_view label, double value, std::string& text) {
  fmt::format_to(std::back_inserter(text), " {:.<31}{:14.5E}", label, value);
}

void print_controlling(const Sample& sample, std::string& text) {
  fmt::format_to(std::back_inserter(text), "\n\n dt of cycle{:8} is controlled by ", sample.cycle());
  if (sample.of("ts_eltype").empty()) {
    text += "no element\n\n";
    return;
  }
  const auto type = static_cast<std::size_t>(sample.of("ts_eltype")[0]);
  fmt::format_to(std::back_inserter(text), "{:<5}{:10} of part{:10}\n\n", element_types[type - 1],
                 std::llround(sample.of("ts_element")[0]), std::llround(sample.of("ts_part")[0]));
}

void print_energies(const HistoryItems&, const Sample& sample, std::string& text) {
  print_controlling(sample, text);
  for (const auto& [label, name] : lines_to_walls) {
    if (name == "stonewall_energy") {
      int wall = 0;
      for (const double energy : sample.of(name)) {
        print_line(label, energy, text);
        fmt::format_to(std::back_inserter(text), " wall#{:2}\n", ++wall);
      }
      continue;
    }
    print_line(label, name.empty() ? sample.time() : sample.of(name)[0], text);
    text += '\n';
  }
  for (const auto& [label, name] : lines_after_walls) {
    print_line(label, sample.of(name)[0], text);
    text += '\n';
  }
  fmt::format_to(std::back_inserter(text), " time per zone cycle.(nanosec)..{:14}\n",
                 std::llround(sample.of("nzc")[0]));
  if (sample.of("added_mass")[0] == 0) return;
  text += "\n\n";
  print_line("added mass", sample.of("added_mass")[0], text);
  text += '\n';
  print_line("percentage increase", sample.of("percent_increase")[0], text);
  text += '\n';
}

constexpr HistoryForm glstat_form{model::HistoryFile::Glstat, "glstat", "glstat", "", print_energies};

double wall_nanoseconds(const domain::Domain& domain) {
  const double elements =
      static_cast<double>(domain::element_count(domain.shells) + domain::element_count(domain.solids) +
                          domain::element_count(domain.beams) + domain::element_count(domain.discretes));
  const double work = elements * static_cast<double>(domain.clock.cycle);
  const domain::StageTimes& times = domain.times;
  const double seconds = times.elements + times.contact_search + times.contact_local + times.contact_forces +
                         times.constraints + times.integrate + times.output;
  return work > 0 ? 1e9 * seconds / work : 0.0;
}

class EnergyHistory : public SampledHistory {
 public:
  EnergyHistory() : SampledHistory(glstat_form, energy_variables) {}

 protected:
  HistoryItems find_items(const View&) override {
    std::string types;
    for (const std::string_view type : element_types) types.append(types.empty() ? "" : ",").append(type);
    return {.of_model = true,
            .ids = {},
            .words = {},
            .titles = {},
            .marks = {},
            .texts = {{"element_types", types}}};
  }

  void take(const View& view, Sample& sample) override {
    const domain::EnergyLedger& energy = view.domain.energy;
    sample.add_item({view.next_step, energy.kinetic, energy.internal, energy.hourglass, energy.contact,
                     energy.friction, energy.rigidwall, energy.damping, energy.external_work, energy.eroded,
                     energy.total(), energy.ratio(), view.domain.added_mass});
  }

  void take_rest(const View& view, Sample& sample) override {
    const domain::EnergyLedger& energy = view.domain.energy;
    // LS-DYNA's sum over all elements keeps those that are gone.
    sample.of("internal_energy") = {energy.internal + energy.eroded};
    sample.of("sliding_interface_energy") = {energy.contact + energy.friction};
    for (const domain::WallReport& wall : view.domain.walls)
      // The first kick comes before the first row, whose energies are those of time zero.
      sample.of("stonewall_energy").push_back(view.domain.clock.cycle == 0 ? 0 : wall.energy);
    double springs = 0;
    for (const domain::DiscreteBlock& block : view.domain.discretes) springs += block.internal_energy;
    sample.of("spring_and_damper_energy") = {springs};
    // What was in an element that is gone is not kept apart; its mass stays at the nodes.
    sample.of("eroded_kinetic_energy") = {0};
    sample.of("eroded_hourglass_energy") = {0};
    const double supplied = energy.initial_total + energy.external_work;
    sample.of("energy_ratio_wo_eroded") = {supplied != 0 ? (energy.total() - energy.eroded) / supplied : 1.0};
    take_velocity(view, sample);
    sample.of("nzc") = {wall_nanoseconds(view.domain)};
    if (view.controlling) take_controlling(view.controlling(), sample);
  }

 private:
  static void take_velocity(const View& view, Sample& sample) {
    const domain::NodeFields& nodes = view.domain.nodes;
    math::Vec3 momentum;
    double mass = 0;
    for (Index node = 0; node < nodes.count(); ++node) {
      momentum += nodes.mass[node] * nodes.velocity[node];
      mass += nodes.mass[node];
    }
    const math::Vec3 velocity = mass > 0 ? (1 / mass) * momentum : math::Vec3{};
    sample.of("global_x_velocity") = {velocity.x};
    sample.of("global_y_velocity") = {velocity.y};
    sample.of("global_z_velocity") = {velocity.z};
    const double added = view.domain.added_mass;
    sample.of("percent_increase") = {mass > added ? 100 * added / (mass - added) : 0.0};
  }

  static void take_controlling(const domain::ControllingElement& controlling, Sample& sample) {
    const std::string_view kind = controlling.kind;
    const auto* type = std::find(element_types.begin(), element_types.end(), kind.substr(0, kind.find(' ')));
    if (type == element_types.end()) return;
    sample.of("ts_eltype") = {static_cast<double>(type - element_types.begin() + 1)};
    sample.of("ts_element") = {static_cast<double>(controlling.element)};
    sample.of("ts_part") = {static_cast<double>(controlling.part)};
  }
};

}  // namespace

std::unique_ptr<History> make_energy_history() {
  return std::make_unique<EnergyHistory>();
}

}  // namespace crumple::output
