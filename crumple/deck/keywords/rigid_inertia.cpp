// SPDX-License-Identifier: BSD-3-Clause
#include "deck/keywords/rigid_inertia.hpp"

#include "deck/format/vector.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field centre_card[] = {
    point(real("XC")),
    point(real("YC")),
    point(real("ZC")),
    real("TM", 0, above_zero),
    integer("IRCS", 0, within(0, 1, "0 is global axes, 1 local ones")),
    reference("NODEID"),
};

constexpr Field tensor_card[] = {
    fixed(real("IXX", 0, above_zero)), fixed(real("IXY")), fixed(real("IXZ")),
    fixed(real("IYY", 0, above_zero)), fixed(real("IYZ")), fixed(real("IZZ", 0, above_zero))};

constexpr Field velocity_card[] = {velocity(real("VTX")), velocity(real("VTY")), velocity(real("VTZ")),
                                   spin(real("VRX")),     spin(real("VRY")),     spin(real("VRZ"))};

constexpr Field axes_card[] = {
    direction(real("XL")),
    direction(real("YL")),
    direction(real("ZL")),
    direction(real("XLIP")),
    direction(real("YLIP")),
    direction(real("ZLIP")),
    only("CID", {0}, "give the local axes by XL to ZLIP"),
};

/// The tensor in global axes, given in axes whose first is `first` and whose plane has `other`.
void turn_tensor(const Card& card, model::RigidInertia& inertia, Report& report) {
  const auto axes = local_axes({card.real("XL"), card.real("YL"), card.real("ZL")},
                               {card.real("XLIP"), card.real("YLIP"), card.real("ZLIP")});
  if (!axes) {
    report.field_error(card.where(), {"XL", std::string(card.text("XL")), "two vectors that span a plane",
                                      "IRCS is 1: XL, YL, ZL is the local x axis, XLIP, YLIP, ZLIP lies in "
                                      "the local xy plane",
                                      "axes"});
    return;
  }
  const auto& t = inertia.tensor;
  const std::array<Vector, 3> local = {Vector{t[0], t[1], t[2]}, Vector{t[1], t[3], t[4]},
                                       Vector{t[2], t[4], t[5]}};
  const auto global = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) sum += (*axes)[a][i] * local[a][b] * (*axes)[b][j];
    return sum;
  };
  inertia.tensor = {global(0, 0), global(0, 1), global(0, 2), global(1, 1), global(1, 2), global(2, 2)};
}

/// A tensor of inertia is that of some masses: it is positive, and no moment exceeds the sum of the others.
void check_tensor(const Card& card, const model::RigidInertia& inertia, Report& report) {
  const auto& t = inertia.tensor;
  const double second = t[0] * t[3] - t[1] * t[1];
  const double determinant = t[0] * (t[3] * t[5] - t[4] * t[4]) - t[1] * (t[1] * t[5] - t[4] * t[2]) +
                             t[2] * (t[1] * t[4] - t[3] * t[2]);
  if (!(t[0] > 0 && second > 0 && determinant > 0))
    report.field_error(card.where(), {"IXX", std::string(card.text("IXX")), "a positive definite tensor",
                                      "its principal moments must be above zero", "tensor"});
}

}  // namespace

RawInertia read_inertia(Cards& cards) {
  RawInertia raw;
  model::RigidInertia& inertia = raw.inertia;
  const Card centre = cards.next(centre_card);
  const Card tensor = cards.next(tensor_card);
  const Card velocity = cards.next(velocity_card);
  raw.where = centre.where();
  raw.centre_node = centre.integer("NODEID");
  inertia.mass = centre.real("TM");
  inertia.centre = {centre.real("XC"), centre.real("YC"), centre.real("ZC")};
  inertia.tensor = {tensor.real("IXX"), tensor.real("IXY"), tensor.real("IXZ"),
                    tensor.real("IYY"), tensor.real("IYZ"), tensor.real("IZZ")};
  inertia.velocity = {velocity.real("VTX"), velocity.real("VTY"), velocity.real("VTZ")};
  inertia.angular_velocity = {velocity.real("VRX"), velocity.real("VRY"), velocity.real("VRZ")};
  if (centre.integer("IRCS") == 1) {
    const Card axes = cards.next(axes_card);
    turn_tensor(axes, inertia, cards.report());
  }
  if (tensor.good("IXX") && tensor.good("IYY") && tensor.good("IZZ"))
    check_tensor(tensor, inertia, cards.report());
  return raw;
}

}  // namespace crumple::deck
