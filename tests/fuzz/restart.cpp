// SPDX-License-Identifier: BSD-3-Clause
// A restart file with a right checksum and anything in it: refused with a sentence, or a run that goes on
// some steps and may go wrong numerically. The input is a list of changes to the arrays of a small run with
// contact, and a wall, as a fuzzer would never get past checksum, names and lengths.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "deck/reader.hpp"
#include "timeloop/fitting_state.hpp"
#include "timeloop/simulation.hpp"

namespace {

using namespace crumple;

/// A plate that falls on another, beside a rigid one, over a wall.
const char* const deck_text = R"(*KEYWORD
*CONTROL_TERMINATION
1.0
*NODE
1,0.,0.,0.
2,10.,0.,0.
3,10.,10.,0.
4,0.,10.,0.
5,1.,1.,1.1
6,9.,1.,1.1
7,9.,9.,1.1
8,1.,9.,1.1
9,5.,5.,0.
11,20.,0.,0.
12,30.,0.,0.
13,30.,10.,0.
14,20.,10.,0.
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,5,6,7,8
3,3,11,12,13,14
*PART
lower
1,1,1
*PART
upper
2,1,1
*PART
rigid
3,1,2
*SECTION_SHELL
1,2,0.833,3
1.,1.,1.,1.
*MAT_ELASTIC
1,7.83e-6,207.,0.3
*MAT_RIGID
2,7.83e-6,207.,0.3
*ELEMENT_MASS
1,9,1.e-4
*INITIAL_VELOCITY_GENERATION
2,2,0.,0.,0.,-5.
*CONTACT_AUTOMATIC_SINGLE_SURFACE
0
0.1
1.0
*RIGIDWALL_PLANAR
0
0.,0.,-1.,0.,0.,1.
*END
)";

domain::Execution execution() {
  domain::Execution plain;
  plain.threads = 1;
  return plain;
}

const model::Model& small_model() {
  static const model::Model made = [] {
    deck::ReadOptions options;
    deck::ReadResult result = deck::read_deck_text(deck_text, options);
    if (!result.model) __builtin_trap();
    return std::move(*result.model);
  }();
  return made;
}

/// As a restart file has it after some steps in contact.
const domain::StateSnapshot& good_state() {
  static const domain::StateSnapshot made = [] {
    timeloop::Simulation simulation(small_model(), execution());
    simulation.start();
    for (int step = 0; step < 60; ++step) simulation.step();
    return domain::StateSnapshot(simulation.state());
  }();
  return made;
}

class Source {
 public:
  Source(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return size_ == 0; }
  std::uint64_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::uint64_t word() { return byte() | byte() << 8U; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

void change(domain::StateSnapshot::Array& array, Source& source) {
  const std::uint64_t kind = source.byte() % 8;
  if (kind == 0) {
    array.bytes.resize(source.word() % 4096);
    return;
  }
  if (array.bytes.empty()) return;
  const std::size_t at = source.word() % array.bytes.size();
  double number = 0;
  std::int32_t index = 0;
  const auto put = [&](const void* from, std::size_t bytes) {
    const std::size_t start = at - at % bytes;
    if (start + bytes <= array.bytes.size()) std::memcpy(array.bytes.data() + start, from, bytes);
  };
  switch (kind) {
    case 1:
      array.bytes[at] = static_cast<std::byte>(source.byte());
      break;
    case 2:
      index = static_cast<std::int32_t>(source.word()) - 32768;
      put(&index, sizeof index);
      break;
    case 3:
      index = source.byte() % 2 == 0 ? std::numeric_limits<std::int32_t>::max()
                                     : std::numeric_limits<std::int32_t>::min();
      put(&index, sizeof index);
      break;
    case 4:
      number = std::numeric_limits<double>::quiet_NaN();
      put(&number, sizeof number);
      break;
    case 5:
      number = source.byte() % 2 == 0 ? 1e300 : -std::numeric_limits<double>::infinity();
      put(&number, sizeof number);
      break;
    default:
      number = static_cast<double>(source.word()) - 32768;
      put(&number, sizeof number);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<domain::StateSnapshot::Array> arrays = good_state().arrays();
  Source source(data, size);
  for (int changes = 0; changes < 16 && !source.empty(); ++changes)
    change(arrays[source.byte() % arrays.size()], source);
  const domain::StateSnapshot state(std::move(arrays));
  try {
    timeloop::Simulation simulation(small_model(), execution());
    timeloop::require_fitting_state(state, simulation.state(), simulation.domain());
    state.put_back(simulation.state());
    simulation.resume();
    for (int step = 0; step < 5; ++step) simulation.step();
  } catch (const Error&) {
    // A sentence is an answer.
  }
  return 0;
}
