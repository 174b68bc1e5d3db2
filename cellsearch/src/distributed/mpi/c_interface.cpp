// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <string>

#include "c_handle.hpp"
#include "cellsearch/distributed/cellsearch_mpi.h"
#include "cellsearch/distributed/distributed.hpp"
#include "cellsearch/distributed/mpi_transport.hpp"

using cellsearch::Distributed;
using cellsearch::Error;
using cellsearch::GlobalId;
using cellsearch::HeldSegments;
using cellsearch::Index;
using cellsearch::NodeCandidates;
using cellsearch::Settings;
using cellsearch::TransportFault;
using cellsearch::c_interface::copy_shifted;
using cellsearch::c_interface::demand;
using cellsearch::c_interface::guarded;
using cellsearch::c_interface::Handle;
using cellsearch::c_interface::LentRows;
using cellsearch::c_interface::Refusal;

/// Behind the opaque pointer.
struct cellsearch_ranks {
  explicit cellsearch_ranks(MPI_Comm communicator) : transport(communicator), search(transport) {}

  cellsearch::MpiTransport transport;
  Distributed search;
  Settings settings;
  const GlobalId* node_id = nullptr;
  const GlobalId* segment_id = nullptr;
  bool found = false;
  bool agreed = false;  // errors of input are those of all ranks
  LentRows rows;
  cellsearch::Array<Index> corners;
  std::string fault;
};

namespace {

bool are_same(const Settings& one, const Settings& other) {
  const bool domains = one.domain.has_value() == other.domain.has_value() &&
                       (!one.domain || (one.domain->box.lo == other.domain->box.lo &&
                                        one.domain->box.hi == other.domain->box.hi &&
                                        one.domain->cells == other.domain->cells));
  return domains && one.method == other.method && one.cell_edge == other.cell_edge &&
         one.cell_factor == other.cell_factor && one.cells_per_node == other.cells_per_node &&
         one.instruction_set == other.instruction_set && one.threads == other.threads;
}

/// What all ranks return alike leaves them in step. All else must reach the others, which would wait.
template <class Call>
int32_t guarded_on_all(cellsearch_ranks* ranks, cellsearch_handle* handle, const Call& call) noexcept {
  if (ranks != nullptr && handle == nullptr) ranks->transport.fault("The search of a rank is null.");
  return guarded(handle, [&](Handle& own) {
    demand(ranks != nullptr, CELLSEARCH_BAD_ARGUMENT, "The ranks are null.");
    ranks->agreed = false;
    try {
      call(own);
    } catch (const TransportFault& fault) {
      ranks->fault = fault.what();
      throw Refusal{CELLSEARCH_TRANSPORT_FAULT, ranks->fault.c_str()};
    } catch (const Refusal& refusal) {
      if (refusal.status != CELLSEARCH_NOT_BUILT) ranks->transport.fault(refusal.message);
      throw;
    } catch (const Error& error) {
      if (!ranks->agreed) ranks->transport.fault(error.what());
      throw;
    } catch (const std::exception& error) {
      ranks->transport.fault(error.what());
      throw;
    }
  });
}

void demand_search(const cellsearch_ranks* ranks) {
  demand(ranks != nullptr, CELLSEARCH_BAD_ARGUMENT, "The ranks are null.");
  demand(ranks->found, CELLSEARCH_NOT_BUILT, "There was no successful search of the ranks.");
}

cellsearch::RankScene scene_of(const cellsearch_ranks& ranks, Handle& own) {
  cellsearch::RankScene scene;
  scene.scene = own.scene_from_zero();
  const std::size_t nodes = scene.scene.positions.count();
  const std::size_t segments = scene.scene.segments.count();
  demand((ranks.node_id != nullptr || nodes == 0) && (ranks.segment_id != nullptr || segments == 0),
         CELLSEARCH_BAD_ARGUMENT, "The global numbers are not set.");
  scene.node_id = {ranks.node_id, nodes};
  scene.segment_id = {ranks.segment_id, segments};
  return scene;
}

}  // namespace

extern "C" {

cellsearch_ranks* cellsearch_ranks_create(int32_t communicator) {
  try {
    // MPI_Comm_f2c itself ends the program before MPI_Init.
    int is_initialised = 0;
    if (MPI_Initialized(&is_initialised) != MPI_SUCCESS || is_initialised == 0) return nullptr;
    return new cellsearch_ranks(MPI_Comm_f2c(communicator));
  } catch (...) {
    return nullptr;
  }
}

void cellsearch_ranks_destroy(cellsearch_ranks* ranks) {
  delete ranks;
}

int32_t cellsearch_ranks_set_ids(cellsearch_ranks* ranks, cellsearch_handle* handle, const int64_t* node_id,
                                 const int64_t* segment_id) {
  return guarded(handle, [&](const Handle& /*own*/) {
    demand(ranks != nullptr, CELLSEARCH_BAD_ARGUMENT, "The ranks are null.");
    ranks->node_id = node_id;
    ranks->segment_id = segment_id;
  });
}

int32_t cellsearch_ranks_find(cellsearch_ranks* ranks, cellsearch_handle* handle, const int64_t** first,
                              const int32_t** segment, int64_t* pairs) {
  return guarded_on_all(ranks, handle, [&](Handle& own) {
    ranks->found = false;
    if (!are_same(ranks->settings, own.settings)) {
      ranks->search.set(own.settings);
      ranks->settings = own.settings;
    }
    const cellsearch::RankScene scene = scene_of(*ranks, own);
    ranks->agreed = true;
    const NodeCandidates& found = ranks->search.find(scene);
    ranks->rows.lend(found.first, found.segment, own.base, own.settings.threads).give(first, segment, pairs);
    ranks->found = true;
  });
}

int32_t cellsearch_ranks_held(cellsearch_ranks* ranks, cellsearch_handle* handle,
                              cellsearch_held_parts* held) {
  return guarded(handle, [&](Handle& own) {
    demand_search(ranks);
    demand(held != nullptr, CELLSEARCH_BAD_ARGUMENT, "The place for what is held is null.");
    const Distributed& search = ranks->search;
    const HeldSegments& segments = search.segments();
    copy_shifted<Index>(segments.corner, own.base, own.settings.threads, ranks->corners);
    held->segments = segments.count();
    held->own_nodes = search.own_nodes();
    held->ghost_nodes = search.ghost_nodes();
    held->segment_id = segments.id.data();
    held->owner = segments.owner.data();
    held->corner = ranks->corners.data();
    held->ghost_node_id = search.ghost_node_ids().data();
    held->xyz = search.positions().values().data();
  });
}

int32_t cellsearch_ranks_update(cellsearch_ranks* ranks, cellsearch_handle* handle) {
  return guarded_on_all(ranks, handle, [&](const Handle& own) {
    demand_search(ranks);
    ranks->search.update(own.scene.positions);
  });
}

}  // extern "C"
