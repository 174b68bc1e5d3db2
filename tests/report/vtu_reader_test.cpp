// SPDX-License-Identifier: BSD-3-Clause
#include "report/vtu_reader.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.hpp"
#include "output/paraview/vtu_file.hpp"

namespace crumple::report::vtu_reader_test {
namespace {

using Section = VtuReader::Section;

/// Three points and a triangle, with a field of each kind of number.
std::string sample_text() {
  output::VtuPacker packer;
  const auto position = packer.array<float>("position", 3, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 2, 0});
  const auto connectivity = packer.array<std::int32_t>("connectivity", 1, std::vector<std::int32_t>{0, 1, 2});
  const auto offsets = packer.array<std::int32_t>("offsets", 1, std::vector<std::int32_t>{3});
  const auto types = packer.array<std::uint8_t>("types", 1, std::vector<std::uint8_t>{5});
  const auto id = packer.array<std::int64_t>("node_id", 1, std::vector<std::int64_t>{7, 5000000000, -1});
  const auto strain = packer.array<float>("plastic_strain", 1, std::vector<float>{0.25F});
  output::VtuGrid grid;
  grid.time = 0.125;
  grid.points = 3;
  grid.cells = 1;
  grid.positions = {&position};
  grid.topology = {&connectivity, &offsets, &types};
  grid.point_data = {&id};
  grid.cell_data = {&strain};
  return output::vtu_text(grid);
}

class VtuReaderTest : public ::testing::Test {
 public:
  ~VtuReaderTest() override { std::filesystem::remove(file_); }

 protected:
  VtuReaderTest()
      : file_(std::filesystem::path(::testing::TempDir()) /
              ("crumple_reader_" + std::to_string(getpid()) + ".vtu")) {}

  VtuReader read(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return VtuReader(file_);
  }
  std::string complaint(const std::string& text, const std::string& array = "") const {
    try {
      const VtuReader reader = read(text);
      if (!array.empty()) reader.reals(Section::Points, array, 3);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "none";
  }

  std::filesystem::path file_;
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST_F(VtuReaderTest, ReadsWhatTheWriterWrote) {
  const VtuReader reader = read(sample_text());
  EXPECT_EQ(reader.time(), 0.125);
  EXPECT_EQ(reader.points(), 3);
  EXPECT_EQ(reader.cells(), 1);
  EXPECT_EQ(reader.reals(Section::Points, "position", 3), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 2, 0}));
  EXPECT_EQ(reader.integers(Section::PointData, "node_id"), (std::vector<std::int64_t>{7, 5000000000, -1}));
  EXPECT_EQ(reader.integers(Section::Cells, "types"), (std::vector<std::int64_t>{5}));
  EXPECT_EQ(reader.reals(Section::CellData, "plastic_strain", 1), (std::vector<float>{0.25F}));
  EXPECT_NE(reader.find(Section::CellData, "plastic_strain"), nullptr);
  EXPECT_EQ(reader.find(Section::PointData, "plastic_strain"), nullptr);
}

TEST_F(VtuReaderTest, ReadsArraysOfSeveralBlocks) {
  output::VtuPacker packer;
  std::vector<float> values(300000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 1000);
  const auto position = packer.array<float>("position", 3, values);
  output::VtuGrid grid;
  grid.points = 100000;
  grid.positions = {&position};
  EXPECT_EQ(read(output::vtu_text(grid)).reals(Section::Points, "position", 3), values);
}

TEST_F(VtuReaderTest, RefusesFilesThatAreNotOurs) {
  const std::string text = sample_text();
  EXPECT_NE(complaint("no VTK file at all").find("no appended raw data"), std::string::npos);
  EXPECT_NE(complaint(replaced(text, "UInt64", "UInt32")).find("not a file of this program"),
            std::string::npos);
  EXPECT_NE(complaint(replaced(text, "vtkZLibDataCompressor", "vtkLZ4DataCompressor")).find("not a file"),
            std::string::npos);
  EXPECT_NE(complaint(replaced(text, "\"3\" NumberOfCells", "\"x\" NumberOfCells")).find("piece"),
            std::string::npos);
  EXPECT_NE(complaint(replaced(text, "type=\"Float32\"", "type=\"Float99\"")).find("not understood"),
            std::string::npos);
}

TEST_F(VtuReaderTest, RefusesDataThatDoesNotFit) {
  const std::string text = sample_text();
  EXPECT_NE(complaint(text, "speed").find("no array speed"), std::string::npos);
  EXPECT_NE(complaint(replaced(text, "NumberOfPoints=\"3\"", "NumberOfPoints=\"4\""), "position")
                .find("for 4 points"),
            std::string::npos);
  // A flipped bit in a stream of zlib.
  std::string damaged = text;
  const VtuReader reader = read(text);
  const auto offset = reader.find(Section::Points, "position")->offset;
  const std::size_t start = damaged.find('_', damaged.find("<AppendedData")) + 1;
  damaged[start + offset + 32 + 6] = static_cast<char>(damaged[start + offset + 32 + 6] ^ 0x55);
  EXPECT_NE(complaint(damaged, "position").find("does not unpack"), std::string::npos);
  EXPECT_NE(complaint(text.substr(0, start + offset + 30), "position").find("cut off"), std::string::npos);
  // Sizes that no file can hold.
  std::string wild = text;
  for (std::size_t i = 0; i < 8; ++i) wild[start + offset + i] = '\x7f';
  EXPECT_NE(complaint(wild, "position").find("wrong header"), std::string::npos);
}

TEST_F(VtuReaderTest, NamesAFileThatIsNotThere) {
  try {
    const VtuReader reader("no_such_folder/frame.vtu");
    FAIL();
  } catch (const Error& fault) {
    EXPECT_NE(std::string(fault.what()).find("no_such_folder/frame.vtu"), std::string::npos);
  }
}

}  // namespace
}  // namespace crumple::report::vtu_reader_test
