// SPDX-License-Identifier: BSD-3-Clause
#include "compare/curves/quantity_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace crumple::compare {

namespace {

using Names = std::pair<std::string_view, std::string_view>;

constexpr std::array glstat_names = {
    Names{"time_step", "dt"},
    Names{"kinetic_energy", "kinetic"},
    Names{"internal_energy", "internal"},
    Names{"hourglass_energy", "hourglass"},
    Names{"sliding_interface_energy", "sliding_interface"},
    Names{"stonewall_energy", "rigidwall"},
    Names{"system_damping_energy", "damping"},
    Names{"total_energy", "total"},
    Names{"energy_ratio", "ratio"},
    Names{"total_energy_/_initial_energy", "ratio"},
    Names{"energy_ratio_w/o_eroded_energy", "ratio_without_eroded"},
    Names{"energy_ratio_wo_eroded", "ratio_without_eroded"},
    Names{"eroded_kinetic_energy", "eroded_kinetic"},
    Names{"eroded_internal_energy", "eroded_internal"},
    Names{"eroded_hourglass_energy", "eroded_hourglass"},
    Names{"spring_and_damper_energy", "spring_and_damper"},
    Names{"percentage_increase", "percent_increase"},
    Names{"global_x_velocity", "vx"},
    Names{"global_y_velocity", "vy"},
    Names{"global_z_velocity", "vz"},
};

constexpr std::array matsum_names = {
    Names{"internal_energy", "internal"},
    Names{"inten", "internal"},
    Names{"kinetic_energy", "kinetic"},
    Names{"kinen", "kinetic"},
    Names{"hourglass_energy", "hourglass"},
    Names{"hgeng", "hourglass"},
    Names{"eroded_internal_energy", "eroded_internal"},
    Names{"eroded_ie", "eroded_internal"},
    Names{"eroded_kinetic_energy", "eroded_kinetic"},
    Names{"eroded_ke", "eroded_kinetic"},
    Names{"eroded_hourglass_energy", "eroded_hourglass"},
    Names{"eroded_he", "eroded_hourglass"},
    // LS-DYNA's part mass is the one that mass scaling has added.
    Names{"mass", "added_mass"},
    Names{"+mass", "added_mass"},
    Names{"x-mom", "x_momentum"},
    Names{"y-mom", "y_momentum"},
    Names{"z-mom", "z_momentum"},
    Names{"x_rbvelocity", "vx"},
    Names{"y_rbvelocity", "vy"},
    Names{"z_rbvelocity", "vz"},
    Names{"x-rbv", "vx"},
    Names{"y-rbv", "vy"},
    Names{"z-rbv", "vz"},
};

constexpr std::array common_names = {
    Names{"normal_force", "normal"}, Names{"x_force", "fx"},
    Names{"y_force", "fy"},          Names{"z_force", "fz"},
    Names{"x_displacement", "ux"},   Names{"y_displacement", "uy"},
    Names{"z_displacement", "uz"},   Names{"x_velocity", "vx"},
    Names{"y_velocity", "vy"},       Names{"z_velocity", "vz"},
    Names{"x_acceleration", "ax"},   Names{"y_acceleration", "ay"},
    Names{"z_acceleration", "az"},   Names{"x_coordinate", "x"},
    Names{"y_coordinate", "y"},      Names{"z_coordinate", "z"},
    Names{"global_x", "x"},          Names{"global_y", "y"},
    Names{"global_z", "z"},          Names{"global_vx", "vx"},
    Names{"global_vy", "vy"},        Names{"global_vz", "vz"},
    Names{"global_rvx", "wx"},       Names{"global_rvy", "wy"},
    Names{"global_rvz", "wz"},       Names{"resultant_force", "resultant"},
    Names{"total_force", "force"},   Names{"x_moment", "mx"},
    Names{"y_moment", "my"},         Names{"z_moment", "mz"},
    Names{"x_centroid", "x"},        Names{"y_centroid", "y"},
    Names{"z_centroid", "z"},
};

constexpr std::array<std::string_view, 17> no_histories = {"time",
                                                           "cycle",
                                                           "nzc",
                                                           "ts_element",
                                                           "ts_eltype",
                                                           "ts_part",
                                                           "num_bad_shells",
                                                           "dt_cycle",
                                                           "time_per_zone_cycle",
                                                           "ids",
                                                           "brick_id",
                                                           "shell_id",
                                                           "mat",
                                                           "mtype",
                                                           "nip",
                                                           "iop",
                                                           "reached_the_minimum_time_step"};

template <std::size_t Count>
std::string_view find(const std::array<Names, Count>& names, std::string_view name) {
  for (const auto& [theirs, ours] : names)
    if (theirs == name) return ours;
  return {};
}

const Curve* find_curve(const CurveSet& set, const Curve& like, std::string_view quantity) {
  for (const Curve& curve : set.curves)
    if (curve.group == like.group && curve.item == like.item && curve.quantity == quantity) return &curve;
  return nullptr;
}

void add_sum(CurveSet& set, std::string_view name, std::string_view first,
             std::initializer_list<std::string_view> others) {
  std::vector<Curve> sums;
  for (const Curve& curve : set.curves) {
    if (curve.group != "glstat" || curve.quantity != first || find_curve(set, curve, name)) continue;
    Curve sum = curve;
    sum.quantity = name;
    sum.derived = true;
    for (const std::string_view other : others)
      if (const Curve* more = find_curve(set, curve, other); more != nullptr && !more->times.empty())
        for (std::size_t i = 0; i < sum.times.size(); ++i) sum.values[i] += value_at(*more, sum.times[i]);
    sums.push_back(std::move(sum));
  }
  for (Curve& sum : sums) set.curves.push_back(std::move(sum));
}

/// Size of the vector of three curves of one file.
void add_size(CurveSet& set, std::string_view group, std::string_view name,
              const std::array<std::string_view, 3>& components) {
  std::vector<Curve> sizes;
  for (const Curve& curve : set.curves) {
    if (curve.group != group || curve.quantity != components[0] || find_curve(set, curve, name)) continue;
    const Curve* second = find_curve(set, curve, components[1]);
    const Curve* third = find_curve(set, curve, components[2]);
    if (second == nullptr || third == nullptr || second->times.empty() || third->times.empty()) continue;
    Curve size = curve;
    size.quantity = name;
    size.derived = true;
    for (std::size_t i = 0; i < size.times.size(); ++i) {
      const double time = size.times[i];
      size.values[i] = std::hypot(curve.values[i], value_at(*second, time), value_at(*third, time));
    }
    sizes.push_back(std::move(size));
  }
  for (Curve& size : sizes) set.curves.push_back(std::move(size));
}

}  // namespace

