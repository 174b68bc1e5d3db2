// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/ascii_reader.hpp"

#include <gtest/gtest.h>

#include "compare/curve_lookup.hpp"

// Texts laid out as LS-DYNA's l2a writes them.

namespace crumple::compare::ascii_reader_test {
namespace {

using Numbers = std::vector<double>;

std::string glstat_block(const std::string& time, const std::string& internal) {
  return "\n\n dt of cycle      51 is controlled by shell           7 of part        1\n\n"
         " time........................... " +
         time +
         "\n time step......................   8.12345E-07\n"
         " kinetic energy.................   4.00000E+04\n"
         " internal energy................ " +
         internal +
         "\n stonewall energy...............   1.50000E+00 wall# 1\n"
         " stonewall energy...............   2.25000E+00 wall# 2\n"
         " spring and damper energy.......   1.00000E-20\n"
         " hourglass energy ..............   3.00000E+01\n"
         " system damping energy..........   0.00000E+00\n"
         " sliding interface energy.......  -5.00000E-01\n"
         " external work..................   7.00000E+00\n"
         " eroded kinetic energy..........   1.00000E+00\n"
         " eroded internal energy.........   2.00000E+00\n"
         " eroded hourglass energy........   0.00000E+00\n"
         " total energy...................   4.10000E+04\n"
         " total energy / initial energy..   9.99000E-01\n"
         " energy ratio w/o eroded energy.   9.98000E-01\n"
         " global x velocity..............   1.25000E+01\n"
         " global y velocity..............  -1.00000-120\n"
         " global z velocity..............   0.00000E+00\n"
         " time per zone cycle.(nanosec)..           120\n\n\n"
         " number of shell elements that  \n reached the minimum time step..    0\n\n\n"
         " added mass.....................   1.00000E-03\n"
         " percentage increase............   2.00000E-01\n";
}

TEST(ReadAscii, Glstat) {
  const auto curves = read_ascii(" a title\n    ls-dyna (version R11)     date 01/01/2020\n" +
                                     glstat_block("  0.00000E+00", "  1.00000E+02") +
                                     glstat_block("  1.00000E-04", " -2.00000E+02"),
                                 "glstat");
  const Curve internal = curve_named(curves, "glstat.internal");
  EXPECT_EQ(internal.times, (Numbers{0, 1e-4}));
  EXPECT_EQ(internal.values, (Numbers{100, -200}));
  EXPECT_EQ(curve_named(curves, "glstat.dt").values[0], 8.12345e-07);
  EXPECT_EQ(curve_named(curves, "glstat.rigidwall").values, (Numbers{3.75, 3.75}));
  EXPECT_EQ(curve_named(curves, "glstat.hourglass").values[1], 30);
  EXPECT_EQ(curve_named(curves, "glstat.sliding_interface").values[0], -0.5);
  EXPECT_EQ(curve_named(curves, "glstat.total").values[0], 41000);
  EXPECT_EQ(curve_named(curves, "glstat.ratio").values[0], 0.999);
  EXPECT_EQ(curve_named(curves, "glstat.ratio_without_eroded").values[0], 0.998);
  EXPECT_EQ(curve_named(curves, "glstat.eroded_internal").values[0], 2);
  EXPECT_EQ(curve_named(curves, "glstat.vy").values[0], -1e-120);
  EXPECT_EQ(curve_named(curves, "glstat.added_mass").values[0], 1e-3);
  for (const Curve& curve : curves) {
    EXPECT_EQ(curve.times.size(), 2U) << curve.quantity;
    EXPECT_EQ(curve.quantity.find("zone"), std::string::npos);
    EXPECT_EQ(curve.quantity.find("reached"), std::string::npos);
  }
}

TEST(ReadAscii, Matsum) {
  const std::string text =
      " a title\n\n{BEGIN LEGEND}\n Entity #        Title\n        1     beam\n\n{END LEGEND}\n\n\n"
      " time =   1.0000E-03\n"
      " mat.#=    1             inten=   2.0000E+00     kinen=   3.0000E+00     eroded_ie=   0.0000E+00     "
      "eroded_ke=   0.0000E+00\n"
      " x-mom=   4.0000E+00     y-mom=   5.0000E+00     z-mom=  -6.0000E+00\n"
      " x-rbv=   7.0000E+00     y-rbv=   8.0000E+00     z-rbv=   9.0000E+00\n"
      "                         hgeng=   1.5000E-01     +mass=   0.0000E+00\n"
      " mat.#=  123456          inten=   2.5000E+00     kinen=   3.5000E+00\n"
      " x-rbv=  -7.0000E+00     y-rbv=   8.0000E+00     z-rbv=   9.0000E+00\n\n\n"
      "       Maximum mass increase in shell elements      =   1.0000E-03 ID=      12\n"
      "\n\n time =   2.0000E-03\n"
      " mat.#=    1             inten=   2.2000E+00     kinen=   3.3000E+00\n";
  const auto curves = read_ascii(text, "matsum");
  EXPECT_EQ(curve_named(curves, "matsum.internal[1]").values, (Numbers{2, 2.2}));
  EXPECT_EQ(curve_named(curves, "matsum.internal[1]").times, (Numbers{1e-3, 2e-3}));
  EXPECT_EQ(curve_named(curves, "matsum.kinetic[123456]").values, (Numbers{3.5}));
  EXPECT_EQ(curve_named(curves, "matsum.hourglass[1]").values, (Numbers{0.15}));
  EXPECT_EQ(curve_named(curves, "matsum.z_momentum[1]").values, (Numbers{-6}));
  EXPECT_EQ(curve_named(curves, "matsum.vx[123456]").values, (Numbers{-7}));
  for (const Curve& curve : curves)
    EXPECT_TRUE(curve.item == "1" || curve.item == "123456") << name_of(curve);
}

TEST(ReadAscii, Rwforc) {
  const std::string text =
      " a title\n\n{BEGIN LEGEND}\n Entity #        Title\n        1     wall\n\n{END LEGEND}\n\n\n"
      "    time       wall#   normal-force    x-force        y-force        z-force\n"
      " 0.00000E+00      12   0.000000E+00   0.000000E+00   0.000000E+00   0.000000E+00\n"
      "                seg#    \n"
      "                   1                  1.000000E+00   2.000000E+00   3.000000E+00\n"
      "  total force                         1.000000E+00   2.000000E+00   3.000000E+00\n"
      " 1.00000E-03      12   5.000000E+04  -5.000000E+04   1.000000E+00   2.000000E+00\n"
      "r i g i d   w a l l   n o d e   s e t   f o r c e   s u m m a t i o n s\n"
      " 1.00000E-03      12         1  9.9E+00  9.9E+00  9.9E+00\n";
  const auto curves = read_ascii(text, "rwforc");
  EXPECT_EQ(curve_named(curves, "rwforc.normal[12]").values, (Numbers{0, 50000}));
  EXPECT_EQ(curve_named(curves, "rwforc.fx[12]").times, (Numbers{0, 1e-3}));
  EXPECT_EQ(curve_named(curves, "rwforc.fx[12]").values, (Numbers{0, -50000}));
  EXPECT_EQ(curves.size(), 4U);
}

TEST(ReadAscii, Rcforc) {
  const std::string text =
      " a title\n interface number,           2, is single surface\n\n"
      "  slave            1 time 1.00000E-03  x  1.00000E+00  y  2.00000E+00  z -3.00000E+00 mass  "
      "4.00000E+00\n"
      "  master           1 time 1.00000E-03  x -1.00000E+00  y -2.00000E+00  z  3.00000E+00 mass  "
      "5.00000E+00\n"
      "  SURFA            2 time 1.00000E-03  x  7.00000E+00  y  0.00000E+00  z  0.00000E+00 mass  "
      "0.00000E+00  "
      "mx  0.0  my  0.0  mz  0.0\n";
  const auto curves = read_ascii(text, "rcforc");
  EXPECT_EQ(curve_named(curves, "rcforc.fz[1 first]").values, (Numbers{-3}));
  EXPECT_EQ(curve_named(curves, "rcforc.fx[1 second]").values, (Numbers{-1}));
  EXPECT_EQ(curve_named(curves, "rcforc.mass[1 second]").values, (Numbers{5}));
  EXPECT_EQ(curve_named(curves, "rcforc.fx[2 single]").values, (Numbers{7}));
}

TEST(ReadAscii, Nodout) {
  const std::string head = "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p      51";
  const std::string text = " a title\n" + head +
                           "                              ( at time 1.00000E-03 )\n"
                           "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel "
                           "     x-accl      y-accl      "
                           "z-accl      x-coor      y-coor      z-coor\n"
                           "        7   1.0000E-01 -2.0000E-01  0.0000E+00  1.0000E+00  2.0000E+00  "
                           "3.0000E+00-1.0000E+04  0.0000E+00  "
                           "0.0000E+00  1.1000E+00  1.8000E+00  3.0000E+00\n" +
                           head +
                           "                              ( at time 1.00000E-03 )\n"
                           "\n nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot "
                           "vel   x-rot acc   y-rot acc   "
                           "z-rot acc\n"
                           "        7   5.0000E-02  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  "
                           "0.0000E+00  0.0000E+00  0.0000E+00  "
                           "0.0000E+00\n" +
                           head +
                           "                              ( at time 2.00000E-03 )\n"
                           "\n nodal point  x-disp     y-disp      z-disp      x-vel ...\n"
                           "        7   1.5000E-01 -2.0000E-01  0.0000E+00  1.0000E+00  2.0000E+00  "
                           "3.0000E+00  0.0000E+00  0.0000E+00  "
                           "0.0000E+00  1.1500E+00  1.8000E+00  3.0000E+00\n";
  const auto curves = read_ascii(text, "nodout");
  EXPECT_EQ(curve_named(curves, "nodout.ux[7]").times, (Numbers{1e-3, 2e-3}));
  EXPECT_EQ(curve_named(curves, "nodout.ux[7]").values, (Numbers{0.1, 0.15}));
  EXPECT_EQ(curve_named(curves, "nodout.ax[7]").values, (Numbers{-1e4, 0}));
  EXPECT_EQ(curve_named(curves, "nodout.x[7]").values, (Numbers{1.1, 1.15}));
  EXPECT_EQ(curve_named(curves, "nodout.rx_displacement[7]").values, (Numbers{0.05}));
}

TEST(ReadAscii, OtherTextGivesNothing) {
  for (const std::string_view name : ascii_files()) {
    EXPECT_TRUE(read_ascii("", name).empty()) << name;
    EXPECT_TRUE(read_ascii("*KEYWORD\n*NODE\n 1, 0.0, 0.0, 0.0\n....\n . 5\n=\n= 3\n", name).empty()) << name;
  }
}

}  // namespace
}  // namespace crumple::compare::ascii_reader_test
