// SPDX-License-Identifier: BSD-3-Clause
// A stack of square plates 0.1 apart, one on each rank: which plates are near the nodes of each?
#include <array>
#include <cellsearch/distributed/distributed.hpp>
#include <cellsearch/distributed/mpi_transport.hpp>
#include <cstdio>
#include <string>

namespace {

void search_plates(cellsearch::Transport& transport) {
  const int rank = transport.rank();
  std::array<double, 12> positions{0, 0, 0.1 * rank, 1, 0, 0.1 * rank, 1, 1, 0.1 * rank, 0, 1, 0.1 * rank};
  const std::array<cellsearch::Index, 4> connectivity{0, 1, 2, 3};  // in the numbers of this rank
  const std::array<cellsearch::GlobalId, 4> node_id{4 * rank, 4 * rank + 1, 4 * rank + 2, 4 * rank + 3};
  const std::array<cellsearch::GlobalId, 1> segment_id{rank};

  cellsearch::RankScene own;
  own.scene.positions = cellsearch::Positions(positions);
  own.scene.segments = cellsearch::Segments(connectivity);
  own.scene.expansion = 0.15;
  own.node_id = node_id;  // in those of the whole model
  own.segment_id = segment_id;

  cellsearch::Distributed search(transport);  // keep it from search to search
  const cellsearch::NodeCandidates& found = search.find(own);
  std::string plates;
  for (const cellsearch::Index held : found.of(0)) {
    plates.append(" ").append(std::to_string(search.segments().id[static_cast<std::size_t>(held)]));
  }

  // All plates rise by 1; ghosts follow their owners.
  for (const std::size_t z : {2U, 5U, 8U, 11U}) positions[z] += 1.0;
  search.start_update(cellsearch::Positions(positions));  // messages travel
  search.finish_update();
  const cellsearch::Index corner = search.segments().nodes_of(0)[0];
  std::printf("rank %d, first node: plates%s; the lowest is now at %.1f\n", rank, plates.c_str(),
              search.positions()[corner][2]);
}

}  // namespace

int main(int argc, char** argv) {
  const cellsearch::MpiSession session(argc, argv);
  cellsearch::MpiTransport transport(MPI_COMM_WORLD);
  try {
    cellsearch::run_rank(transport, search_plates);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rank %d: %s\n", transport.rank(), error.what());
    return 1;
  }
}
