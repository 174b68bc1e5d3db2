// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

/// The transport of a program that has one rank only. Messages to itself are copied as a round starts.
class SoloTransport final : public Transport {
 public:
  int rank() const noexcept override { return 0; }
  int size() const noexcept override { return 1; }
  std::unique_ptr<Exchange> open_exchange() override;
  void start_allreduce(Reduction how, std::span<double> values) override;
  void start_allreduce(Reduction how, std::span<std::int64_t> values) override;
  void finish_allreduce() override {}
  void allgather(std::span<const std::byte> own, Gathered& all) override;
  void gather(int root, std::span<const std::byte> own, Gathered& all) override;
  void barrier() override;
  void fault(std::string_view message) noexcept override;
};

}  // namespace cellsearch
