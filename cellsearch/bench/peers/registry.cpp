// SPDX-License-Identifier: BSD-3-Clause
#include "peers/peers.hpp"

namespace cellsearch::bench {

std::vector<ContestantKind> contestants() {
  std::vector<ContestantKind> result = own_contestants();
#ifdef CELLSEARCH_BENCH_EMBREE
  result.push_back(embree_contestant());
#endif
#ifdef CELLSEARCH_BENCH_NANOFLANN
  result.push_back(nanoflann_contestant());
#endif
#ifdef CELLSEARCH_BENCH_FCL
  result.push_back(fcl_contestant());
#endif
#ifdef CELLSEARCH_BENCH_CGAL
  result.push_back(cgal_contestant());
#endif
#ifdef CELLSEARCH_BENCH_BULLET
  result.push_back(bullet_contestant());
#endif
  return result;
}

std::vector<AbsentPeer> absent_peers() {
  std::vector<AbsentPeer> result;
#ifndef CELLSEARCH_BENCH_EMBREE
  result.push_back({"embree", "libembree-dev"});
#endif
#ifndef CELLSEARCH_BENCH_NANOFLANN
  result.push_back({"nanoflann", "libnanoflann-dev"});
#endif
#ifndef CELLSEARCH_BENCH_FCL
  result.push_back({"fcl", "libfcl-dev"});
#endif
#ifndef CELLSEARCH_BENCH_CGAL
  result.push_back({"cgal", "libcgal-dev"});
#endif
#ifndef CELLSEARCH_BENCH_BULLET
  result.push_back({"bullet", "libbullet-dev"});
#endif
  return result;
}

}  // namespace cellsearch::bench
