// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Calls the whole program as its main function does, in a folder of its own.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.hpp"

namespace crumple::app {

class ProgramTest : public ::testing::Test {
 public:
  ~ProgramTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  struct Result {
    ExitCode code = ExitCode::Normal;
    std::string out;
    std::string err;
  };

  ProgramTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("crumple_app_") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
                 std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }

  static Result run(const std::vector<std::string>& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    const Console console{out, err, false};
    const ExitCode code = run_program(arguments, console);
    return {code, out.str(), err.str()};
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return path(name);
  }
  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  }
  nlohmann::json record(const std::string& results) const {
    return nlohmann::json::parse(read(results + "/run.json"));
  }
  /// The description of the run in a report.
  nlohmann::json description(const std::string& name) const {
    const std::string text = read(name);
    const std::string key = "id=\"crumple-meta\">";
    const std::size_t start = text.find(key) + key.size();
    return nlohmann::json::parse(text.substr(start, text.find("</script>", start) - start));
  }
  /// Cells of the rows of a table; the first row is the header.
  std::vector<std::vector<std::string>> table(const std::string& name) const {
    std::vector<std::vector<std::string>> rows;
    std::ifstream file(folder_ / name);
    for (std::string line; std::getline(file, line);) {
      rows.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
  }

  std::filesystem::path folder_;
};

/// Four elastic shells of steel (kg, mm, ms) that fall on a wall with 1 mm/ms. `control` is put before the
/// mesh.
inline std::string falling_plate(const std::string& control = "*CONTROL_TERMINATION\n       1.0\n") {
  return "*KEYWORD\n*TITLE\nplate falls on a wall\n" + control +
         "*NODE\n"
         "       1             0.0             0.0             0.5\n"
         "       2            10.0             0.0             0.6\n"
         "       3            20.0             0.0             0.5\n"
         "       4             0.0            10.0             0.5\n"
         "       5            10.0            10.0             0.7\n"
         "       6            20.0            10.0             0.5\n"
         "       7             0.0            20.0             0.5\n"
         "       8            10.0            20.0             0.6\n"
         "       9            20.0            20.0             0.5\n"
         "*ELEMENT_SHELL\n"
         "       1       1       1       2       5       4\n"
         "       2       1       2       3       6       5\n"
         "       3       1       4       5       8       7\n"
         "       4       1       5       6       9       8\n"
         "*PART\nplate\n"
         "         1         1         1\n"
         "*SECTION_SHELL\n"
         "         1         2  0.833333         3\n"
         "       1.0       1.0       1.0       1.0\n"
         "*MAT_ELASTIC\n"
         "         1   7.83e-6     207.0       0.3\n"
         "*INITIAL_VELOCITY\n"
         "         0\n"
         "       0.0       0.0      -1.0\n"
         "*RIGIDWALL_PLANAR_ID\n"
         "        12\n"
         "         0\n"
         "       0.0       0.0       0.0       0.0       0.0       1.0       0.0\n"
         "*END\n";
}

}  // namespace crumple::app
