// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.hpp"

namespace crumple::report {

/// Reads the `.vtu` files that a run writes: one piece, appended raw data, zlib, 64-bit headers, the byte
/// order of this machine. Anything else is refused with an Error that names the file and what is wrong. Files
/// may come from anybody: every array is checked against what is asked of it, and none takes more memory than
/// the points and cells of the file need, which in turn its length bounds.
class VtuReader {
 public:
  enum class Section { PointData, CellData, Points, Cells };
  struct Array {
    Section section;
    std::string name;
    std::string type;          ///< VTK's name of the number type
    int components = 1;        ///< numbers per tuple
    std::uint64_t offset = 0;  ///< in the appended data [bytes]
  };

  /// Reads the file and its description; arrays are unpacked when they are asked for. Throws Error.
  explicit VtuReader(const std::filesystem::path& file);

  double time() const { return time_; }  ///< [time]
  Index points() const { return points_; }
  Index cells() const { return cells_; }
  const std::vector<Array>& arrays() const { return arrays_; }

  /// Null if there is none of that name.
  const Array* find(Section section, std::string_view name) const;
  /// An array of 32-bit reals, all finite or not. Throws Error if it is missing, of another type, has another
  /// number of components, or has not one tuple per point or cell.
  std::vector<float> reals(Section section, std::string_view name, int components) const;
  /// An array of Int32, Int64 or UInt8 of one component. Throws Error as above. Of the topology, types and
  /// offsets have one number per cell, and the nodes of a connectivity exist.
  std::vector<std::int64_t> integers(Section section, std::string_view name) const;

 private:
  void read_head(std::string_view head);
  void read_tag(std::string_view tag, std::string_view behind);
  void add_array(std::string_view tag);
  const Array& get(Section section, std::string_view name) const;
  std::uint64_t number(std::uint64_t at) const;
  std::uint64_t most_values(const Array& array) const;
  std::string unpacked(const Array& array) const;
  void check_counts() const;
  void check_count(const Array& array, std::size_t count) const;
  [[noreturn]] void refuse(std::string_view reason) const;

  std::filesystem::path file_;
  std::string text_;
  std::string_view data_;  ///< the appended data in text_
  double time_ = 0;
  Index points_ = 0;
  Index cells_ = 0;
  bool has_piece_ = false;
  Section section_ = Section::PointData;
  bool in_section_ = false;
  std::vector<Array> arrays_;
};

}  // namespace crumple::report
