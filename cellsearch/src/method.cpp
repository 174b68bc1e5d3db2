// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/method.hpp"

#include <array>

#include "finder.hpp"
#include "production/production.hpp"
#include "reference/brute_force.hpp"
#include "reference/bucket_sort.hpp"
#include "reference/linked_cell.hpp"
#include "reference/nbs.hpp"
#include "reference/position_code.hpp"

namespace cellsearch {
namespace {

struct NamedMethod {
  Method method;
  std::string_view name;
};

// One row per method, in the order of the enumeration.
constexpr std::array named_methods{
    NamedMethod{Method::LinkedCell, "linked-cell"},     NamedMethod{Method::BucketSort, "bucket-sort"},
    NamedMethod{Method::PositionCode, "position-code"}, NamedMethod{Method::Nbs, "nbs"},
    NamedMethod{Method::BruteForce, "brute-force"},     NamedMethod{Method::Production, "production"},
};

constexpr std::array method_list{Method::LinkedCell, Method::BucketSort, Method::PositionCode,
                                 Method::Nbs,        Method::BruteForce, Method::Production};
static_assert(method_list.size() == named_methods.size());

}  // namespace

std::span<const Method> methods() {
  return method_list;
}

std::string_view name_of(Method method) {
  return named_methods[static_cast<std::size_t>(method)].name;
}

std::optional<Method> method_named(std::string_view name) {
  for (const NamedMethod& entry : named_methods) {
    if (entry.name == name) return entry.method;
  }
  return std::nullopt;
}

std::unique_ptr<Finder> make_finder(Method method, InstructionSet set) {
  switch (method) {
    case Method::LinkedCell:
      return std::make_unique<LinkedCell>();
    case Method::BucketSort:
      return std::make_unique<BucketSort>();
    case Method::PositionCode:
      return std::make_unique<PositionCode>();
    case Method::Nbs:
      return std::make_unique<Nbs>();
    case Method::BruteForce:
      return std::make_unique<BruteForce>();
    case Method::Production:
      return std::make_unique<Production>(set);
  }
  return nullptr;
}

}  // namespace cellsearch
