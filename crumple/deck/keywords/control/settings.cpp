// SPDX-License-Identifier: BSD-3-Clause
#include "deck/keywords/control/settings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "deck/format/numbers.hpp"

namespace crumple::deck {

namespace {

constexpr std::string_view known_keys =
    "method, local_search, expansion, cells, domain, precision and defaults";

/// Exactly `count` numbers separated by commas, or nothing.
std::optional<std::vector<double>> numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::optional<double> value = parse_real(trimmed(text.substr(0, comma)));
    if (!value) return std::nullopt;
    values.push_back(*value);
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return values.size() == count ? std::optional(values) : std::nullopt;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

struct Setting {
  std::string_view key;
  std::string_view value;
  const Where& where;
  Report& report;

  void fault(const std::string& expected) const {
    report.error(where, "value", fmt::format("$crumple {}: read \"{}\", expected {}", key, value, expected));
  }
};

void set_cells(const Setting& setting, RawDeck& deck) {
  deck.search_cells = setting.where;
  const auto cells = numbers(setting.value, 3);
  constexpr double limit = std::numeric_limits<Index>::max();
  const bool whole = cells && std::all_of(cells->begin(), cells->end(), [](double n) {
                       return n >= 1 && n <= limit && static_cast<double>(static_cast<Index>(n)) == n;
                     });
  if (!whole || (*cells)[0] * (*cells)[1] * (*cells)[2] > limit) {
    setting.fault("three whole numbers above zero, such as 60,8,8");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) deck.search.cells[i] = static_cast<Index>((*cells)[i]);
}

void set_domain(const Setting& setting, RawDeck& deck) {
  deck.search_domain = setting.where;
  const auto box = numbers(setting.value, 6);
  if (!box || !((*box)[0] < (*box)[1] && (*box)[2] < (*box)[3] && (*box)[4] < (*box)[5])) {
    setting.fault("xmin,xmax,ymin,ymax,zmin,zmax with each minimum below its maximum");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    deck.search.domain_minimum[i] = (*box)[2 * i];
    deck.search.domain_maximum[i] = (*box)[2 * i + 1];
  }
}

void set_one(const Setting& setting, const std::vector<std::string>& methods, RawDeck& deck) {
  if (setting.key == "method") {
    const bool known =
        methods.empty() || std::find(methods.begin(), methods.end(), setting.value) != methods.end();
    if (known && !setting.value.empty())
      deck.search.method = setting.value;
    else
      setting.fault(methods.empty() ? "the name of a search method" : "one of " + listed(methods));
  } else if (setting.key == "local_search") {
    if (setting.value == "inside-outside" || setting.value == "pinballs")
      deck.search.local = setting.value == "pinballs" ? model::LocalSearchKind::Pinballs
                                                      : model::LocalSearchKind::InsideOutside;
    else
      setting.fault("inside-outside or pinballs");
  } else if (setting.key == "expansion") {
    const auto value = parse_real(setting.value);
    if (value && *value > 0)
      deck.search.expansion = *value;
    else
      setting.fault("a length above zero");
  } else if (setting.key == "cells") {
    set_cells(setting, deck);
  } else if (setting.key == "domain") {
    set_domain(setting, deck);
  } else if (setting.key == "precision") {
    if (setting.value == "mixed" || setting.value == "double")
      deck.run.precision = setting.value;
    else
      setting.fault("mixed or double");
  } else if (setting.key == "defaults") {
    deck.takes_ls_dyna_defaults = setting.value == "ls-dyna";
    if (setting.value != "ls-dyna" && setting.value != "crumple") setting.fault("crumple or ls-dyna");
  } else {
    setting.report.error(
        setting.where, "key",
        fmt::format("$crumple: the key \"{}\" is not known; known are {}", setting.key, known_keys));
  }
}

}  // namespace

void read_settings(std::string_view text, const Where& where, const std::vector<std::string>& methods,
                   RawDeck& deck, Report& report) {
  std::size_t start = 0;
  while ((start = text.find_first_not_of(" \t", start)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t", start), text.size());
    const std::string_view pair = text.substr(start, end - start);
    start = end;
    const std::size_t equal = pair.find('=');
    if (equal == std::string_view::npos) {
      report.error(where, "pair",
                   fmt::format("$crumple: read \"{}\", expected key=value without blanks; keys are {}", pair,
                               known_keys));
      continue;
    }
    set_one({pair.substr(0, equal), pair.substr(equal + 1), where, report}, methods, deck);
  }
}

void check_settings(RawDeck& deck, Report& report) {
  if (deck.search_cells && !deck.search_domain)
    report.error(*deck.search_cells, "domain",
                 "$crumple cells needs a domain as well: domain=xmin,xmax,ymin,ymax,zmin,zmax");
  if (deck.search_domain && !deck.search_cells)
    report.error(*deck.search_domain, "cells", "$crumple domain needs cells as well: cells=Nx,Ny,Nz");
  deck.search.has_cells = deck.search_cells && deck.search_domain;
}

}  // namespace crumple::deck
