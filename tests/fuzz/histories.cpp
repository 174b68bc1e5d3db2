// SPDX-License-Identifier: BSD-3-Clause
// Any bytes at all are a file of histories: the readers must answer with curves or with a sentence, and never
// crash.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "compare/readers/ascii_reader.hpp"
#include "compare/readers/binout_reader.hpp"
#include "compare/readers/csv_reader.hpp"

namespace {

void expect_whole(const std::vector<crumple::compare::Curve>& curves) {
  for (const crumple::compare::Curve& curve : curves)
    if (curve.times.empty() || curve.times.size() != curve.values.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crumple;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const std::string_view name : compare::ascii_files()) expect_whole(compare::read_ascii(bytes, name));
  try {
    expect_whole(compare::read_csv(bytes, "any"));
  } catch (const Error&) {
    // A sentence is an answer.
  }
  try {
    expect_whole(compare::read_binout({compare::LsdaFile(bytes)}));
  } catch (const Error&) {
    // A sentence is an answer.
  }
  return 0;
}
