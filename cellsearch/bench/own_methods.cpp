// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string_view>

#include "cellsearch/search.hpp"
#include "contestant.hpp"
#include "memory_counter.hpp"

namespace cellsearch::bench {
namespace {

/// A Search that is kept, as a solver keeps it.
class OwnMethod : public Contestant {
 public:
  OwnMethod(Method method, int threads) : search_({.method = method, .threads = threads}) {}

  void build(const Scene& scene) override { search_.build(scene); }
  const Candidates& query() override { return search_.query(); }

 private:
  Search search_;
};

/// A new Search for every search: nothing is kept, every page of memory is new.
class FreshMethod : public Contestant {
 public:
  FreshMethod(Method method, int threads) : settings_{.method = method, .threads = threads} {}

  void build(const Scene& scene) override {
    search_.emplace(settings_);
    search_->build(scene);
  }
  const Candidates& query() override { return search_->query(); }
  void forget() override {
    search_.reset();
    give_back_free_memory();
  }

 private:
  Settings settings_;
  std::optional<Search> search_;
};

}  // namespace

std::vector<ContestantKind> own_contestants() {
  std::vector<ContestantKind> result;
  for (const Method method : methods()) {
    ContestantKind kind;
    kind.name = name_of(method);
    kind.setup = "this library; one Search object, kept";
    kind.threaded = true;
    if (method == Method::BruteForce) kind.most_nodes = 2e4;
    kind.make = [method](int threads) { return std::make_unique<OwnMethod>(method, threads); };
    result.push_back(kind);
    if (kind.name == "production") {
      kind.name = "production-first";
      kind.setup = "this library; a new Search object each time";
      kind.make = [method](int threads) { return std::make_unique<FreshMethod>(method, threads); };
      result.push_back(kind);
    }
  }
  return result;
}

}  // namespace cellsearch::bench
