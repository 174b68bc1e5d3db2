// SPDX-License-Identifier: BSD-3-Clause
// Axes of the material that single shells have (MCID).
#include <cmath>
#include <numbers>
#include <type_traits>
#include <variant>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

using model::OrthotropicElastic;

/// The law of a shell as far as it has axes in the sheet, or null.
const OrthotropicElastic* sheet_of(const model::ConstitutiveLaw& law) {
  return std::visit(
      [](const auto& given) -> const OrthotropicElastic* {
        using Law = std::decay_t<decltype(given)>;
        if constexpr (std::is_base_of_v<OrthotropicElastic, Law>) return &given;
        if constexpr (std::is_same_v<Law, model::Fabric>) return &given.sheet;
        if constexpr (std::is_same_v<Law, model::SheetPlasticity>) return &given.axes;
        return nullptr;
      },
      law);
}

/// Angle about the shell's normal from its first side to a direction, both in its plane; absent where the
/// direction is along the normal.
std::optional<double> angle_to(const Build& build, const std::array<Index, 4>& node,
                               const Vector& direction) {
  const auto x = [&](std::size_t k) { return build.model.nodes.position[static_cast<std::size_t>(node[k])]; };
  const Vector normal = cross(difference(x(2), x(0)), difference(x(3), x(1)));
  const double size = length_of(normal);
  const auto flat = [&](const Vector& a) {
    Vector in_plane{};
    for (std::size_t i = 0; i < 3; ++i) in_plane[i] = a[i] - dot(a, normal) / (size * size) * normal[i];
    return in_plane;
  };
  const Vector side = flat(difference(x(1), x(0)));
  const Vector wanted = flat(direction);
  constexpr double along_normal = 1e-6;
  if (!(length_of(wanted) > along_normal)) return std::nullopt;
  return std::atan2(dot(normal, cross(side, wanted)) / size, dot(side, wanted));
}

}  // namespace

bool turn_to_system(Build& build, const RawShell& raw, model::ShellElement& shell) {
  const auto axes = find_axes(build, raw.material_system, "MCID", raw.where);
  if (!axes) return false;
  const model::Part& part = build.model.parts[static_cast<std::size_t>(shell.part)];
  const bool is_layered = part.layup != no_index || shell.layup != no_index;
  const OrthotropicElastic* const sheet =
      part.material == no_index || is_layered
          ? nullptr
          : sheet_of(build.model.materials[static_cast<std::size_t>(part.material)].law);
  if (sheet == nullptr && !is_layered) return true;  // the same in all directions
  const std::string read = std::to_string(raw.material_system);
  if (is_layered || sheet->axes != OrthotropicElastic::Axes::Side) {
    build.report.field_unsupported(
        raw.where, {"MCID", read, "0, or a material with AOPT = 0 that is no layer",
                    "the material's own axes are used elsewhere, and BETA of *ELEMENT_SHELL_BETA", "axes"});
    return build.report.allow_unsupported();
  }
  const std::optional<double> angle = angle_to(build, shell.node, (*axes)[0]);
  if (!angle) {
    build.report.field_error(raw.where, {"MCID", read, "a system whose x axis is not along the normal",
                                         "the axis is projected onto the shell", "axes"});
    return false;
  }
  // Zero would be the material's own angle.
  shell.material_angle = *angle == 0 ? 2 * std::numbers::pi : *angle;
  return true;
}

}  // namespace crumple::deck
