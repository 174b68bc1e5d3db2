// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads an LSDA file back as other readers do: from one table to the next by their links, sharing nothing
// with the writer.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace crumple::output {

class LsdaReader {
 public:
  struct Array {
    std::uint8_t type = 0;
    std::string bytes;
  };

  explicit LsdaReader(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("no file " + path.string());
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (text(0, 8) != std::string({8, 8, 8, 1, 1, 1, 0, 0})) throw std::runtime_error("another header");
    if (number<std::uint64_t>(8) != 17 || command(8) != 7) throw std::runtime_error("no first table");
    for (std::uint64_t link = 17; number<std::uint64_t>(link) != 0;)
      link = read_table(number<std::uint64_t>(link));
  }

  int tables() const { return tables_; }
  bool has(const std::string& name) const { return arrays_.contains(name); }
  /// Under its whole name, such as "/glstat/d000001/time".
  const Array& array(const std::string& name) const {
    if (!has(name)) throw std::runtime_error("no array " + name);
    return arrays_.at(name);
  }
  std::string characters(const std::string& name) const {
    if (array(name).type != 1) throw std::runtime_error("no text: " + name);
    return array(name).bytes;
  }
  std::vector<double> reals(const std::string& name) const {
    if (array(name).type != 10) throw std::runtime_error("no reals: " + name);
    return values<double, double>(name);
  }
  std::vector<std::int64_t> integers(const std::string& name) const {
    if (array(name).type == 4) return values<std::int64_t, std::int64_t>(name);
    if (array(name).type != 3) throw std::runtime_error("no integers: " + name);
    return values<std::int32_t, std::int64_t>(name);
  }
  /// Folders and arrays right below a folder such as "/glstat/".
  std::set<std::string> below(const std::string& folder) const {
    std::set<std::string> result;
    for (const auto& [name, array] : arrays_)
      if (name.starts_with(folder))
        result.insert(name.substr(folder.size(), name.find('/', folder.size()) - folder.size()));
    return result;
  }
  int states(const std::string& branch) const {
    int count = 0;
    for (const std::string& name : below(branch + "/"))
      if (name[0] == 'd') ++count;
    return count;
  }

 private:
  std::string text(std::uint64_t place, std::uint64_t length) const {
    if (place > bytes_.size() || length > bytes_.size() - place) throw std::runtime_error("the file is cut");
    return bytes_.substr(place, length);
  }
  template <class Number>
  Number number(std::uint64_t place) const {
    const std::string bytes = text(place, sizeof(Number));
    Number result;
    std::memcpy(&result, bytes.data(), sizeof result);
    return result;
  }
  int command(std::uint64_t record) const { return number<std::uint8_t>(record + 8); }

  template <class Stored, class Value>
  std::vector<Value> values(const std::string& name) const {
    const std::string& bytes = array(name).bytes;
    std::vector<Value> result;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Stored)) {
      Stored value;
      std::memcpy(&value, bytes.data() + i, sizeof value);
      result.push_back(value);
    }
    return result;
  }

  /// The place of the link to the next table.
  std::uint64_t read_table(std::uint64_t table) {
    if (command(table) != 5) throw std::runtime_error("no table where the link points to");
    ++tables_;
    const std::uint64_t end = table + number<std::uint64_t>(table);
    std::string folder = "/";
    std::uint64_t record = table + 9;
    for (; command(record) != 6; record += number<std::uint64_t>(record)) {
      const std::uint64_t length = number<std::uint64_t>(record);
      if (command(record) == 2)
        folder = text(record + 9, length - 9);
      else if (command(record) == 4)
        read_entry(folder, record, length);
      else
        throw std::runtime_error("an unknown command in a table");
    }
    if (record + 17 != end) throw std::runtime_error("the table's length is wrong");
    return record + 9;
  }

  void read_entry(const std::string& folder, std::uint64_t record, std::uint64_t length) {
    const std::uint64_t name_length = length - 26;
    const std::string name = text(record + 9, name_length);
    const auto type = number<std::uint8_t>(record + 9 + name_length);
    const auto place = number<std::uint64_t>(record + 10 + name_length);
    const auto count = number<std::uint64_t>(record + 18 + name_length);
    const std::map<int, std::uint64_t> sizes{{1, 1}, {3, 4}, {4, 8}, {10, 8}};
    const std::uint64_t bytes = count * sizes.at(type);
    if (number<std::uint64_t>(place) != 11 + name_length + bytes || command(place) != 3 ||
        number<std::uint8_t>(place + 9) != type || number<std::uint8_t>(place + 10) != name_length ||
        text(place + 11, name_length) != name)
      throw std::runtime_error("the record of " + name + " does not fit its entry");
    arrays_[folder + "/" + name] = {type, text(place + 11 + name_length, bytes)};
  }

  std::string bytes_;
  std::map<std::string, Array> arrays_;
  int tables_ = 0;
};

}  // namespace crumple::output
