// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/lsda_file.hpp"

#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace crumple::compare {

namespace {

enum Command : std::uint64_t {
  ChangeFolder = 2,
  Data = 3,
  Symbol = 4,
  BeginTable = 5,
  EndTable = 6,
  TableOffset = 7
};

/// Bytes of one number by type.
constexpr std::array<std::size_t, 11> widths = {0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8};
constexpr std::size_t longest_path = 4096;

std::size_t width_of(int type) {
  return type >= 1 && type <= 10 ? widths[static_cast<std::size_t>(type)] : 0;
}

/// `to` as seen from the folder `from`; paths begin with a slash and have none at their ends.
std::string joined(const std::string& from, std::string_view to) {
  std::vector<std::string_view> names;
  const auto add_names = [&](std::string_view path) {
    while (!path.empty()) {
      const std::string_view name = path.substr(0, path.find('/'));
      path.remove_prefix(std::min(path.size(), name.size() + 1));
      if (name == ".." && !names.empty()) names.pop_back();
      if (!name.empty() && name != "." && name != "..") names.push_back(name);
    }
  };
  if (!to.starts_with('/')) add_names(from);
  add_names(to);
  std::string path;
  for (const std::string_view name : names) path.append("/").append(name);
  return path;
}

}  // namespace

LsdaFile::LsdaFile(std::string bytes) : bytes_(std::move(bytes)) {
  if (!read_header()) throw Error("it does not begin as an LSDA file (binout) does.");
  if (read_tables()) return;
  variables_.clear();
  scan_records();
  if (damage_.empty()) damage_ = "its list of variables is damaged; they were looked for one by one.";
}

bool LsdaFile::read_header() {
  if (bytes_.size() < 8) return false;
  std::array<std::size_t, 7> head{};
  for (std::size_t i = 0; i < head.size(); ++i) head[i] = static_cast<unsigned char>(bytes_[i]);
  header_width_ = head[0];
  length_width_ = head[1];
  offset_width_ = head[2];
  command_width_ = head[3];
  type_width_ = head[4];
  little_endian_ = head[5] == 1;
  for (const std::size_t width : {length_width_, offset_width_, command_width_, type_width_})
    if (width < 1 || width > 8) return false;
  return header_width_ >= 8 && head[5] <= 1 && head[6] == 0;
}

bool LsdaFile::fits(std::uint64_t place, std::uint64_t size) const {
  return place <= bytes_.size() && size <= bytes_.size() - place;
}

std::uint64_t LsdaFile::unsigned_at(std::size_t place, std::size_t width) const {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const std::size_t byte = little_endian_ ? width - 1 - i : i;
    value = value << 8U | static_cast<unsigned char>(bytes_[place + byte]);
  }
  return value;
}

bool LsdaFile::read_record(std::uint64_t place, Record& record) const {
  const std::size_t head = length_width_ + command_width_;
  if (!fits(place, head)) return false;
  record.length = unsigned_at(place, length_width_);
  record.command = unsigned_at(place + length_width_, command_width_);
  record.body = place + head;
  return record.length >= head;
}

bool LsdaFile::read_tables() {
  Record first;
  if (!read_record(header_width_, first) || first.command != TableOffset || !fits(first.body, offset_width_))
    return false;
  std::uint64_t place = unsigned_at(first.body, offset_width_);
  // A file without a table yet has none to be damaged, but may have data.
  if (place == 0) return false;
  std::uint64_t before = 0;
  while (place != 0) {
    // Tables are appended one after the other: going back would be a circle.
    if (place <= before) return false;
    before = place;
    std::uint64_t next = 0;
    if (!read_table(place, next)) return false;
    place = next;
  }
  return true;
}

bool LsdaFile::read_table(std::uint64_t place, std::uint64_t& next) {
  Record record;
  if (!read_record(place, record) || record.command != BeginTable) return false;
  // The length in this record is that of the whole table.
  place = record.body;
  std::string folder;
  while (read_record(place, record) && fits(place, record.length)) {
    const std::size_t body_length = record.length - (record.body - place);
    if (record.command == EndTable) {
      if (body_length < offset_width_) return false;
      next = unsigned_at(record.body, offset_width_);
      return true;
    }
    if (record.command == ChangeFolder) {
      if (body_length > longest_path) return false;
      folder = joined(folder, std::string_view(bytes_).substr(record.body, body_length));
    } else if (record.command == Symbol) {
      if (!read_symbol(record, folder)) return false;
    } else {
      return false;
    }
    place += record.length;
  }
  return false;
}

