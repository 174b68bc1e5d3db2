// SPDX-License-Identifier: BSD-3-Clause
#include "report/result_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"

namespace crumple::report::result_folder_test {
namespace {

namespace fs = std::filesystem;

class ResultFolderTest : public testing::Test {
 public:
  ResultFolderTest() { fs::create_directories(folder_); }
  ~ResultFolderTest() override { fs::remove_all(folder_); }

 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  fs::path folder_ = fs::temp_directory_path() / ("crumple_result_" + std::to_string(getpid()));
};

TEST_F(ResultFolderTest, NamesOfFilesMayHoldWhatXmlGivesAMeaning) {
  write("run.pvd",
        "<VTKFile><Collection>\n"
        "<DataSet timestep=\"0.5\" part=\"0\" file=\"vtu/a&quot;b&gt;c&amp;lt;_000000.vtu\"/>\n"
        "<DataSet timestep=\"0.5\" part=\"1\" file=\"vtu/walls.vtu\"/>\n</Collection></VTKFile>\n");
  const ResultFolder found = open_results(folder_);
  ASSERT_EQ(found.frames.size(), 1U);
  EXPECT_EQ(found.frames[0].grid, folder_ / "vtu/a\"b>c&lt;_000000.vtu");
  EXPECT_EQ(found.frames[0].walls, folder_ / "vtu/walls.vtu");
}

TEST_F(ResultFolderTest, ACollectionFromSomebodyElseIsRefusedWhereItIsNoneOfOurs) {
  const auto complaint = [&](const std::string& tags) -> std::string {
    write("run.pvd", "<VTKFile><Collection>\n" + tags + "</Collection></VTKFile>\n");
    try {
      open_results(folder_);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "none";
  };
  const auto tag = [](const std::string& time, const std::string& file) {
    return "<DataSet timestep=\"" + time + "\" part=\"0\" file=\"" + file + "\"/>\n";
  };
  EXPECT_EQ(complaint(tag("0", "vtu/a.vtu")), "none");
  for (const char* time : {"", "soon", "1e999", "-1e999", "nan", "inf", "0x1p3", "1 ", "1,5"})
    EXPECT_NE(complaint(tag(time, "vtu/a.vtu")).find("is not understood"), std::string::npos) << time;
  for (const char* file : {"", "/dev/zero", "/etc/passwd", "../a.vtu", "vtu/../../a.vtu"})
    EXPECT_NE(complaint(tag("0", file)).find("is not understood"), std::string::npos) << file;
  // One file again and again would be read again and again.
  EXPECT_NE(complaint(tag("0", "vtu/a.vtu") + tag("1", "vtu/a.vtu")).find("is not understood"),
            std::string::npos);
  EXPECT_LT(complaint(tag(std::string(10000, '1'), "a.vtu")).size(), 1000U);
}

TEST_F(ResultFolderTest, TakesLinearTimeForAnyCollection) {
  std::string text = "<VTKFile>";
  for (int i = 0; i < 300000; ++i) text += "<DataSet";
  write("run.pvd", text + " timestep=\"1\" file=\"a.vtu\">");
  EXPECT_EQ(open_results(folder_).frames.size(), 1U);
}

TEST_F(ResultFolderTest, AFolderWithoutFramesIsNoResult) {
  EXPECT_THROW(open_results(folder_), Error);
  write("run.pvd", "<VTKFile><Collection></Collection></VTKFile>\n");
  EXPECT_THROW(open_results(folder_), Error);
  EXPECT_THROW(open_results(folder_ / "nowhere"), Error);
}

}  // namespace
}  // namespace crumple::report::result_folder_test
