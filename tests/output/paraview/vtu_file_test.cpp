// SPDX-License-Identifier: BSD-3-Clause
#include "output/paraview/vtu_file.hpp"

#include <gtest/gtest.h>

#include "output/vtu_reader.hpp"

namespace crumple::output::vtu_file_test {
namespace {

std::vector<float> ramp(std::size_t count) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(i) * 0.5F - 7;
  return values;
}

/// A grid of `count` points without cells whose only field is a ramp.
std::string text_with(std::size_t count) {
  const std::vector<float> values = ramp(count);
  const std::vector<float> places(3 * count);
  VtuPacker packer;
  const VtuArray field = packer.array<float>("field", 1, values);
  const VtuArray position = packer.array<float>("position", 3, places);
  const VtuArray nothing = packer.array<std::int32_t>("connectivity", 1, {});
  VtuGrid grid;
  grid.time = 0.1;
  grid.points = static_cast<Index>(count);
  grid.positions = {&position};
  grid.topology = {&nothing};
  grid.point_data = {&field};
  return vtu_text(grid);
}

class VtuSizes : public ::testing::TestWithParam<std::size_t> {};

TEST_P(VtuSizes, ArraysReadBackWhateverTheNumberOfBlocks) {
  const VtuReader reader(text_with(GetParam()));
  EXPECT_EQ(reader["field"].type, "Float32");
  EXPECT_EQ(reader["field"].values<float>(), ramp(GetParam()));
  EXPECT_EQ(reader["position"].components, 3);
  EXPECT_EQ(reader["position"].values<float>().size(), 3 * GetParam());
}

// A block is 65536 floats: none, part of one, exactly one, one and a bit, exactly two.
INSTANTIATE_TEST_SUITE_P(Blocks, VtuSizes, ::testing::Values(0, 1, 65535, 65536, 65537, 131072));

TEST(VtuFile, SaysWhatReadersNeedToKnow) {
  const std::string text = text_with(2);
  EXPECT_NE(text.find("header_type=\"UInt64\""), std::string::npos);
  EXPECT_NE(text.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
  EXPECT_NE(text.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.1<"), std::string::npos);
  EXPECT_NE(text.find("NumberOfPoints=\"2\" NumberOfCells=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace crumple::output::vtu_file_test
