// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/distributed/solo_transport.hpp"

#include <algorithm>
#include <stdexcept>

#include "receive.hpp"
#include "reduce.hpp"

namespace cellsearch {

class SoloExchange final : public Exchange {
 public:
  explicit SoloExchange(Traffic& traffic) : traffic_(traffic) {}

  void start(std::span<const Outgoing> sends, std::span<Incoming> receives) override {
    if (under_way_) throw std::logic_error("The last round of this exchange is not finished.");
    if (sends.size() > 1 || receives.size() != sends.size()) {
      throw std::logic_error("A single rank can send one message to itself, and must receive it.");
    }
    next_ = -1;
    for (std::size_t slot = 0; slot < sends.size(); ++slot) {
      receive(receives[slot], sends[slot].bytes);
      ++traffic_.messages;
      traffic_.bytes += static_cast<Offset>(sends[slot].bytes.size());
      next_ = static_cast<int>(slot);
    }
    under_way_ = true;
  }

  int finish_next() override {
    const int slot = next_;
    if (slot < 0) under_way_ = false;
    next_ = -1;
    return slot;
  }

 private:
  Traffic& traffic_;
  int next_ = -1;
  bool under_way_ = false;
};

std::unique_ptr<Exchange> SoloTransport::open_exchange() {
  return std::make_unique<SoloExchange>(traffic_);
}

void SoloTransport::start_allreduce(Reduction how, std::span<double> values) {
  ++traffic_.reductions;
  // The one NaN that several ranks would give, too.
  if (how != Reduction::Sum) join(how, values.data(), values.data(), values.size());
}

void SoloTransport::start_allreduce(Reduction /*how*/, std::span<std::int64_t> /*values*/) {
  ++traffic_.reductions;
}

void SoloTransport::allgather(std::span<const std::byte> own, Gathered& all) {
  all.bytes.assign(own.begin(), own.end());
  all.first.resize(2);
  all.first[0] = 0;
  all.first[1] = static_cast<Offset>(own.size());
  ++traffic_.gathers;
  traffic_.bytes_given += all.first[1];
  traffic_.bytes_gathered += all.first[1];
}

void SoloTransport::gather(int /*root*/, std::span<const std::byte> own, Gathered& all) {
  allgather(own, all);
}

void SoloTransport::barrier() {
  ++traffic_.reductions;
}

void SoloTransport::fault(std::string_view /*message*/) noexcept {}

}  // namespace cellsearch
