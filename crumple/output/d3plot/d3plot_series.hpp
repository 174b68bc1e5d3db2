// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

#include "output/d3plot/d3plot_family.hpp"
#include "output/d3plot/d3plot_state.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// The states of a run in LS-DYNA's d3plot files, for programs that read these.
class D3plotSeries {
 public:
  /// Writes the first file and removes those of an earlier run; if they are continued, that is left to
  /// resume(). The folder must exist. Files with states have at most `file_words` words. Throws WriteError.
  D3plotSeries(const std::filesystem::path& folder, const View& view,
               std::size_t file_words = D3plotFamily::default_file_words, Opening opening = Opening::New);

  /// Declares the states so far, for a restart.
  void declare(domain::StateList& list) {
    family_.declare(list);
    state_.declare(list);
  }
  /// Whether the files hold the states that were declared; true if there are none to hold.
  bool is_whole() const { return family_.states_are_there(); }
  /// To be called after a restart has filled what was declared. Throws WriteError.
  void resume() { family_.resume(); }

  /// Adds the present state. Throws WriteError.
  void write_state(const View& view) { family_.add_state(state_.words(view)); }

  std::filesystem::path first_file() const { return family_.first_file(); }

 private:
  D3plotFamily family_;
  D3plotState state_;
};

}  // namespace crumple::output