std::string binout_spelling(std::string_view words) {
  std::string name;
  for (const char letter : words) {
    if (letter == '.' || std::isspace(static_cast<unsigned char>(letter)) != 0) {
      if (!name.empty() && name.back() != '_') name += '_';
    } else if (letter == '(') {
      break;
    } else {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

std::string from_ls_dyna(std::string_view group, std::string_view name) {
  if (std::find(no_histories.begin(), no_histories.end(), name) != no_histories.end()) return {};
  std::string_view ours;
  if (group == "glstat") ours = find(glstat_names, name);
  if (group == "matsum") ours = find(matsum_names, name);
  if (ours.empty() && group != "glstat" && group != "matsum") ours = find(common_names, name);
  return std::string(ours.empty() ? name : ours);
}

std::string kind_of(const Curve& curve) {
  const std::string& name = curve.quantity;
  const auto one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool three = name.size() == 2 && name[1] >= 'x' && name[1] <= 'z';
  if (curve.group == "glstat" &&
      !one_of({"dt", "ratio", "ratio_without_eroded", "added_mass", "percent_increase", "vx", "vy", "vz"}))
    return "glstat energy";
  if (curve.group == "matsum" &&
      one_of({"internal", "kinetic", "hourglass", "eroded_internal", "eroded_kinetic", "eroded_hourglass"}))
    return "matsum energy";
  if (name == "normal" || (three && name[0] == 'f')) return curve.group + " force";
  if (three) return curve.group + " " + name[0];
  if (name == "x" || name == "y" || name == "z") return curve.group + " place";
  if (name.ends_with("_momentum")) return curve.group + " momentum";
  return curve.group + " " + name;
}

void add_derived_curves(CurveSet& set) {
  add_sum(set, "sliding_interface", "contact", {"friction"});
  add_sum(set, "eroded", "eroded_internal", {"eroded_kinetic", "eroded_hourglass"});
  add_size(set, "rcforc", "resultant", {"fx", "fy", "fz"});
}

}  // namespace crumple::compare
