// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/report_pictures.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/error.hpp"

namespace crumple::app::report_pictures_test {
namespace {

TEST(ReportPictures, AddressesAreEncoded) {
  PictureOptions options;
  options.field = "von_mises";
  options.view = "+x";
  EXPECT_EQ(picture_address("/a b/r#1.html", options, "50%"),
            "file:///a%20b/r%231.html#picture&theme=light&frame=50%25&view=%2Bx&field=von_mises");
}

TEST(ReportPictures, WhatIsNotAskedForIsLeftToThePage) {
  EXPECT_EQ(picture_address("/r.html", PictureOptions{}, "last"),
            "file:///r.html#picture&theme=light&frame=last");
}

class BrowserTest : public ::testing::Test {
 public:
  ~BrowserTest() override {
    unsetenv("CHROMIUM");
    setenv("PATH", path_.c_str(), 1);
  }

 protected:
  BrowserTest() : path_(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "") {}
  static std::string complaint() {
    try {
      find_browser();
    } catch (const Error& fault) {
      return fault.what();
    }
    return "none";
  }
  std::string path_;
};

TEST_F(BrowserTest, SaysHowToGetOne) {
  unsetenv("CHROMIUM");
  setenv("PATH", "/nowhere", 1);
  EXPECT_NE(complaint().find("apt-get install chromium"), std::string::npos);
}

TEST_F(BrowserTest, TakesTheOneThatIsNamed) {
  setenv("CHROMIUM", "/bin/sh", 1);
  EXPECT_EQ(find_browser(), "/bin/sh");
  setenv("CHROMIUM", "/nowhere/chromium", 1);
  EXPECT_NE(complaint().find("/nowhere/chromium"), std::string::npos);
}

TEST_F(BrowserTest, ABrowserThatDrawsNothingIsAnError) {
  setenv("CHROMIUM", "/bin/true", 1);
  EXPECT_THROW(
      draw_pictures(std::filesystem::path(::testing::TempDir()) / "no_report.html", PictureOptions{}), Error);
}

}  // namespace
}  // namespace crumple::app::report_pictures_test
