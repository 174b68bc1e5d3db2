// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/csv_reader.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "compare/curve_lookup.hpp"
#include "compare/curves/quantity_names.hpp"

namespace crumple::compare::csv_reader_test {
namespace {

using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

TEST(ReadCsv, OneRowPerTime) {
  const auto curves = read_csv("time,dt,kinetic\n0,1e-6,5\n0.5,2e-6,4.5\n", "glstat");
  EXPECT_EQ(names_of(curves), (Names{"glstat.dt", "glstat.kinetic"}));
  EXPECT_EQ(curves[1].times, (Numbers{0, 0.5}));
  EXPECT_EQ(curves[1].values, (Numbers{5, 4.5}));
}

TEST(ReadCsv, ItemsHaveCurvesOfTheirOwn) {
  const auto curves =
      read_csv("time,interface,side,fx\n0,3,first,1\n0,3,second,-1\n1,3,first,2\n1,3,second,-2\n", "rcforc");
  EXPECT_EQ(names_of(curves), (Names{"rcforc.fx[3 first]", "rcforc.fx[3 second]"}));
  EXPECT_EQ(curves[1].values, (Numbers{-1, -2}));
}

TEST(ReadCsv, SectionsAndPointsHaveCurvesOfTheirOwn) {
  const auto sections = read_csv("time,section,fx\n0,17,1\n0,18,2\n1,17,3\n1,18,4\n", "secforc");
  EXPECT_EQ(names_of(sections), (Names{"secforc.fx[17]", "secforc.fx[18]"}));
  EXPECT_EQ(sections[1].values, (Numbers{2, 4}));
  const auto points = read_csv("time,element,plane,point,xx\n0,5,1,1,7\n0,5,1,2,8\n", "elout_shells");
  EXPECT_EQ(names_of(points), (Names{"elout_shells.xx[5 1 1]", "elout_shells.xx[5 1 2]"}));
}

TEST(ReadCsv, ARowThatIsCutOffIsLeftOut) {
  const auto curves = read_csv("time,part,kinetic,internal\r\n0,1,5,6\r\n1,1,7,\r\n2,1,8", "matsum");
  EXPECT_EQ(curve_named(curves, "matsum.kinetic[1]").values, (Numbers{5, 7}));
  EXPECT_EQ(curve_named(curves, "matsum.internal[1]").values, (Numbers{6}));
}

TEST(ReadCsv, OtherTablesAreReadByTheirNames) {
  const auto curves = read_csv("\xEF\xBB\xBFTime, \"force, filtered\" ,depth\n0,1,2\n1,3,4\n", "test");
  EXPECT_EQ(names_of(curves), (Names{"test.force, filtered", "test.depth"}));
}

TEST(ReadCsv, WhatIsNoTableOverTimeIsRefused) {
  EXPECT_THROW(read_csv("node,x\n1,2\n", "mesh"), Error);
  EXPECT_THROW(read_csv("", "empty"), Error);
  EXPECT_THROW(read_csv("time\n1\n", "alone"), Error);
}

// The header as OpenRadioss's th_to_csv writes it, with one part and one rigid wall.
TEST(ReadCsv, TimeHistoriesOfOpenRadioss) {
  const std::string head =
      "\"time\",\"INTERNAL ENERGY\",\"KINETIC ENERGY\",\"X-MOMENTUM\",\"Y-MOMENTUM\",\"Z-MOMENTUM\",\"MASS\","
      "\"TIME STEP\",\"ROTATION ENERGY\",\"EXTERNAL WORK\",\"SPRING ENERGY\",\"CONTACT ENERGY\",\"HOURGLASS "
      "ENERGY\",\"beam                IE \",\"wall           1    wall      FNX        \"\n";
  const auto curves = read_csv(
      head + "0,0,10,1,2,3,4,1e-4,1,0,0,0,0,0,0\n1,5,4,1,2,3,4,1e-4,2,0.5,0,0.25,0.125,5,77\n", "mainT01");
  EXPECT_EQ(curve_named(curves, "glstat.internal").values, (Numbers{0, 5}));
  EXPECT_EQ(curve_named(curves, "glstat.kinetic").values, (Numbers{11, 6}));
  EXPECT_EQ(curve_named(curves, "glstat.sliding_interface").values, (Numbers{0, 0.25}));
  EXPECT_EQ(curve_named(curves, "glstat.hourglass").values, (Numbers{0, 0.125}));
  EXPECT_EQ(curve_named(curves, "th.beam IE").values, (Numbers{0, 5}));
  EXPECT_EQ(curve_named(curves, "th.wall 1 wall FNX").values, (Numbers{0, 77}));
}

TEST(DerivedCurves, AreSumsThatOthersWriteAsOne) {
  CurveSet set;
  set.curves = read_csv("time,contact,friction,eroded\n0,1,2,3\n1,10,20,30\n", "glstat");
  add_derived_curves(set);
  EXPECT_EQ(names_of(set.curves),
            (Names{"glstat.contact", "glstat.friction", "glstat.eroded", "glstat.sliding_interface"}));
  EXPECT_EQ(set.curves[3].values, (Numbers{3, 30}));
  EXPECT_TRUE(set.curves[3].derived);
}

TEST(DerivedCurves, HaveTheSizeOfForcesOnInterfaces) {
  CurveSet set;
  set.curves = read_csv("time,interface,side,fx,fy,fz\n0,2,first,2,3,6\n0,2,second,-2,-3,-6\n", "rcforc");
  add_derived_curves(set);
  EXPECT_EQ(curve_named(set.curves, "rcforc.resultant[2 first]").values, (Numbers{7}));
  EXPECT_EQ(curve_named(set.curves, "rcforc.resultant[2 second]").values, (Numbers{7}));
  EXPECT_EQ(set.curves.size(), 8U);
}

}  // namespace
}  // namespace crumple::compare::csv_reader_test
