// SPDX-License-Identifier: BSD-3-Clause
// The checks of any transport over MPI, started by mpirun. With the argument "fault" rank 1 throws, and the
// others must throw TransportFault instead of waiting for it.
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "cellsearch/distributed/mpi_transport.hpp"
#include "distributed_checks.hpp"
#include "transport_checks.hpp"

namespace {

void fail_on_one(cellsearch::Transport& transport) {
  transport.barrier();
  if (transport.rank() == 1) throw std::domain_error("a wheel came off");
  double value = 1.0;
  transport.allreduce(cellsearch::Reduction::Min, std::span<double>(&value, 1));
}

void check(cellsearch::Transport& transport) {
  cellsearch::transport_checks::check_all(transport);
  cellsearch::distributed_checks::check_models(transport, 0, 40);
}

}  // namespace

int main(int argc, char** argv) {
  const cellsearch::MpiSession session(argc, argv);
  const bool fault = argc > 1 && std::strcmp(argv[1], "fault") == 0;
  cellsearch::MpiTransport transport(MPI_COMM_WORLD);
  try {
    cellsearch::run_rank(transport, fault ? fail_on_one : check);
  } catch (const cellsearch::TransportFault& error) {
    std::fprintf(stderr, "rank %d ends: %s\n", transport.rank(), error.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rank %d failed: %s\n", transport.rank(), error.what());
    return 1;
  }
  if (transport.rank() == 0) std::printf("%d ranks: all as expected\n", transport.size());
}
