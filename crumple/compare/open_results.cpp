// SPDX-License-Identifier: BSD-3-Clause
#include "compare/open_results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "compare/curves/quantity_names.hpp"
#include "compare/readers/ascii_reader.hpp"
#include "compare/readers/binout_reader.hpp"
#include "compare/readers/csv_reader.hpp"
#include "compare/scatter_bands.hpp"
#include "report/scatter_folder.hpp"
#include "report/text_file.hpp"

namespace crumple::compare {

namespace {

using Path = std::filesystem::path;

/// Tables of ours that are no histories: rows with one element each, a list of the start.
constexpr std::array<std::string_view, 2> no_histories = {"timestep.csv", "initial_penetrations.csv"};

bool is_ascii_file(std::string_view name) {
  const auto names = ascii_files();
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_lsda(const std::string& bytes) {
  return bytes.size() >= 8 && bytes[0] >= 8 && bytes[0] < 64 && bytes[6] == 0 && bytes[7] == 0 &&
         static_cast<unsigned char>(bytes[5]) <= 1 && bytes[1] > 0 && bytes[1] <= 8;
}

class Reader {
 public:
  explicit Reader(const Path& source) { set_.source = source.string(); }

  void read_csv_file(const Path& file) {
    try {
      keep(read_csv(report::read_file(file), file.stem().string()), file.filename().string());
    } catch (const Error& fault) {
      note(file, fault.what());
    }
  }

  void read_ascii_file(const Path& file, std::string_view name) {
    try {
      std::vector<Curve> curves = read_ascii(report::read_file(file), name);
      if (curves.empty()) note(file, fmt::format("there is no table of {} in it.", name));
      keep(std::move(curves), file.filename().string());
    } catch (const Error& fault) {
      note(file, fault.what());
    }
  }

  void read_binout_files(const std::vector<Path>& paths) {
    std::vector<LsdaFile> files;
    std::string names;
    for (const Path& path : paths) {
      try {
        files.emplace_back(report::read_file(path));
        if (!files.back().damage().empty()) note(path, files.back().damage());
        if (!names.empty()) names += ' ';
        names += path.filename().string();
      } catch (const Error& fault) {
        note(path, fault.what());
      }
    }
    if (!files.empty()) keep(read_binout(files), names);
  }

  /// A file of any name: its content tells what it is.
  void read_file(const Path& file) {
    const std::string name = file.filename().string();
    if (file.extension() == ".csv") return read_csv_file(file);
    if (is_ascii_file(name)) return read_ascii_file(file, name);
    const std::string bytes = report::read_file(file);
    if (is_lsda(bytes)) return read_binout_files({file});
    for (const std::string_view known : ascii_files())
      if (std::vector<Curve> curves = read_ascii(bytes, known); !curves.empty())
        return keep(std::move(curves), name);
    read_csv_file(file);
  }

  void read_folder(const Path& folder) {
    const Path scatter = folder / report::bands_file;
    if (std::filesystem::is_regular_file(scatter)) {
      read_scatter(scatter);
      if (!set_.bands.empty()) return;
    }
    std::vector<Path> tables;
    std::vector<Path> binouts;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (!entry.is_regular_file()) continue;
      if (entry.path().extension() == ".csv" &&
          std::find(no_histories.begin(), no_histories.end(), name) == no_histories.end())
        tables.push_back(entry.path());
      if (name.starts_with("binout")) binouts.push_back(entry.path());
    }
    std::sort(tables.begin(), tables.end());
    std::sort(binouts.begin(), binouts.end());
    for (const Path& table : tables) read_csv_file(table);
    if (!binouts.empty()) read_binout_files(binouts);
    for (const std::string_view name : ascii_files())
      if (std::filesystem::is_regular_file(folder / name)) read_ascii_file(folder / name, name);
  }

  /// The medians of `crumple scatter`, with their bands.
  void read_scatter(const Path& table) {
    set_.bands = read_bands(report::read_file(table));
    keep(medians_of(set_.bands), table.filename().string());
  }

  CurveSet finish() {
    if (set_.curves.empty()) {
      std::string text = fmt::format("{} holds no history that can be read.", set_.source);
      for (const std::string& one : set_.notes) text += " " + one;
      throw Error(text);
    }
    add_derived_curves(set_);
    return std::move(set_);
  }

 private:
  /// Whether another file has given a group. ncforc of binout is a branch for each side of a contact, which
  /// are together in the table.
  bool is_given(const std::string& group) const {
    return groups_.contains(group) || (group.starts_with("ncforc_") && groups_.contains("ncforc"));
  }

  void note(const Path& file, std::string_view text) {
    set_.notes.push_back(fmt::format("{}: {}", file.string(), text));
  }

  /// Curves of groups that another file has given are left out.
  void keep(std::vector<Curve> curves, const std::string& name) {
    std::set<std::string> added;
    std::size_t not_finite = 0;
    for (Curve& curve : curves) {
      if (is_given(curve.group)) continue;
      not_finite += curve.not_finite;
      if (curve.times.empty()) continue;
      added.insert(curve.group);
      set_.curves.push_back(std::move(curve));
    }
    if (!added.empty()) set_.files.push_back(name);
    if (not_finite > 0)
      note(name, counted(not_finite, "value") + " not finite, and left out: the run may have gone wrong");
    groups_.merge(added);
  }

  CurveSet set_;
  std::set<std::string> groups_;
};

}  // namespace

CurveSet open_results(const std::filesystem::path& source) {
  std::error_code ignored;
  Reader reader(source);
  if (std::filesystem::is_directory(source, ignored))
    reader.read_folder(source);
  else if (std::filesystem::is_regular_file(source, ignored))
    reader.read_file(source);
  else
    throw Error(fmt::format("{} is neither a file nor a folder.", source.string()));
  return reader.finish();
}

double guessed_seconds(const std::filesystem::path& source) {
  std::error_code ignored;
  const Path folder = std::filesystem::is_directory(source, ignored) ? source : source.parent_path();
  const Path record = folder / "run.json";
  if (!std::filesystem::is_regular_file(record, ignored)) return 0;
  const nlohmann::json json = nlohmann::json::parse(report::read_file(record), nullptr, false);
  if (!json.is_object() || !json.contains("units") || !json["units"].is_string()) return 0;
  const std::string units = json["units"].get<std::string>();
  const std::string time = units.substr(units.find_last_of(" -,") + 1);
  if (time == "s") return 1;
  if (time == "ms") return 1e-3;
  if (time == "us") return 1e-6;
  return 0;
}

}  // namespace crumple::compare
