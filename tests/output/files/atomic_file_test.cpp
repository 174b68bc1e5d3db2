// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "output/files/write_error.hpp"

namespace crumple::output::atomic_file_test {
namespace {

class AtomicFileTest : public ::testing::Test {
 public:
  ~AtomicFileTest() override { std::filesystem::remove_all(folder_); }

 protected:
  AtomicFileTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("crumple_atomic_" +
                 std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                 std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  static std::string read(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()));
  }

  std::filesystem::path folder_;
};

TEST_F(AtomicFileTest, ReplacesTheWholeContentAndLeavesNothingBeside) {
  write_atomically(folder_ / "a", "a long first text");
  write_atomically(folder_ / "a", std::string_view("x\0y", 3));
  EXPECT_EQ(read(folder_ / "a"), std::string("x\0y", 3));
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFileTest, AReaderThatHoldsTheOldFileKeepsReadingIt) {
  write_atomically(folder_ / "a", "old");
  std::ifstream reader(folder_ / "a");
  write_atomically(folder_ / "a", "new content");
  std::string word;
  reader >> word;
  EXPECT_EQ(word, "old") << "the file was written over in place";
}

TEST_F(AtomicFileTest, NamesTheFileThatCannotBeWritten) {
  try {
    write_atomically(folder_ / "absent" / "a", "x");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const WriteError& fault) {
    EXPECT_NE(std::string(fault.what()).find("absent/a: No such file"), std::string::npos) << fault.what();
  }
}

TEST_F(AtomicFileTest, LeavesNothingBesideAfterAFailedRename) {
  std::filesystem::create_directories(folder_ / "a" / "inside");
  EXPECT_THROW(write_atomically(folder_ / "a", "x"), WriteError);
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFileTest, AFileThatCannotGrowIsAnErrorAndKeepsTheOldOne) {
  write_atomically(folder_ / "a", "old");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_atomically(folder_ / "a", std::string(1000, 'x')), WriteError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(read(folder_ / "a"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(AtomicFileTest, MakesFoldersWithTheirParentsAndRefusesAFileInTheWay) {
  make_folder(folder_ / "b" / "c");
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "b" / "c"));
  write_atomically(folder_ / "file", "x");
  EXPECT_THROW(make_folder(folder_ / "file"), WriteError);
  EXPECT_THROW(make_folder(folder_ / "file" / "c"), WriteError);
}

}  // namespace
}  // namespace crumple::output::atomic_file_test
