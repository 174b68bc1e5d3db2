// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

#include "output/d3plot/d3plot_words.hpp"
#include "output/files/csv_file.hpp"

namespace crumple::output {

/// The files of a d3plot family: `d3plot` with the geometry, `d3plot01` to `d3plot99`, `d3plot100`, ... with
/// the states. Each can be read at any moment, also while a state is added and after a kill.
class D3plotFamily {
 public:
  /// LS-DYNA's default size of a file: 7 times 512 * 512 words.
  static constexpr std::size_t default_file_words = std::size_t{7} * 512 * 512;

  /// Removes a family that lies in the folder and writes the first file; if it is continued, that is left to
  /// resume(). Throws WriteError.
  D3plotFamily(std::filesystem::path folder, D3plotWords geometry, std::size_t file_words,
               Opening opening = Opening::New);

  /// Declares how many files and states there are, for a restart.
  void declare(domain::StateList& list);
  /// Whether the files hold the states that were declared; true if there are none to hold.
  bool states_are_there() const { return files_ == 0 || is_whole(); }
  /// To be called after a restart has filled what was declared: states behind those are removed. Begins a new
  /// family where files are missing. Throws WriteError.
  void resume();

  /// Adds a state to the last file, or to a new one where that would grow beyond its size; a state is never
  /// split, so that one that is larger has a file of its own. Throws WriteError.
  void add_state(D3plotWords state);

  std::filesystem::path first_file() const { return folder_ / "d3plot"; }

 private:
  void begin();
  bool is_whole() const;
  void remove_files_after(int last) const;
  std::filesystem::path last_file() const;
  void append(const D3plotWords& state) const;

  std::filesystem::path folder_;
  D3plotWords geometry_;  ///< until the first file is written
  std::size_t file_words_ = default_file_words;
  int files_ = 0;          ///< with states
  std::size_t words_ = 0;  ///< of the states in the last file
};

}  // namespace crumple::output
