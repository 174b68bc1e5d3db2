// SPDX-License-Identifier: BSD-3-Clause
#include "mpi_connection.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "cellsearch/distributed/mpi_transport.hpp"
#include "distributed/reduce.hpp"

namespace cellsearch {

namespace {

/// True once a transport of this process has seen a fault: requests are left over, and MPI cannot be ended in
/// order.
std::atomic<bool>& any_fault() {
  static std::atomic<bool> seen{false};
  return seen;
}

void join_minimum(void* more, void* joined, int* count, MPI_Datatype* /*type*/) {
  join(Reduction::Min, static_cast<const double*>(more), static_cast<double*>(joined),
       static_cast<std::size_t>(*count));
}

void join_maximum(void* more, void* joined, int* count, MPI_Datatype* /*type*/) {
  join(Reduction::Max, static_cast<const double*>(more), static_cast<double*>(joined),
       static_cast<std::size_t>(*count));
}

}  // namespace

int mpi_count(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("A message has more than 2147483647 bytes.");
  }
  return static_cast<int>(bytes);
}

MpiConnection::MpiConnection(MPI_Comm communicator) {
  int initialised = 0;
  MPI_Initialized(&initialised);
  if (initialised == 0) throw TransportFault(-1, "MPI is not initialised.");
  check(MPI_Comm_dup(communicator, &messages));
  check(MPI_Comm_dup(communicator, &faults_));
  MPI_Comm_set_errhandler(messages, MPI_ERRORS_RETURN);
  MPI_Comm_set_errhandler(faults_, MPI_ERRORS_RETURN);
  check(MPI_Comm_rank(messages, &rank));
  check(MPI_Comm_size(messages, &size));
  check(MPI_Op_create(join_minimum, 1, &minimum));
  check(MPI_Op_create(join_maximum, 1, &maximum));
}

MpiConnection::~MpiConnection() {
  if (faulty_) return;  // requests may be left over
  MPI_Op_free(&minimum);
  MPI_Op_free(&maximum);
  MPI_Comm_free(&messages);
  MPI_Comm_free(&faults_);
}

void MpiConnection::check(int code) {
  if (code == MPI_SUCCESS) return;
  int kind = MPI_ERR_UNKNOWN;
  MPI_Error_class(code, &kind);
  if (kind == MPI_ERR_TRUNCATE) throw std::length_error("A message is longer than expected.");
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  throw TransportFault(rank, "MPI: " + std::string(text.data(), static_cast<std::size_t>(length)));
}

void MpiConnection::throw_fault() {
  any_fault() = true;
  throw TransportFault(fault_rank_,
                       "Rank " + std::to_string(fault_rank_) + " is at fault: " + fault_message_);
}

void MpiConnection::watch(unsigned turn) {
  if (faulty_) throw_fault();
  // Faults are rare; a processor that has more ranks than cores must get on with the others.
  if (turn % 16 == 15) {
    int there = 0;
    MPI_Status status;
    check(MPI_Iprobe(MPI_ANY_SOURCE, 0, faults_, &there, &status));
    if (there != 0) {
      std::array<char, longest> text{};
      check(
          MPI_Recv(text.data(), static_cast<int>(longest), MPI_CHAR, status.MPI_SOURCE, 0, faults_, &status));
      faulty_ = true;
      fault_rank_ = status.MPI_SOURCE;
      fault_message_.assign(text.data());
      throw_fault();
    }
  }
  if (turn >= 256) std::this_thread::yield();
}

void MpiConnection::wait(MPI_Request& request) {
  for (unsigned turn = 0;; ++turn) {
    int done = 0;
    check(MPI_Test(&request, &done, MPI_STATUS_IGNORE));
    if (done != 0) return;
    watch(turn);
  }
}

void MpiConnection::wait_all(std::vector<MPI_Request>& all) {
  for (MPI_Request& request : all) wait(request);
  all.clear();
}

void MpiConnection::report_fault(std::string_view message) noexcept {
  if (faulty_) return;
  faulty_ = true;
  fault_rank_ = rank;
  any_fault() = true;
  const std::size_t length = std::min(message.size(), longest - 1);
  std::copy_n(message.begin(), length, sent_.begin());
  for (int other = 0; other < size; ++other) {
    if (other == rank) continue;
    // Short enough to leave at once, whether anyone receives it or not.
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Isend(sent_.data(), static_cast<int>(longest), MPI_CHAR, other, 0, faults_, &request);
    MPI_Request_free(&request);
  }
}

MpiSession::MpiSession(int& argc, char**& argv) {
  int level = MPI_THREAD_SINGLE;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  if (level < MPI_THREAD_FUNNELED) {
    MPI_Finalize();
    throw std::runtime_error("This MPI cannot be used beside threads (MPI_THREAD_FUNNELED).");
  }
}

MpiSession::~MpiSession() {
  if (!any_fault()) {
    MPI_Finalize();
    return;
  }
  MPI_Request together = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &together);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  int done = 0;
  while (done == 0 && std::chrono::steady_clock::now() < end) {
    MPI_Test(&together, &done, MPI_STATUS_IGNORE);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  MPI_Abort(MPI_COMM_WORLD, 1);
}

}  // namespace cellsearch
