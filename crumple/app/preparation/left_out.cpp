// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/left_out.hpp"

#include <map>
#include <ostream>
#include <utility>

#include "app/console/print.hpp"
#include "base/counted.hpp"

namespace crumple::app {

namespace {

using output::LeftOut;

class LeftOutList {
 public:
  void add(LeftOut item) {
    const auto [known, is_new] = index_.try_emplace({item.name, item.reason}, list.size());
    if (is_new)
      list.push_back(std::move(item));
    else
      list[known->second].count += item.count;
  }

  std::vector<LeftOut> list;

 private:
  std::map<std::pair<std::string, output::LeftOutReason>, std::size_t> index_;
};

}  // namespace

std::vector<LeftOut> left_out_of(const deck::ReadResult& deck) {
  LeftOutList all;
  for (const deck::Diagnostic& diagnostic : deck.diagnostics) {
    if (diagnostic.missing.empty()) continue;
    const auto reason = diagnostic.severity == deck::Severity::Error ? output::LeftOutReason::NotSupported
                                                                     : output::LeftOutReason::OnRequest;
    all.add({diagnostic.missing, reason, diagnostic.count,
             fmt::format("{}:{}", diagnostic.file, diagnostic.line)});
  }
  for (const deck::IgnoredKeyword& keyword : deck.ignored_keywords)
    if (keyword.why == deck::Omission::Harmless)
      all.add({keyword.keyword, output::LeftOutReason::WithoutEffect, keyword.count,
               fmt::format("{}:{}", keyword.file, keyword.line)});
  return std::move(all.list);
}

void print_left_out(std::ostream& out, const std::vector<LeftOut>& list) {
  using Reason = output::LeftOutReason;
  constexpr std::pair<Reason, const char*> headings[] = {
      {Reason::NotSupported, "Not supported"},
      {Reason::OnRequest, "LEFT OUT ON REQUEST, although it changes the result"},
      {Reason::WithoutEffect, "Left out, without effect on the result"}};
  for (const auto& [reason, heading] : headings) {
    bool is_first = true;
    for (const LeftOut& item : list) {
      if (item.reason != reason) continue;
      if (is_first) print(out, "{}\n", heading);
      is_first = false;
      print(out, "  {} ({}, first at {})\n", item.name, counted(item.count, "time"), item.place);
    }
  }
}

}  // namespace crumple::app
