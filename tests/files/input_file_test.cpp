// SPDX-License-Identifier: BSD-3-Clause
#include "files/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace crumple::input_file_test {
namespace {

class InputFileTest : public ::testing::Test {
 public:
  ~InputFileTest() override { std::filesystem::remove_all(folder_); }

 protected:
  InputFileTest()
      : folder_(std::filesystem::path(::testing::TempDir()) / ("crumple_input_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  static std::string fault(const std::filesystem::path& path) {
    const InputFile input = read_input_file(path);
    EXPECT_TRUE(input.text.empty() || input.fault.empty());
    return input.fault;
  }
  std::filesystem::path folder_;
};

TEST_F(InputFileTest, ReadsAllBytesAlsoThroughALink) {
  const std::string text("a\0b\r\n\xff", 6);
  const auto path = write("a", text);
  std::filesystem::create_symlink(path, folder_ / "link");
  EXPECT_EQ(read_input_file(path).text, text);
  EXPECT_EQ(read_input_file(folder_ / "link").text, text);
  EXPECT_EQ(read_input_file(write("empty", "")).text, "");
  EXPECT_EQ(fault(folder_ / "empty"), "");
}

TEST_F(InputFileTest, SaysWhatIsNoRegularFileWithoutWaitingForIt) {
  EXPECT_EQ(fault(folder_ / "absent"), "there is no such file");
  EXPECT_EQ(fault(folder_), "this is a folder, expected a file");
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(fault(folder_ / "pipe"), "this is a pipe, expected a regular file");
  std::filesystem::create_symlink("/dev/zero", folder_ / "zero");
  EXPECT_EQ(fault(folder_ / "zero"), "this is a device, expected a regular file");
  EXPECT_EQ(fault("/dev/zero"), "this is a device, expected a regular file");
  EXPECT_EQ(read_start("/dev/zero", 10), "");
  EXPECT_EQ(read_start(folder_ / "pipe", 10), "");
  std::filesystem::create_symlink("loop", folder_ / "loop");
  EXPECT_NE(fault(folder_ / "loop"), "");
}

TEST_F(InputFileTest, RefusesWhatTheKernelMakesUp) {
  if (!std::filesystem::exists("/proc/self/maps")) GTEST_SKIP() << "no /proc here";
  EXPECT_EQ(fault("/proc/self/maps"), "the kernel makes this file up, expected a regular one");
}

TEST_F(InputFileTest, SaysTheSizeOfWhatIsTooLarge) {
  const auto path = write("large", "");
  // No disk is needed for what was never written.
  std::filesystem::resize_file(path, std::uintmax_t{1} << 42U);
  EXPECT_EQ(fault(path).find("the file has 4.4 TB, more than the "), 0U) << fault(path);
  const InputFile input = read_input_file(write("small", "12345"), 4);
  EXPECT_EQ(input.fault, "the file has 5 bytes, more than the 4 bytes that can be read");
}

TEST_F(InputFileTest, ReadsTheStart) {
  const auto path = write("a", "12345");
  EXPECT_EQ(read_start(path, 3), "123");
  EXPECT_EQ(read_start(path, 10), "12345");
}

}  // namespace
}  // namespace crumple::input_file_test
