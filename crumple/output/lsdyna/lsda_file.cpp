// SPDX-License-Identifier: BSD-3-Clause
#include "output/lsdyna/lsda_file.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <system_error>
#include <utility>

namespace crumple::output {

namespace {

enum class Command : std::uint8_t {
  Folder = 2,
  Data = 3,
  Variable = 4,
  BeginTable = 5,
  EndTable = 6,
  FirstTable = 7
};

// Numbers of the types of values.
constexpr std::uint8_t characters = 1;
constexpr std::uint8_t integers_of_4 = 3;
constexpr std::uint8_t integers_of_8 = 4;
constexpr std::uint8_t reals_of_8 = 10;

constexpr std::uint64_t head_bytes = 9;  ///< of a record: its length and its command
constexpr std::uint64_t link_bytes = 8;

template <class Number>
void put(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void put_head(std::string& bytes, std::uint64_t length, Command command) {
  put(bytes, length);
  put(bytes, command);
}

void put_folder(std::string& bytes, std::string_view folder) {
  put_head(bytes, head_bytes + folder.size(), Command::Folder);
  bytes += folder;
}

/// Bytes of a length, of an offset, of a command and of a type; the order of bytes; the kind of reals.
std::string header() {
  const char order = std::endian::native == std::endian::little ? 1 : 0;
  return {8, 8, 8, 1, 1, order, 0, 0};
}

template <class Number>
std::string_view bytes_of(std::span<const Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace

LsdaFile::LsdaFile(std::filesystem::path path, Opening opening) : path_(std::move(path)) {
  if (opening == Opening::New) begin();
}

void LsdaFile::begin() {
  file_ = OwnFile::create(path_);
  std::string start = header();
  put_head(start, head_bytes + link_bytes, Command::FirstTable);
  put(start, std::uint64_t{0});
  file_.write_at(0, start);
  length_ = start.size();
}

void LsdaFile::declare(domain::StateList& list) {
  list.keep(path_.filename().string() + "_bytes", "-", domain::Entity::Run, length_);
}

bool LsdaFile::resume() {
  std::error_code fault;
  const std::uint64_t there = std::filesystem::file_size(path_, fault);
  if (fault || there < length_ || length_ < header().size() + head_bytes + link_bytes) {
    begin();
    return false;
  }
  file_ = OwnFile::open(path_);
  file_.truncate(length_);
  // A link to the next table ends every group, and the start of the file.
  file_.write_at(length_ - link_bytes, std::string(link_bytes, '\0'));
  return true;
}

void LsdaFile::enter(std::string_view folder) {
  folder_ = folder;
}

void LsdaFile::add(std::string_view name, std::span<const double> values) {
  add_record(name, reals_of_8, values.size(), bytes_of(values));
}

void LsdaFile::add(std::string_view name, std::span<const std::int64_t> values) {
  using Short = std::int32_t;
  const auto fits = [](std::int64_t value) {
    return value >= std::numeric_limits<Short>::min() && value <= std::numeric_limits<Short>::max();
  };
  if (!std::all_of(values.begin(), values.end(), fits)) {
    add_record(name, integers_of_8, values.size(), bytes_of(values));
    return;
  }
  std::vector<Short> narrow;
  narrow.reserve(values.size());
  for (const std::int64_t value : values) narrow.push_back(static_cast<Short>(value));
  add_record(name, integers_of_4, narrow.size(), bytes_of(std::span<const Short>(narrow)));
}

void LsdaFile::add(std::string_view name, std::string_view text) {
  add_record(name, characters, text.size(), text);
}

void LsdaFile::add_record(std::string_view name, std::uint8_t type, std::uint64_t values,
                          std::string_view bytes) {
  if (values == 0) return;
  if (folder_ != recorded_folder_) {
    put_folder(records_, folder_);
    recorded_folder_ = folder_;
  }
  entries_.push_back({folder_, std::string(name), type, length_ + records_.size(), values});
  put_head(records_, head_bytes + 2 + name.size() + bytes.size(), Command::Data);
  put(records_, type);
  put(records_, static_cast<std::uint8_t>(name.size()));
  records_ += name;
  records_ += bytes;
}

std::string LsdaFile::table() const {
  std::string lines;
  std::string_view folder;
  for (const Entry& entry : entries_) {
    if (entry.folder != folder) put_folder(lines, entry.folder);
    folder = entry.folder;
    put_head(lines, head_bytes + entry.name.size() + 17, Command::Variable);
    lines += entry.name;
    put(lines, entry.type);
    put(lines, entry.record);
    put(lines, entry.values);
  }
  put_head(lines, head_bytes + link_bytes, Command::EndTable);
  put(lines, std::uint64_t{0});
  std::string whole;
  put_head(whole, head_bytes + lines.size(), Command::BeginTable);
  return whole + lines;
}

void LsdaFile::end_group() {
  if (entries_.empty()) return;
  std::string link;
  put(link, length_ + records_.size());
  const std::string added = records_ + table();
  records_.clear();
  entries_.clear();
  // A file that goes on from here without this one's memory says where it is.
  recorded_folder_.clear();
  if (waiting_.empty())
    link_ = link;
  else
    waiting_.replace(waiting_.size() - link_bytes, link_bytes, link);
  waiting_ += added;
  length_ += added.size();
}

void LsdaFile::flush() {
  end_group();
  if (waiting_.empty()) return;
  const std::string added = std::exchange(waiting_, {});
  length_ -= added.size();
  file_.require_name();
  file_.write_at(length_, added);
  file_.write_at(length_ - link_bytes, link_);
  length_ += added.size();
}

}  // namespace crumple::output
