// SPDX-License-Identifier: BSD-3-Clause
#include "app/preparation/left_out.hpp"

#include <algorithm>
#include <ostream>

#include "app/console/print.hpp"
#include "base/counted.hpp"

namespace crumple::app {

namespace {

using output::LeftOut;

void add_left_out(std::vector<LeftOut>& list, LeftOut item) {
  const auto known = std::find_if(list.begin(), list.end(), [&](const LeftOut& other) {
    return other.name == item.name && other.reason == item.reason;
  });
  if (known == list.end())
    list.push_back(std::move(item));
  else
    known->count += item.count;
}

}  // namespace

std::vector<LeftOut> left_out_of(const deck::ReadResult& deck) {
  std::vector<LeftOut> list;
  for (const deck::Diagnostic& diagnostic : deck.diagnostics) {
    if (diagnostic.missing.empty()) continue;
    const auto reason = diagnostic.severity == deck::Severity::Error ? output::LeftOutReason::NotSupported
                                                                     : output::LeftOutReason::OnRequest;
    add_left_out(list, {diagnostic.missing, reason, diagnostic.count,
                        fmt::format("{}:{}", diagnostic.file, diagnostic.line)});
  }
  for (const deck::IgnoredKeyword& keyword : deck.ignored_keywords)
    if (keyword.why == deck::Omission::Harmless)
      add_left_out(list, {keyword.keyword, output::LeftOutReason::WithoutEffect, keyword.count,
                          fmt::format("{}:{}", keyword.file, keyword.line)});
  return list;
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
