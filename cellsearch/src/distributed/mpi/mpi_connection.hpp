// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cellsearch/distributed/transport.hpp"

namespace cellsearch {

/// The length of a message as MPI counts; std::length_error above 2^31 - 1 bytes.
int mpi_count(std::size_t bytes);

/// Communicators, faults, and waiting while watching for faults.
class MpiConnection {
 public:
  explicit MpiConnection(MPI_Comm communicator);
  ~MpiConnection();
  MpiConnection(const MpiConnection&) = delete;
  MpiConnection& operator=(const MpiConnection&) = delete;

  /// Turns an error code of MPI into an exception.
  void check(int code);

  /// Throws TransportFault if a rank has reported a fault. Called in every turn of a wait; `turn` counts
  /// them.
  void watch(unsigned turn);

  /// Waits for requests.
  void wait(MPI_Request& request);
  void wait_all(std::vector<MPI_Request>& all);

  void report_fault(std::string_view message) noexcept;

  MPI_Comm messages = MPI_COMM_NULL;
  int rank = 0;
  int size = 1;
  int channels = 1;  // tag 0 is that of gathers

  MPI_Op minimum = MPI_OP_NULL;
  MPI_Op maximum = MPI_OP_NULL;

  // The reduction under way.
  MPI_Request reduction = MPI_REQUEST_NULL;
  std::span<double> sum{};  // of reals, which waits for its terms
  std::vector<double> terms;

  // Lengths of what the ranks give to a gather.
  std::vector<std::int64_t> lengths;
  std::vector<int> counts;
  std::vector<int> places;
  std::vector<MPI_Request> requests;

 private:
  void throw_fault();

  static constexpr std::size_t longest = 512;

  MPI_Comm faults_ = MPI_COMM_NULL;
  bool faulty_ = false;
  int fault_rank_ = -1;
  std::string fault_message_;
  std::array<char, longest> sent_{};
};

}  // namespace cellsearch
