// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/binout_reader.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "compare/binout_sample.hpp"
#include "compare/curve_lookup.hpp"

namespace crumple::compare::binout_reader_test {
namespace {

using Numbers = std::vector<double>;
using Type = BinoutSample::Type;

void write_glstat(BinoutSample& sample, int state, double time) {
  sample.folder("/glstat/d00000" + std::to_string(state));
  sample.write("time", Type::R4, {time});
  sample.write("cycle", Type::I4, {100.0 * state});
  sample.write("kinetic_energy", Type::R4, {50.0 - state});
  sample.write("stonewall_energy", Type::R4, {1, 2.5});
}

void write_others(BinoutSample& sample, int state, double time) {
  const std::string folder = "/d00000" + std::to_string(state);
  sample.folder("/rwforc/forces" + folder);
  sample.write("time", Type::R8, {time});
  sample.write("normal_force", Type::R8, {10.0 * state, 20.0 * state});
  sample.folder("/rcforc" + folder);
  sample.write("time", Type::R8, {time});
  sample.write("x_force", Type::R8, {1.0 * state, -1.0 * state});
  sample.folder("/nodout" + folder);
  sample.write("time", Type::R8, {time});
  sample.write("x_displacement", Type::R4, {0.5, 0.25, 0.125});
}

/// Two states of four folders and their metadata, a symbol table after each state.
std::string sample_bytes(std::size_t width = 8, bool little_endian = true) {
  BinoutSample sample(width, little_endian);
  sample.folder("/glstat/metadata");
  sample.write("title", Type::I1, {'t', 'e', 's', 't'});
  sample.folder("/rwforc/forces/metadata");
  sample.write("ids", Type::I4, {1, 2});
  sample.write("setid", Type::I4, {12, 13});
  sample.folder("/rcforc/metadata");
  sample.write("ids", Type::I4, {3, 3});
  sample.write("side", Type::I4, {0, 1});
  sample.folder("/nodout/metadata");
  sample.write("ids", Type::I8, {7, 8, 9000000000.0});
  for (const int state : {1, 2}) {
    write_glstat(sample, state, 0.5 * state);
    write_others(sample, state, 0.5 * state);
    sample.table();
  }
  return sample.bytes();
}

std::vector<Curve> read(const std::string& bytes) {
  return read_binout({LsdaFile(bytes)});
}

void expect_sample(const std::vector<Curve>& curves) {
  EXPECT_EQ(curve_named(curves, "glstat.kinetic").times, (Numbers{0.5, 1}));
  EXPECT_EQ(curve_named(curves, "glstat.kinetic").values, (Numbers{49, 48}));
  EXPECT_EQ(curve_named(curves, "glstat.rigidwall").values, (Numbers{3.5, 3.5}));
  EXPECT_EQ(curve_named(curves, "rwforc.normal[13]").values, (Numbers{20, 40}));
  EXPECT_EQ(curve_named(curves, "rcforc.fx[3 first]").values, (Numbers{1, 2}));
  EXPECT_EQ(curve_named(curves, "rcforc.fx[3 second]").values, (Numbers{-1, -2}));
  EXPECT_EQ(curve_named(curves, "nodout.ux[9000000000]").values, (Numbers{0.125, 0.125}));
  EXPECT_EQ(curves.size(), 9U);
}

TEST(Binout, ReadsWhatWasWritten) {
  const LsdaFile file(sample_bytes());
  EXPECT_EQ(file.damage(), "");
  expect_sample(read_binout({file}));
}

TEST(Binout, ForcesHaveTheNamesOfOurTables) {
  BinoutSample sample(8, true);
  sample.folder("/secforc/metadata");
  sample.write("ids", Type::I4, {17});
  sample.folder("/secforc/d000001");
  for (const char* name : {"time", "x_force", "total_force", "y_moment", "z_centroid"})
    sample.write(name, Type::R8, {5});
  sample.folder("/deforc/metadata");
  sample.write("ids", Type::I4, {71});
  sample.folder("/deforc/d000001");
  for (const char* name : {"time", "resultant_force", "displacement"}) sample.write(name, Type::R8, {6});
  sample.folder("/elout/beam/d000001");
  for (const char* name : {"ids", "mat", "nip"}) sample.write(name, Type::I4, {7});
  for (const char* name : {"time", "axial"}) sample.write(name, Type::R8, {8});
  sample.table();
  const std::vector<Curve> curves = read(sample.bytes());
  for (const char* name : {"secforc.fx[17]", "secforc.force[17]", "secforc.my[17]", "secforc.z[17]"})
    EXPECT_EQ(curve_named(curves, name).values, (Numbers{5})) << name;
  for (const char* name : {"deforc.resultant[71]", "deforc.displacement[71]"})
    EXPECT_EQ(curve_named(curves, name).values, (Numbers{6})) << name;
  EXPECT_EQ(curve_named(curves, "elout_beams.axial[7]").values, (Numbers{8}));
  EXPECT_EQ(curves.size(), 7U) << "parts and numbers of points are no curves";
}

TEST(Binout, FieldsOfAnyWidthAndOrder) {
  expect_sample(read(sample_bytes(4, true)));
  expect_sample(read(sample_bytes(8, false)));
  expect_sample(read(sample_bytes(4, false)));
}

TEST(Binout, NumbersOfEveryType) {
  for (const bool little_endian : {true, false}) {
    BinoutSample sample(8, little_endian);
    sample.folder("/x");
    const std::vector<std::pair<Type, Numbers>> cases = {
        {Type::I1, {-128, 127}},        {Type::I2, {-32768, 5}},
        {Type::I4, {-2147483648.0, 7}}, {Type::I8, {-9007199254740991.0, 1}},
        {Type::U1, {0, 255}},           {Type::U2, {65535, 1}},
        {Type::U4, {4294967295.0, 2}},  {Type::U8, {9007199254740991.0, 3}},
        {Type::R4, {-0.5, 1048576.25}}, {Type::R8, {0.1, -1e300}}};
    for (const auto& [type, numbers] : cases) sample.write("v" + std::to_string(type), type, numbers);
    sample.table();
    const LsdaFile file(sample.bytes());
    for (const auto& [type, numbers] : cases) {
      const auto found = file.variables().find("/x/v" + std::to_string(type));
      ASSERT_NE(found, file.variables().end());
      EXPECT_EQ(file.numbers(found->second), numbers) << "type " << type;
    }
  }
}

TEST(Binout, RelativeFolders) {
  BinoutSample sample;
  sample.folder("/glstat/d000001");
  sample.write("time", Type::R8, {1});
  sample.folder("../d000002");
  sample.write("time", Type::R8, {2});
  const LsdaFile file(sample.bytes());  // without a table the records are looked through
  EXPECT_TRUE(file.variables().contains("/glstat/d000001/time"));
  EXPECT_TRUE(file.variables().contains("/glstat/d000002/time"));
}

TEST(Binout, SeveralFilesAreOne) {
  BinoutSample first;
  write_glstat(first, 1, 0.5);
  first.table();
  BinoutSample second;
  write_glstat(second, 2, 1);
  second.table();
  const auto curves = read_binout({LsdaFile(first.bytes()), LsdaFile(second.bytes())});
  EXPECT_EQ(curve_named(curves, "glstat.kinetic").values, (Numbers{49, 48}));
}

TEST(Binout, AFileThatWasCutOffGivesWhatItHas) {
  const std::string all = sample_bytes();
  const LsdaFile file(all.substr(0, all.size() - 10));
  EXPECT_NE(file.damage(), "");
  expect_sample(read_binout({file}));
}

TEST(Binout, OtherFilesAreRefused) {
  EXPECT_THROW(LsdaFile(""), Error);
  EXPECT_THROW(LsdaFile("time,dt,kinetic\n0,1,2\n"), Error);
  EXPECT_THROW(LsdaFile(std::string(1000, '\0')), Error);
}

/// Whatever is in the bytes, reading them ends with curves or with a sentence.
void read_or_refuse(const std::string& bytes) {
  try {
    for (const Curve& curve : read(bytes)) ASSERT_EQ(curve.times.size(), curve.values.size());
  } catch (const Error& fault) {
    ASSERT_FALSE(std::string(fault.what()).empty());
  }
}

TEST(Binout, CutOffAtEveryByte) {
  for (const std::size_t width : {4U, 8U}) {
    const std::string all = sample_bytes(width);
    for (std::size_t length = 0; length < all.size(); ++length) read_or_refuse(all.substr(0, length));
  }
}

TEST(Binout, EveryByteChanged) {
  const std::string all = sample_bytes();
  for (std::size_t place = 0; place < all.size(); ++place)
    for (const int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
      std::string damaged = all;
      damaged[place] = static_cast<char>(value);
      read_or_refuse(damaged);
    }
}

TEST(Binout, ManyBytesChanged) {
  const std::string all = sample_bytes();
  std::mt19937 random(5);
  std::uniform_int_distribution<std::size_t> place(0, all.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = all;
    for (int change = 0; change < 1 + round % 20; ++change)
      damaged[place(random)] = static_cast<char>(byte(random));
    read_or_refuse(damaged);
  }
}

TEST(Binout, Noise) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> byte(0, 255);
  const std::string head = sample_bytes().substr(0, 25);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = head;
    for (int i = 0; i < 500; ++i) bytes += static_cast<char>(byte(random));
    read_or_refuse(bytes);
  }
}

}  // namespace
}  // namespace crumple::compare::binout_reader_test
