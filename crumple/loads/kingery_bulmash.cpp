// SPDX-License-Identifier: BSD-3-Clause
#include "loads/kingery_bulmash.hpp"

#include <array>
#include <limits>

#include "math/power.hpp"

namespace crumple::loads {
namespace {

/// log10 of a quantity as a polynomial in u = offset + slope log10 Z, up to an end of log10 Z.
struct FitPiece {
  double end;
  double offset;
  double slope;
  std::array<double, 12> coefficient;  ///< of 1, u, u^2, ...
};

/// Up to three pieces one behind the other; those left over have no end of their own.
using Fit = std::array<FitPiece, 3>;

constexpr double everywhere = std::numeric_limits<double>::infinity();

struct Fits {
  Fit incident_pressure;
  Fit reflected_pressure;
  Fit arrival;
  Fit duration;
  Fit incident_impulse;
  Fit reflected_impulse;
};

constexpr Fits surface_burst{
    .incident_pressure = {{{everywhere,
                            -0.756579301809,
                            1.35034249993,
                            {1.9422502013, -1.6958988741, -0.154159376846, 0.514060730593, 0.0988534365274,
                             -0.293912623038, -0.0268112345019, 0.109097496421, 0.00162846756311,
                             -0.0214631030242, 0.0001456723382, 0.00167847752266}}}},
    .reflected_pressure = {{{everywhere,
                             -0.789312405513,
                             1.36637719229,
                             {2.56431321138, -2.21030870597, -0.218536586295, 0.895319589372, 0.24989009775,
                              -0.569249436807, -0.11791682383, 0.224131161411, 0.0245620259375,
                              -0.0455116002694, -0.00190930738887, 0.00361471193389}}}},
    .arrival = {{{everywhere,
                  -0.755684472698,
                  1.37784223635,
                  {-0.173607601251, 1.35706496258, 0.052492798645, -0.196563954086, -0.0601770052288,
                   0.0696360270891, 0.0215297490092, -0.0161658930785, -0.00232531970294,
                   0.00147752067524}}}},
    .duration = {{{0.4048337,
                   -0.1790217052,
                   5.25099193925,
                   {-0.728671776005, 0.130143717675, 0.134872511954, 0.0391574276906, -0.00475933664702,
                    -0.00428144598008}},
                  {0.845098,
                   -5.85909812338,
                   9.2996288611,
                   {0.20096507334, -0.0297944268976, 0.030632954288, 0.0183405574086, -0.0173964666211,
                    -0.00106321963633, 0.00562060030977, 0.0001618217499, -0.0006860188944}},
                  {everywhere,
                   -4.92699491141,
                   3.46349745571,
                   {0.572462469964, 0.0933035304009, -0.0005849420883, -0.00226884995013, -0.00295908591505,
                    0.00148029868929}}}},
    .incident_impulse = {{{0.382017,
                           0.832468843425,
                           3.0760329666,
                           {1.57159240621, -0.502992763686, 0.171335645235, 0.0450176963051,
                            -0.0118964626402}},
                          {everywhere,
                           -2.91358616806,
                           2.40697745406,
                           {0.719852655584, -0.384519026965, -0.0260816706301, 0.00595798753822,
                            0.014544526107, -0.00663289334734, -0.00284189327204, 0.0013644816227}}}},
    .reflected_impulse = {{{everywhere,
                            -0.781951689212,
                            1.33422049854,
                            {1.75291677799, -0.949516092853, 0.112136118689, -0.0250659183287}}}},
};

constexpr Fits air_burst{
    .incident_pressure = {{{everywhere,
                            -0.756579301809,
                            1.35034249993,
                            {1.77284970457, -1.69012801396, 0.00804973591951, 0.336743114941,
                             -0.00516226351334, -0.0809228619888, -0.00478507266747, 0.00793030472242,
                             0.0007684469735}}}},
    .reflected_pressure = {{{everywhere,
                             -0.756579301809,
                             1.35034249993,
                             {2.39106134946, -2.21400538997, 0.035119031446, 0.657599992109, 0.0141818951887,
                              -0.243076636231, -0.0158699803158, 0.0492741184234, 0.00227639644004,
                              -0.00397126276058}}}},
    .arrival = {{{everywhere,
                  -0.80501734056,
                  1.37407043777,
                  {-0.0423733936826, 1.36456871214, -0.0570035692784, -0.182832224796, 0.0118851436014,
                   0.0432648687627, -0.0007997367834, -0.00436073555033}}}},
    .duration = {{{0.350248,
                   0.209440059933,
                   5.11588554305,
                   {-0.801052722864, 0.164953518069, 0.127788499497, 0.00291430135946, 0.00187957449227,
                    0.0173413962543, 0.00269739758043, -0.00361976502798, -0.00100926577934}},
                  {0.7596678,
                   -5.06778493835,
                   9.2996288611,
                   {0.115874238335, -0.0297944268969, 0.0306329542941, 0.018340557407, -0.0173964666286,
                    -0.00106321963576, 0.0056206003128, 0.0001618217499, -0.0006860188944}},
                  {everywhere,
                   -4.39590184126,
                   3.1524725364,
                   {0.50659210403, 0.0967031995552, -0.00801302059667, 0.00482705779732, 0.00187587272287,
                    -0.00246738509321, -0.000841116668, 0.0006193291052}}}},
    .incident_impulse =
        {{{0.30103,
           1.04504877747,
           3.24299066475,
           {1.43534136453, -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824}},
          {everywhere,
           -2.67912519532,
           2.30629231803,
           {0.599008468099, -0.40463292088, -0.0142721946082, 0.00912366316617, -0.0006750681404,
            -0.00800863718901, 0.00314819515931, 0.00152044783382, -0.0007470265899}}}},
    .reflected_impulse = {{{everywhere,
                            -0.757659920369,
                            1.37882996018,
                            {1.60579280091, -0.903118886091, 0.101771877942, -0.0242139751146}}}},
};

double evaluate(const Fit& fit, double log_distance) {
  std::size_t k = 0;
  while (log_distance > fit[k].end) ++k;
  const FitPiece& piece = fit[k];
  const double u = piece.offset + piece.slope * log_distance;
  double sum = 0;
  for (std::size_t i = piece.coefficient.size(); i-- > 0;) sum = sum * u + piece.coefficient[i];
  constexpr double binary_log_of_ten = 3.321928094887362;
  return math::power_of_two(sum * binary_log_of_ten);
}

/// The impulse of a pulse over its peak and duration, with its derivative by the decay.
struct PulseImpulse {
  double value = 0;
  double slope = 0;
};

PulseImpulse pulse_impulse(double b) {
  if (b * b < 0.25) {  // differences would lose digits: the sum of (-b)^n / (n + 2)!
    PulseImpulse sum;
    double term = 0.5;
    for (int n = 0; n < 14; ++n) {
      sum.value += term;
      const double next = -term / (n + 3);  // without the factor b
      sum.slope += (n + 1) * next;
      term = next * b;
    }
    return sum;
  }
  constexpr double binary_log_of_e = 1.4426950408889634;
  const double exponential = math::power_of_two(-b * binary_log_of_e);
  return {(b - 1 + exponential) / (b * b), (2 - b - (2 + b) * exponential) / (b * b * b)};
}

}  // namespace

ScaledWave scaled_wave(model::AirBlast::Burst burst, double scaled_distance) {
  constexpr double log10_of_two = 0.3010299956639812;
  const double log_distance = log10_of_two * math::binary_log(scaled_distance);
  const Fits& fits = burst == model::AirBlast::Burst::Surface ? surface_burst : air_burst;
  return {.incident_pressure = evaluate(fits.incident_pressure, log_distance),
          .reflected_pressure = evaluate(fits.reflected_pressure, log_distance),
          .arrival = evaluate(fits.arrival, log_distance),
          .duration = evaluate(fits.duration, log_distance),
          .incident_impulse = evaluate(fits.incident_impulse, log_distance),
          .reflected_impulse = evaluate(fits.reflected_impulse, log_distance)};
}

double friedlander_decay(double pressure_times_duration_over_impulse) {
  const double wanted = 1 / pressure_times_duration_over_impulse;
  // Newton's method: the impulse falls with b and is convex, so that from the second step on b only grows.
  double b = pressure_times_duration_over_impulse - 2;
  for (int step = 0; step < 40; ++step) {
    const PulseImpulse pulse = pulse_impulse(b);
    const double change = (pulse.value - wanted) / pulse.slope;
    b -= change;
    if (change * change <= 1e-28 * (1 + b * b)) break;
  }
  return b;
}

}  // namespace crumple::loads
