// SPDX-License-Identifier: BSD-3-Clause
// cellsearch-bench: measures all methods on scenes of any size, compares their answers, draws the curves.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "contestant.hpp"
#include "measurement.hpp"
#include "memory_counter.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "report.hpp"
#include "scenes.hpp"

namespace cellsearch::bench {
namespace {

void print_list() {
  std::cout << "Scenes:\n";
  for (const scenes::Family& family : scenes::families()) {
    std::cout << "  " << family.number << "  " << family.name << ": " << family.description << "\n";
  }
  std::cout << "Methods:\n";
  for (const ContestantKind& kind : contestants()) {
    std::cout << "  " << kind.name << ": " << kind.setup << (kind.threaded ? "" : "; one thread") << "\n";
  }
  for (const AbsentPeer& peer : absent_peers()) {
    std::cout << "  " << peer.name << ": missing; install " << peer.package << " and build again\n";
  }
  if (!MemoryCounter::available()) std::cout << "This build cannot count memory.\n";
}

/// The methods that the user names; `named` says whether by their own names.
struct Choice {
  std::vector<ContestantKind> kinds{};
  std::vector<std::string> named{};
};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Choice choose(const std::vector<std::string>& names) {
  const std::vector<ContestantKind> all = contestants();
  for (const std::string& name : names) {
    const auto is_named = [&](const ContestantKind& kind) { return kind.name == name; };
    if (name == "all" || name == "own" || name == "peers") continue;
    if (std::any_of(all.begin(), all.end(), is_named)) continue;
    for (const AbsentPeer& peer : absent_peers()) {
      if (peer.name == name) {
        throw UsageError("This program was built without " + name + ": install " + peer.package +
                         " and build it again.");
      }
    }
    throw UsageError("There is no method \"" + name + "\"; see --list.");
  }
  Choice choice;
  choice.named = names;
  for (const ContestantKind& kind : all) {
    if (has(names, kind.name) || has(names, "all") || has(names, kind.peer ? "peers" : "own")) {
      choice.kinds.push_back(kind);
    }
  }
  return choice;
}

std::vector<scenes::Family> choose_scenes(const std::vector<int>& numbers) {
  const std::span<const scenes::Family> all = scenes::families();
  std::vector<scenes::Family> result;
  for (const int number : numbers) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const scenes::Family& family) { return family.number == number; });
    if (found == all.end()) throw UsageError("There is no scene " + std::to_string(number) + "; see --list.");
    result.push_back(*found);
  }
  if (numbers.empty()) result.assign(all.begin(), all.end());
  return result;
}

/// Tells on standard error what runs: one line rewritten in place on a terminal, else a line for each scene.
class Progress {
 public:
  void scene(const std::string& name) {
    scene_ = name;
    if (!terminal_) std::fprintf(stderr, "%s\n", name.c_str());
  }
  void operator()(const std::string& text) const {
    if (terminal_) std::fprintf(stderr, "\r\033[K%s: %s ", scene_.c_str(), text.c_str());
  }
  void end() const {
    if (terminal_) std::fprintf(stderr, "\r\033[K");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::string scene_{};
};

class Bench {
 public:
  Bench(const Options& options, const Choice& choice) : options_(options), choice_(choice) {
    if (!options.csv.empty()) csv_.emplace(options.csv);
    if (!options.plots.empty()) std::filesystem::create_directories(options.plots);
  }

  void run(const scenes::Family& family) {
    for (const int nodes : options_.nodes) {
      progress_.scene("scene " + std::to_string(family.number) + " (" + family.name + "), " +
                      std::to_string(nodes) + " nodes");
      progress_("making the scene");
      scenes::Mesh mesh = family.make(nodes, 42);
      if (options_.shuffled) mesh.shuffle(7);
      for (const int threads : options_.threads) run(family, mesh, threads);
    }
    draw(family);
  }

  void end() const {
    std::cout << exponents(measurements_);
    if (!options_.plots.empty()) std::cout << "Plots: " << options_.plots << "\n";
  }

 private:
  void run(const scenes::Family& family, const scenes::Mesh& mesh, int threads) {
    std::vector<ContestantKind> kinds;
    std::string left_out;
    for (const ContestantKind& kind : choice_.kinds) {
      const bool too_many = static_cast<double>(mesh.node_count()) > kind.most_nodes;
      if (too_many && !has(choice_.named, kind.name)) {
        left_out += (left_out.empty() ? "" : ", ") + kind.name;
      } else if (threads == 1 || kind.threaded) {
        kinds.push_back(kind);
      }
    }
    Protocol protocol;
    protocol.threads = threads;
    protocol.repeats = options_.repeats;
    // Short runs vary more. One repeat is for those who only want to see that it works.
    if (options_.repeats > 1) {
      const double more = std::clamp(1e5 / static_cast<double>(mesh.node_count()), 1.0, 10.0);
      protocol.repeats = static_cast<int>(options_.repeats * more);
    }
    protocol.seconds = options_.seconds;
    protocol.progress = [&](const std::string& text) { progress_(text); };
    const Results results = measure(mesh, family.number, kinds, protocol);
    progress_.end();
    std::cout << table("Scene " + std::to_string(family.number) + ", " + family.name + ", " +
                           (options_.shuffled ? "shuffled" : "natural") + " order, " +
                           std::to_string(threads) + (threads == 1 ? " thread" : " threads"),
                       results);
    if (!left_out.empty())
      std::cout << "  left out, too slow for so many nodes unless named: " << left_out << "\n";
    std::cout << std::endl;
    if (csv_) csv_->write(results.measurements);
    measurements_.insert(measurements_.end(), results.measurements.begin(), results.measurements.end());
  }

  void draw(const scenes::Family& family) const {
    if (options_.plots.empty()) return;
    std::vector<std::string> peers;
    for (const ContestantKind& kind : choice_.kinds) {
      if (kind.peer) peers.push_back(kind.name);
    }
    for (const int threads : options_.threads) {
      const std::string suffix = options_.threads.size() > 1 ? "_threads" + std::to_string(threads) : "";
      const std::filesystem::path file =
          std::filesystem::path(options_.plots) / ("scene" + std::to_string(family.number) + suffix + ".svg");
      const std::string title = "Scene " + std::to_string(family.number) + ": " + family.description + " (" +
                                std::to_string(threads) + (threads == 1 ? " thread" : " threads") +
                                (options_.shuffled ? ", shuffled)" : ")");
      write_plot(file.string(), title, curves(measurements_, family.number, threads), peers);
    }
  }

  const Options& options_;
  const Choice& choice_;
  Progress progress_;
  std::optional<CsvFile> csv_;
  std::vector<Measurement> measurements_;
};

int run(const std::vector<std::string>& arguments) {
  const Options options = parse_options(arguments);
  if (options.help || options.list) {
    if (options.help) std::cout << help_text();
    if (options.list) print_list();
    return 0;
  }
  const Choice choice = choose(options.methods);
  const std::vector<scenes::Family> families = choose_scenes(options.scenes);
  Bench bench(options, choice);
  for (const scenes::Family& family : families) bench.run(family);
  bench.end();
  return 0;
}

}  // namespace
}  // namespace cellsearch::bench

int main(int argc, char** argv) {
  try {
    return cellsearch::bench::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const cellsearch::bench::UsageError& error) {
    std::fprintf(stderr, "cellsearch-bench: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "\ncellsearch-bench: %s\n", error.what());
    return 1;
  }
}
