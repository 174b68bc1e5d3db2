// SPDX-License-Identifier: BSD-3-Clause
#include "report/vtu_reader.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

/// The value of an attribute in the text of a tag; nothing if the tag has none of that name.
std::optional<std::string_view> attribute(std::string_view tag, const std::string& name) {
  const std::string key = fmt::format(" {}=\"", name);
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t start = at + key.size();
  const std::size_t end = tag.find('"', start);
  if (end == std::string_view::npos) return std::nullopt;
  return tag.substr(start, end - start);
}

template <class Number>
std::optional<Number> parse(std::optional<std::string_view> text) {
  Number value{};
  if (!text) return std::nullopt;
  const auto [end, fault] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (fault != std::errc() || end != text->data() + text->size()) return std::nullopt;
  return value;
}

constexpr std::size_t most_arrays = 1000;
constexpr int most_components = 9;
constexpr std::uint64_t most_corners = 8;  ///< of a cell

std::size_t bytes_of(std::string_view type) {
  if (type == "UInt8") return 1;
  if (type == "Int32" || type == "Float32") return 4;
  return type == "Int64" ? 8 : 0;
}

template <class Number, class Result>
std::vector<Result> copied(const std::string& bytes) {
  std::vector<Number> values(bytes.size() / sizeof(Number));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Number));
  return {values.begin(), values.end()};
}

}  // namespace

VtuReader::VtuReader(const std::filesystem::path& file) : file_(file), text_(read_file(file)) {
  const std::string_view text = text_;
  constexpr std::string_view mark = "<AppendedData encoding=\"raw\">";
  const std::size_t appended = text.find(mark);
  if (appended == std::string_view::npos) refuse("it has no appended raw data");
  const std::size_t start = text.find('_', appended + mark.size());
  if (start == std::string_view::npos) refuse("its appended data is cut off");
  data_ = text.substr(start + 1);
  read_head(text.substr(0, appended));
  if (!has_piece_) refuse("it has no piece with a number of points and cells");
  check_counts();
}

/// Points and cells that cannot be in so short a file would only take memory.
void VtuReader::check_counts() const {
  constexpr std::uint64_t most_packed = 1032;  // of zlib: its technical details, "Maximum compression factor"
  const std::uint64_t most_bytes = most_packed * data_.size();
  const auto points = static_cast<std::uint64_t>(points_);
  const auto cells = static_cast<std::uint64_t>(cells_);
  if (3 * sizeof(float) * points > most_bytes || cells > most_bytes)
    refuse("it is too short for its points and cells");
}

void VtuReader::refuse(std::string_view reason) const {
  throw Error(fmt::format("{} cannot be read: {}.", file_.string(), reason));
}

void VtuReader::read_head(std::string_view head) {
  // From the end of each tag, so that the time is linear in the length whatever it holds.
  std::size_t end = 0;
  for (std::size_t at = head.find('<'); at != std::string_view::npos; at = head.find('<', end)) {
    end = head.find('>', at);
    if (end == std::string_view::npos) refuse("a tag does not end");
    const std::string_view behind = head.substr(end + 1);
    read_tag(head.substr(at + 1, end - at - 1), behind.substr(0, behind.find('<')));
  }
}

void VtuReader::read_tag(std::string_view tag, std::string_view behind) {
  const std::string_view name = tag.substr(0, tag.find(' '));
  const auto is = [&](const char* key, std::string_view value) { return attribute(tag, key) == value; };
  if (name == "VTKFile") {
    const bool little = std::endian::native == std::endian::little;
    if (!is("type", "UnstructuredGrid") || !is("header_type", "UInt64") ||
        !is("compressor", "vtkZLibDataCompressor") ||
        !is("byte_order", little ? "LittleEndian" : "BigEndian"))
      refuse("it is not a file of this program on this kind of machine");
  } else if (name == "Piece") {
    const auto points = parse<Index>(attribute(tag, "NumberOfPoints"));
    const auto cells = parse<Index>(attribute(tag, "NumberOfCells"));
    if (has_piece_ || !points || !cells || *points < 0 || *cells < 0) refuse("its piece is not understood");
    points_ = *points;
    cells_ = *cells;
    has_piece_ = true;
  } else if (name == "DataArray" && is("Name", "TimeValue")) {
    const auto time = parse<double>(behind);
    if (!time || !std::isfinite(*time)) refuse("its time is not a number");
    time_ = *time;
  } else if (name == "DataArray") {
    add_array(tag);
  } else {
    constexpr std::string_view names[] = {"PointData", "CellData", "Points", "Cells"};
    for (int i = 0; i < 4; ++i)
      if (name == names[i]) {
        section_ = static_cast<Section>(i);
        in_section_ = true;
      }
  }
}

