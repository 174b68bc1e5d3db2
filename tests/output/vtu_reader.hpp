// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads the arrays of a `.vtu` back, from the description of the format alone and sharing nothing with the
// writer.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace crumple::output {

struct ReadArray {
  std::string type;
  int components = 0;
  std::string bytes;

  template <class T>
  std::vector<T> values() const {
    std::vector<T> result(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }
};

class VtuReader {
 public:
  explicit VtuReader(const std::string& text) {
    const std::size_t mark = text.find("<AppendedData encoding=\"raw\">");
    if (mark == std::string::npos) throw std::runtime_error("no appended data");
    head_ = text.substr(0, mark);
    data_ = text.substr(text.find('_', mark) + 1);
    const std::regex array(
        "<DataArray type=\"(\\w+)\" Name=\"(\\w+)\" NumberOfComponents=\"(\\d+)\" "
        "format=\"appended\" offset=\"(\\d+)\"/>");
    for (std::sregex_iterator at(head_.begin(), head_.end(), array), end; at != end; ++at)
      arrays_[(*at)[2]] = {(*at)[1], std::stoi((*at)[3]), unpacked(std::stoul((*at)[4]))};
  }

  const ReadArray& operator[](const std::string& name) const { return arrays_.at(name); }
  bool has(const std::string& name) const { return arrays_.count(name) > 0; }
  const std::string& head() const { return head_; }

 private:
  std::uint64_t number(std::size_t at) const {
    std::uint64_t value = 0;
    if (at + sizeof(value) > data_.size()) throw std::runtime_error("offset beyond the data");
    std::memcpy(&value, data_.data() + at, sizeof(value));
    return value;
  }

  std::string unpacked(std::size_t offset) const {
    const std::uint64_t blocks = number(offset);
    const std::uint64_t block_size = number(offset + 8);
    const std::uint64_t last_size = number(offset + 16);
    std::size_t at = offset + 24 + 8 * blocks;
    std::string result;
    for (std::uint64_t block = 0; block < blocks; ++block) {
      const std::uint64_t packed_size = number(offset + 24 + 8 * block);
      uLongf size = block + 1 == blocks && last_size > 0 ? last_size : block_size;
      const uLongf expected = size;
      std::string bytes(size, '\0');
      if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                     reinterpret_cast<const Bytef*>(data_.data() + at), packed_size) != Z_OK ||
          size != expected)
        throw std::runtime_error("a block does not unpack to its size");
      result += bytes;
      at += packed_size;
    }
    return result;
  }

  std::string head_;
  std::string data_;
  std::map<std::string, ReadArray> arrays_;
};

}  // namespace crumple::output
