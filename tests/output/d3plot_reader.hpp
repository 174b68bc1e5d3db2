// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads a d3plot family back, from the description of the format alone and sharing nothing with the writer:
// sizes are worked out from the control block as other readers do.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace crumple::output {

class D3plotFile {
 public:
  explicit D3plotFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("no file " + path.string());
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (bytes_.empty() || bytes_.size() % 2048 != 0)
      throw std::runtime_error("not a multiple of 512 words: " + path.string());
  }
  std::size_t words() const { return bytes_.size() / 4; }
  std::int32_t integer(std::size_t word) const { return at<std::int32_t>(word); }
  float real(std::size_t word) const { return at<float>(word); }
  bool ends(std::size_t word) const { return real(word) == -999999.0F; }
  std::vector<std::int32_t> integers(std::size_t word, std::size_t count) const {
    std::vector<std::int32_t> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(integer(word + i));
    return values;
  }
  std::vector<float> reals(std::size_t word, std::size_t count) const {
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(real(word + i));
    return values;
  }
  /// Text of so many words without the blanks at its end.
  std::string text(std::size_t word, std::size_t count) const {
    std::string value = bytes_.substr(4 * word, 4 * count);
    value.erase(value.find_last_not_of(' ') + 1);
    return value;
  }

 private:
  template <class Number>
  Number at(std::size_t word) const {
    if (4 * word + 4 > bytes_.size()) throw std::runtime_error("beyond the end of the file");
    Number value;
    std::memcpy(&value, bytes_.data() + 4 * word, sizeof(value));
    return value;
  }
  std::string bytes_;
};

/// A state, cut into its sections.
struct ReadState {
  float time = 0;
  std::vector<float> globals, positions, velocities, accelerations;
  std::vector<float> solids, beams, shells;
  std::vector<float> alive_solids, alive_shells, alive_beams;

  /// The numbers of one element of a section.
  static std::vector<float> of(const std::vector<float>& section, std::size_t element, std::size_t values) {
    const auto first = section.begin() + static_cast<std::ptrdiff_t>(element * values);
    return {first, first + static_cast<std::ptrdiff_t>(values)};
  }
};

class D3plotReader {
 public:
  explicit D3plotReader(const std::filesystem::path& folder) : root(folder / "d3plot") {
    nodes = count(16);
    solids = count(23);
    beams = count(28);
    shells = count(31);
    parts = count(51);
    std::size_t at = 64;
    const auto section = [&](std::size_t words) {
      const std::size_t start = at;
      at += words;
      return start;
    };
    node_section = section(3 * nodes);
    solid_section = section(9 * solids);
    beam_section = section(6 * beams);
    shell_section = section(5 * shells);
    numbering_section = section(count(39));
    if (!root.ends(at)) throw std::runtime_error("no end of the geometry");
    title_section = at + 1;
    for (int number = 1;; ++number) {
      const auto path = folder / ((number < 10 ? "d3plot0" : "d3plot") + std::to_string(number));
      if (!std::filesystem::exists(path)) break;
      read_states(D3plotFile(path));
    }
  }

  /// A list of the numbering: user numbers of nodes, solids, beams, shells; of parts in order, as numbered
  /// inside, and the inside numbers in order.
  std::vector<std::int32_t> numbers(std::size_t list) const {
    const std::vector<std::size_t> sizes{nodes, solids, beams, shells, parts, parts, parts};
    std::size_t at = numbering_section + 16;
    for (std::size_t i = 0; i < list; ++i) at += sizes[i];
    return root.integers(at, sizes[list]);
  }

  D3plotFile root;
  std::size_t nodes = 0, solids = 0, beams = 0, shells = 0, parts = 0;
  std::size_t node_section = 0, solid_section = 0, beam_section = 0, shell_section = 0;
  std::size_t numbering_section = 0, title_section = 0;
  std::vector<ReadState> states;
  std::vector<std::size_t> states_of_file;

 private:
  std::size_t count(std::size_t word) const { return static_cast<std::size_t>(root.integer(word)); }

  void read_states(const D3plotFile& file) {
    std::size_t at = 0;
    states_of_file.push_back(0);
    const auto take = [&](std::size_t words) {
      at += words;
      return file.reals(at - words, words);
    };
    while (!file.ends(at)) {
      ReadState state;
      state.time = file.real(at++);
      state.globals = take(count(18));
      state.positions = take(3 * nodes * count(20));
      state.velocities = take(3 * nodes * count(21));
      state.accelerations = take(3 * nodes * count(22));
      state.solids = take(count(27) * solids);
      state.beams = take(count(30) * beams);
      state.shells = take(count(33) * shells);
      if (root.integer(36) > -10000) throw std::runtime_error("no deletion table");
      state.alive_solids = take(solids);
      state.alive_shells = take(shells);
      state.alive_beams = take(beams);
      states.push_back(state);
      ++states_of_file.back();
    }
  }
};

}  // namespace crumple::output