bool LsdaFile::read_symbol(const Record& record, const std::string& folder) {
  const std::size_t body_length = record.length - length_width_ - command_width_;
  const std::size_t tail = type_width_ + offset_width_ + length_width_;
  if (body_length <= tail || body_length - tail > longest_path) return false;
  const std::size_t name_length = body_length - tail;
  const std::string_view name = std::string_view(bytes_).substr(record.body, name_length);
  const std::size_t place = record.body + name_length;
  const std::uint64_t type = unsigned_at(place, type_width_);
  const std::uint64_t offset = unsigned_at(place + type_width_, offset_width_);
  const std::uint64_t count = unsigned_at(place + type_width_ + offset_width_, length_width_);
  Record data;
  Variable variable;
  std::string stored_name;
  if (!read_record(offset, data) || data.command != Data || !fits(offset, data.length) ||
      !read_data(offset, data, variable, stored_name))
    return false;
  if (stored_name != name || static_cast<std::uint64_t>(variable.type) != type || variable.count < count)
    return false;
  variable.count = count;
  // Variables do not overlap: a file lists no more than it holds.
  listed_bytes_ += count * width_of(variable.type);
  if (listed_bytes_ > bytes_.size()) return false;
  variables_.insert_or_assign(joined(folder, name), variable);
  return true;
}

bool LsdaFile::read_data(std::uint64_t place, const Record& record, Variable& variable,
                         std::string& name) const {
  const std::uint64_t end = place + record.length;
  std::uint64_t at = record.body;
  if (end - at < type_width_ + 1) return false;
  const std::uint64_t type = unsigned_at(at, type_width_);
  if (type < 1 || type > 10) return false;
  variable.type = static_cast<int>(type);
  at += type_width_;
  const std::size_t name_length = static_cast<unsigned char>(bytes_[at]);
  ++at;
  if (name_length == 0 || end - at < name_length) return false;
  name = bytes_.substr(at, name_length);
  at += name_length;
  variable.place = at;
  variable.count = (end - at) / width_of(variable.type);
  return true;
}

void LsdaFile::scan_records() {
  std::string folder;
  std::uint64_t place = header_width_;
  while (place < bytes_.size()) {
    Record record;
    if (!read_record(place, record)) break;
    std::uint64_t length = record.length;
    // The first record of a table has the length of all of it: its records follow.
    if (record.command == BeginTable) length = length_width_ + command_width_;
    if (!fits(place, length)) break;
    const std::size_t body_length = length - (record.body - place);
    if (record.command == ChangeFolder) {
      if (body_length > longest_path) break;
      folder = joined(folder, std::string_view(bytes_).substr(record.body, body_length));
    } else if (record.command == Data) {
      Variable variable;
      std::string name;
      if (!read_data(place, record, variable, name)) break;
      variables_.insert_or_assign(joined(folder, name), variable);
    }
    place += length;
  }
  if (place < bytes_.size())
    damage_ = "it is cut off or damaged at byte " + std::to_string(place) + " of " +
              std::to_string(bytes_.size()) + "; what lies before was read.";
}

double LsdaFile::number_at(std::size_t place, int type) const {
  const std::size_t width = width_of(type);
  const std::uint64_t bits = unsigned_at(place, width);
  if (type == 10) return std::bit_cast<double>(bits);
  if (type == 9) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (type >= 5) return static_cast<double>(bits);
  // The sign bit moved to the top and back again.
  const auto free = static_cast<unsigned>(64 - 8 * width);
  return static_cast<double>(static_cast<std::int64_t>(bits << free) >> free);
}

std::vector<double> LsdaFile::numbers(const Variable& variable) const {
  std::vector<double> values(variable.count);
  const std::size_t width = width_of(variable.type);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = number_at(variable.place + i * width, variable.type);
  return values;
}

}  // namespace crumple::compare
