// SPDX-License-Identifier: BSD-3-Clause
#include "output/files/own_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "output/files/atomic_file.hpp"
#include "output/files/growing_file.hpp"
#include "output/files/write_error.hpp"
#include "output/lsdyna/lsda_file.hpp"

namespace crumple::output::own_file_test {
namespace {

/// The victim's file lies outside of the folder that somebody else has prepared.
class OwnFileTest : public ::testing::Test {
 public:
  ~OwnFileTest() override { std::filesystem::remove_all(root_); }

 protected:
  OwnFileTest()
      : root_(std::filesystem::path(::testing::TempDir()) /
              ("crumple_own_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
               "_" + std::to_string(getpid()))),
        folder_(root_ / "results"),
        victim_(root_ / "victim"),
        name_(folder_ / "a.csv") {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(folder_);
    std::ofstream(victim_) << "precious";
  }
  static std::string read(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  /// Each way in which a file is made, onto `name_`.
  static std::vector<std::function<void(const std::filesystem::path&)>> ways() {
    return {[](const auto& path) { write_atomically(path, "new"); },
            [](const auto& path) { OwnFile::create(path).write_at(0, "new"); },
            [](const auto& path) { GrowingFile(path, Opening::New).append("new"); },
            [](const auto& path) { LsdaFile file(path); }};
  }
  bool nothing_beside() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      if (entry.path() != name_) return false;
    return true;
  }

  std::filesystem::path root_;
  std::filesystem::path folder_;
  std::filesystem::path victim_;
  std::filesystem::path name_;
};

TEST_F(OwnFileTest, LinksAreReplacedAndNotFollowed) {
  for (const auto& write : ways()) {
    std::filesystem::remove(name_);
    std::filesystem::create_symlink(victim_, name_);
    write(name_);
    EXPECT_EQ(read(victim_), "precious");
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(name_)));
    std::filesystem::remove(name_);
    std::filesystem::create_symlink(root_ / "absent", name_);
    write(name_);
    EXPECT_FALSE(std::filesystem::exists(root_ / "absent"));
    std::filesystem::remove(name_);
    std::filesystem::create_hard_link(victim_, name_);
    write(name_);
    EXPECT_EQ(read(victim_), "precious");
    EXPECT_TRUE(nothing_beside());
  }
}

TEST_F(OwnFileTest, PredictableNamesBesideAreNotUsed) {
  for (const char* ending : {".tmp", ".new", "~"})
    std::filesystem::create_symlink(victim_, name_.string() + ending);
  for (const auto& write : ways()) write(name_);
  EXPECT_EQ(read(victim_), "precious");
  for (const char* ending : {".tmp", ".new", "~"})
    EXPECT_TRUE(std::filesystem::is_symlink(std::filesystem::symlink_status(name_.string() + ending)));
}

TEST_F(OwnFileTest, DevicesPipesAndFoldersAreRefusedAtOnceAndStay) {
  ASSERT_EQ(mkfifo((root_ / "pipe").c_str(), 0600), 0);
  std::filesystem::create_directories(root_ / "folder");
  for (const std::filesystem::path& target :
       {root_ / "pipe", std::filesystem::path("/dev/null"), root_ / "folder"})
    for (const auto& write : ways()) {
      std::filesystem::remove(name_);
      std::filesystem::create_symlink(target, name_);
      EXPECT_THROW(write(name_), WriteError) << target;
      EXPECT_TRUE(std::filesystem::is_symlink(std::filesystem::symlink_status(name_)));
      EXPECT_TRUE(nothing_beside());
    }
  for (const auto& write : ways()) {
    EXPECT_THROW(write(root_ / "pipe"), WriteError);
    EXPECT_THROW(write(root_ / "folder"), WriteError);
  }
}

TEST_F(OwnFileTest, WhatGoesOnMustBeAFileOfOneName) {
  std::filesystem::create_symlink(victim_, name_);
  EXPECT_THROW(OwnFile::open(name_), WriteError);
  std::filesystem::remove(name_);
  ASSERT_EQ(mkfifo(name_.c_str(), 0600), 0);
  EXPECT_THROW(OwnFile::open(name_), WriteError);
  std::filesystem::remove(name_);
  EXPECT_THROW(OwnFile::open(name_), WriteError);
  // A copy of a folder by hard links keeps its content.
  std::filesystem::create_hard_link(victim_, name_);
  OwnFile::open(name_).write_at(8, "!");
  EXPECT_EQ(read(victim_), "precious");
  EXPECT_EQ(read(name_), "precious!");
  EXPECT_TRUE(nothing_beside());
}

TEST_F(OwnFileTest, ATableThatIsRemovedOrReplacedIsNoticed) {
  GrowingFile table(name_, Opening::New);
  table.append("a\n");
  std::filesystem::remove(name_);
  EXPECT_THROW(table.append("b\n"), WriteError);
  LsdaFile binout(name_);
  write_atomically(name_, "another");
  binout.enter("/a");
  binout.add("b", 1.0);
  EXPECT_THROW(binout.flush(), WriteError);
  EXPECT_EQ(read(name_), "another");
}

TEST_F(OwnFileTest, SubfoldersOfResultsAreNoLinks) {
  std::filesystem::create_directories(root_ / "elsewhere");
  std::filesystem::create_directory_symlink(root_ / "elsewhere", folder_ / "vtu");
  EXPECT_THROW(make_subfolder(folder_ / "vtu"), WriteError);
  make_subfolder(folder_ / "restart");
  make_subfolder(folder_ / "restart");
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "restart"));
  // The folder of the results itself may lie on another disk.
  std::filesystem::create_directory_symlink(folder_, root_ / "out");
  make_folder(root_ / "out");
}

TEST_F(OwnFileTest, WhatKilledRunsLeftIsRemovedAndNothingElse) {
  std::ofstream(folder_ / ".a.csv.0123456789abcdef.tmp") << "x";
  std::ofstream(folder_ / ".report.html.0123456789abcdef.tmp") << "x";
  std::ofstream(folder_ / "mine.tmp") << "x";
  std::ofstream(folder_ / ".mine.tmp") << "x";
  remove_unfinished_files(folder_);
  EXPECT_FALSE(std::filesystem::exists(folder_ / ".a.csv.0123456789abcdef.tmp"));
  for (const char* name : {".report.html.0123456789abcdef.tmp", "mine.tmp", ".mine.tmp"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(OwnFileTest, NewFilesHaveTheUsualPermissions) {
  const mode_t before = umask(027);
  write_atomically(name_, "x");
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(name_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

}  // namespace
}  // namespace crumple::output::own_file_test
