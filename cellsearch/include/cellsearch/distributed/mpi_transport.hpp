// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include <memory>
#include <span>
#include <string_view>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

class MpiConnection;

/// Ranks as processes, over MPI: target cellsearch::mpi. This header and its source are all that includes
/// mpi.h.
///
/// Every wait watches for faults of other ranks, so that a rank that reports one (run_rank) makes the others
/// throw TransportFault. Messages, reductions and gathers of an MPI program around it are not touched: the
/// communicator is duplicated. Calls come from one thread at a time (MPI_THREAD_SERIALIZED, or FUNNELED if
/// that is the main one).
class MpiTransport final : public Transport {
 public:
  /// Collective over `communicator`, which stays the caller's. Throws TransportFault if MPI is not
  /// initialised.
  explicit MpiTransport(MPI_Comm communicator);
  /// Collective, but after a fault.
  ~MpiTransport() override;

  int rank() const noexcept override;
  int size() const noexcept override;
  std::unique_ptr<Exchange> open_exchange() override;
  void start_allreduce(Reduction how, std::span<double> values) override;
  void start_allreduce(Reduction how, std::span<std::int64_t> values) override;
  void finish_allreduce() override;
  void allgather(std::span<const std::byte> own, Gathered& all) override;
  void gather(int root, std::span<const std::byte> own, Gathered& all) override;
  void barrier() override;
  void fault(std::string_view message) noexcept override;

 private:
  std::unique_ptr<MpiConnection> connection_;
};

/// Initialises MPI and ends it: a local variable of main(), made before all transports. After a fault MPI
/// cannot be ended in order: the destructor then waits a moment, so that the other ranks can say what they
/// have to say, and ends the whole job by MPI_Abort. Throws std::runtime_error where this MPI cannot be used
/// beside threads.
class MpiSession {
 public:
  MpiSession(int& argc, char**& argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

}  // namespace cellsearch