void VtuReader::add_array(std::string_view tag) {
  const auto type = attribute(tag, "type");
  const auto name = attribute(tag, "Name");
  const auto components = parse<int>(attribute(tag, "NumberOfComponents"));
  const auto offset = parse<std::uint64_t>(attribute(tag, "offset"));
  if (arrays_.size() == most_arrays) refuse("it has too many arrays");
  if (!in_section_ || !type || !name || !components || !offset || *components < 1 ||
      *components > most_components || attribute(tag, "format") != "appended" || bytes_of(*type) == 0)
    refuse(fmt::format("the array <{}> is not understood", tag));
  arrays_.push_back({section_, std::string(*name), std::string(*type), *components, *offset});
}

const VtuReader::Array* VtuReader::find(Section section, std::string_view name) const {
  for (const Array& array : arrays_)
    if (array.section == section && array.name == name) return &array;
  return nullptr;
}

const VtuReader::Array& VtuReader::get(Section section, std::string_view name) const {
  const Array* array = find(section, name);
  if (array == nullptr) refuse(fmt::format("it has no array {}", name));
  return *array;
}

std::uint64_t VtuReader::number(std::uint64_t at) const {
  std::uint64_t value = 0;
  if (at > data_.size() || data_.size() - at < sizeof(value)) refuse("its data is cut off");
  std::memcpy(&value, data_.data() + at, sizeof(value));
  return value;
}

std::uint64_t VtuReader::most_values(const Array& array) const {
  if (array.section == Section::PointData || array.section == Section::Points)
    return static_cast<std::uint64_t>(points_) * array.components;
  const auto cells = static_cast<std::uint64_t>(cells_);
  if (array.section == Section::CellData) return cells * array.components;
  // The two ends of a wall that is a cylinder are polygons of all of its points.
  return cells * most_corners + 2 * static_cast<std::uint64_t>(points_);
}

std::string VtuReader::unpacked(const Array& array) const {
  const std::uint64_t blocks = number(array.offset);
  const std::uint64_t block_size = number(array.offset + 8);
  const std::uint64_t last_size = number(array.offset + 16);
  // A block takes at least the eight bytes of its size: more blocks than that cannot be there.
  constexpr std::uint64_t largest_block = 1U << 30U;
  if (blocks > data_.size() / 8 || block_size > largest_block || last_size > block_size)
    refuse(fmt::format("the array {} has a wrong header", array.name));
  const std::uint64_t whole_blocks = blocks > 0 && last_size > 0 ? blocks - 1 : blocks;
  if (block_size > 0 && whole_blocks * block_size + last_size > most_values(array) * bytes_of(array.type))
    refuse(fmt::format("the array {} has more numbers than points or cells", array.name));
  std::uint64_t at = array.offset + 24 + 8 * blocks;
  std::string result;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t packed = number(array.offset + 24 + 8 * block);
    if (at > data_.size() || packed > data_.size() - at) refuse("its data is cut off");
    uLongf size = block + 1 == blocks && last_size > 0 ? last_size : block_size;
    const uLongf expected = size;
    const std::size_t start = result.size();
    result.resize(start + size);
    if (uncompress(reinterpret_cast<Bytef*>(result.data() + start), &size,
                   reinterpret_cast<const Bytef*>(data_.data() + at), packed) != Z_OK ||
        size != expected)
      refuse(fmt::format("the array {} does not unpack", array.name));
    at += packed;
  }
  if (result.size() % (bytes_of(array.type) * array.components) != 0)
    refuse(fmt::format("the array {} has a part of a tuple", array.name));
  return result;
}

void VtuReader::check_count(const Array& array, std::size_t count) const {
  if (array.section == Section::Cells && array.name == "connectivity") return;
  const bool by_point = array.section == Section::PointData || array.section == Section::Points;
  const auto tuples = static_cast<std::size_t>(by_point ? points_ : cells_);
  if (count != tuples * array.components)
    refuse(fmt::format("the array {} has {} numbers for {} {}", array.name, count, tuples,
                       by_point ? "points" : "cells"));
}

std::vector<float> VtuReader::reals(Section section, std::string_view name, int components) const {
  const Array& array = get(section, name);
  if (array.components != components)
    refuse(fmt::format("the array {} has {} components, expected {}", name, array.components, components));
  if (array.type != "Float32") refuse(fmt::format("the array {} is not of Float32", name));
  std::vector<float> values = copied<float, float>(unpacked(array));
  check_count(array, values.size());
  return values;
}

std::vector<std::int64_t> VtuReader::integers(Section section, std::string_view name) const {
  const Array& array = get(section, name);
  if (array.components != 1) refuse(fmt::format("the array {} has more than one component", name));
  const std::string bytes = unpacked(array);
  std::vector<std::int64_t> values;
  if (array.type == "UInt8")
    values = copied<std::uint8_t, std::int64_t>(bytes);
  else if (array.type == "Int32")
    values = copied<std::int32_t, std::int64_t>(bytes);
  else if (array.type == "Int64")
    values = copied<std::int64_t, std::int64_t>(bytes);
  else
    refuse(fmt::format("the array {} is not of integers", name));
  check_count(array, values.size());
  if (section == Section::Cells && name == "connectivity")
    for (const std::int64_t point : values)
      if (point < 0 || point >= points_)
        refuse(fmt::format("a cell has the point {}, which does not exist", point));
  return values;
}

}  // namespace crumple::report
