// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/lsda_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>

#include "output/files/write_error.hpp"
#include "output/lsda_reader.hpp"
#include "output/sample.hpp"

namespace crumple::output::lsda_file_test {
namespace {

class LsdaFileTest : public SampleTest {
 protected:
  std::filesystem::path path() const { return folder_ / "binout0000"; }

  /// A state with three values that tell its number.
  static void add_group(LsdaFile& file, int number) {
    file.enter("/glstat/d00000" + std::to_string(number));
    file.add("time", 0.5 * number);
    file.add("cycle", std::int64_t{10 * number});
    file.add("kinetic_energy", std::vector<double>{1.0 * number, 2.0 * number});
    file.end_group();
  }
  static void add_state(LsdaFile& file, int number) {
    add_group(file, number);
    file.flush();
  }
  /// As a restart file has it.
  static std::uint64_t length(LsdaFile& file) {
    domain::StateList list;
    file.declare(list);
    std::uint64_t result = 0;
    std::memcpy(&result, list.arrays().at(0).bytes.data(), sizeof result);
    return result;
  }
  static bool resume(LsdaFile& file, std::uint64_t length) {
    domain::StateList list;
    file.declare(list);
    std::memcpy(list.arrays().at(0).bytes.data(), &length, sizeof length);
    return file.resume();
  }
  static void expect_states(const std::filesystem::path& path, int states) {
    const LsdaReader read(path);
    EXPECT_EQ(read.states("/glstat"), states);
    for (int number = 1; number <= states; ++number) {
      const std::string folder = "/glstat/d00000" + std::to_string(number) + "/";
      EXPECT_EQ(read.reals(folder + "time"), std::vector<double>{0.5 * number});
      EXPECT_EQ(read.integers(folder + "cycle"), std::vector<std::int64_t>{10 * number});
      EXPECT_EQ(read.reals(folder + "kinetic_energy"), (std::vector<double>{1.0 * number, 2.0 * number}));
    }
  }
};

TEST_F(LsdaFileTest, StartsWithTheHeaderAndAnEmptyLink) {
  const LsdaFile file(path());
  EXPECT_EQ(read(path()), std::string("\10\10\10\1\1\1\0\0"
                                      "\21\0\0\0\0\0\0\0\7"
                                      "\0\0\0\0\0\0\0\0",
                                      25));
  EXPECT_EQ(LsdaReader(path()).tables(), 0);
}

TEST_F(LsdaFileTest, ArraysOfAllTypesReadBack) {
  LsdaFile file(path());
  const std::int64_t large = std::int64_t{1} << 40;
  file.enter("/nodout/metadata");
  file.add("title", "a plate");
  file.add("ids", std::vector<std::int64_t>{7, -1, std::numeric_limits<std::int32_t>::max()});
  file.add("large_ids", std::vector<std::int64_t>{7, large});
  file.add("none", std::vector<double>{});
  file.enter("/nodout/d000001");
  file.add("x_velocity", std::vector<double>{1.0 / 3, -1e-300, std::numeric_limits<double>::infinity()});
  file.flush();
  const LsdaReader read(path());
  EXPECT_EQ(read.characters("/nodout/metadata/title"), "a plate");
  EXPECT_EQ(read.array("/nodout/metadata/ids").type, 3);
  EXPECT_EQ(read.integers("/nodout/metadata/ids"), (std::vector<std::int64_t>{7, -1, 2147483647}));
  EXPECT_EQ(read.integers("/nodout/metadata/large_ids"), (std::vector<std::int64_t>{7, large}));
  EXPECT_FALSE(read.has("/nodout/metadata/none"));
  EXPECT_EQ(read.reals("/nodout/d000001/x_velocity"),
            (std::vector<double>{1.0 / 3, -1e-300, std::numeric_limits<double>::infinity()}));
}

TEST_F(LsdaFileTest, EachFlushAddsATable) {
  LsdaFile file(path());
  for (int number = 1; number <= 3; ++number) add_state(file, number);
  file.flush();
  EXPECT_EQ(LsdaReader(path()).tables(), 3) << "the last flush had nothing to add";
  EXPECT_EQ(length(file), std::filesystem::file_size(path()));
  expect_states(path(), 3);
}

TEST_F(LsdaFileTest, BytesDoNotDependOnWhenGroupsAreFlushed) {
  LsdaFile file(path());
  for (int number = 1; number <= 4; ++number) add_state(file, number);
  const std::string each = read(path());
  LsdaFile later(path());
  add_state(later, 1);
  const std::string first = read(path());
  for (int number = 2; number <= 4; ++number) add_group(later, number);
  EXPECT_EQ(read(path()), first);
  later.flush();
  EXPECT_EQ(read(path()), each);
  EXPECT_EQ(LsdaReader(path()).tables(), 4);
}

TEST_F(LsdaFileTest, AProgramKilledWhileItWritesLeavesWhatWasThere) {
  LsdaFile file(path());
  add_state(file, 1);
  const std::uint64_t before = length(file);
  const std::string intact = read(path());
  add_state(file, 2);
  const std::string whole = read(path());
  // All records come before the link that makes them known.
  for (std::uint64_t length = before; length < whole.size(); ++length) {
    std::ofstream(path(), std::ios::binary) << intact << whole.substr(before, length - before);
    expect_states(path(), 1);
  }
}

TEST_F(LsdaFileTest, GoesOnFromAnEarlierLength) {
  std::uint64_t length = 0;
  std::uint64_t empty = 0;
  std::string all;
  {
    LsdaFile file(path());
    empty = LsdaFileTest::length(file);
    add_state(file, 1);
    add_state(file, 2);
    length = LsdaFileTest::length(file);
    add_state(file, 3);
    all = read(path());
  }
  {
    LsdaFile file(path(), Opening::Continued);
    EXPECT_TRUE(resume(file, length));
    expect_states(path(), 2);
    add_state(file, 3);
  }
  EXPECT_EQ(read(path()), all);
  {
    LsdaFile file(path(), Opening::Continued);
    EXPECT_TRUE(resume(file, empty));
    for (int number = 1; number <= 3; ++number) add_state(file, number);
  }
  EXPECT_EQ(read(path()), all);
}

TEST_F(LsdaFileTest, WhatCannotBeWrittenIsSaid) {
  EXPECT_THROW(LsdaFile(folder_ / "no" / "binout0000"), WriteError);
}

TEST_F(LsdaFileTest, AFileThatIsGoneBeginsAnew) {
  LsdaFile file(path(), Opening::Continued);
  EXPECT_FALSE(std::filesystem::exists(path())) << "its length is not known yet";
  EXPECT_FALSE(resume(file, 1000));
  add_state(file, 1);
  expect_states(path(), 1);
}

}  // namespace
}  // namespace crumple::output::lsda_file_test
