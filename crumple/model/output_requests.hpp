// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// The tables over time that *DATABASE_<name> asks for.
enum class HistoryFile {
  Glstat,   ///< energies of the model
  Matsum,   ///< energies and momenta of the parts
  Rwforc,   ///< forces on rigid walls
  Rcforc,   ///< resultant forces of contact interfaces
  Nodout,   ///< motion of nodes
  Elout,    ///< stresses and strains of elements
  Deforc,   ///< forces of discrete elements
  Sleout,   ///< energies of contact interfaces
  Spcforc,  ///< forces of supports
  Secforc,  ///< forces in cross-sections
  Rbdout,   ///< motion of rigid bodies
  Ncforc,   ///< contact forces by node
  Swforc,   ///< forces of spot welds
  Jntforc,  ///< forces of joints
  Abstat,   ///< control volumes of airbags and tyres
};
inline constexpr std::size_t history_files = static_cast<std::size_t>(HistoryFile::Abstat) + 1;

/// How often one of them is to be written, and in which of LS-DYNA's forms besides our own.
struct HistoryRequest {
  bool asked = false;   ///< the deck has the card
  double interval = 0;  ///< DT [time]; 0 spreads a default number of rows over the run
  bool ascii = false;   ///< BINARY 1, 3 or blank
  bool binary = false;  ///< BINARY 2, 3 or blank: into binout
};

/// A cut through the model, whose force *DATABASE_SECFORC asks for: the elements pull on the nodes.
struct CrossSection {
  UserId id = 0;
  std::string title;
  std::vector<Index> nodes;      ///< of the cut
  std::vector<Index> shells;     ///< that lie on one side of it
  std::vector<Index> solids;     ///< the same
  std::vector<Index> beams;      ///< the same
  std::vector<Index> discretes;  ///< the same
};

/// *DATABASE_EXTENT_BINARY: what the states of d3plot and elout hold.
struct StateExtent {
  int solid_history = 0;       ///< NEIPH: further history variables of solids
  int shell_history = 0;       ///< NEIPS: of shells, at each point
  int shell_points = 3;        ///< MAXINT: points through the thickness
  bool strains = false;        ///< STRFLG
  bool stresses = true;        ///< SIGFLG
  bool plastic_strain = true;  ///< EPSFLG
  bool resultants = true;      ///< RLTFLG
  bool energy = true;          ///< ENGFLG: internal energy and thickness
};

/// *DATABASE_BINARY_D3DUMP and _RUNRSF: when to write what a run can be taken up from.
struct RestartRequests {
  long dump_cycles = 0;     ///< cycles between files that are kept; 0 is never
  long running_cycles = 0;  ///< cycles between files that replace each other; 0 is never
  int running_files = 1;    ///< NR: how many of these are kept beside the one before
};

/// *INTERFACE_SPRINGBACK_LSDYNA: parts whose state at the end of the run is written for another run.
struct SpringbackRequest {
  struct Hold {
    Index node = no_index;
    int translation = 0;  ///< TC, as *NODE has it
    int rotation = 0;     ///< RC
  };
  std::vector<Index> parts;  ///< ascending; empty: nothing is written
  std::vector<Hold> holds;   ///< supports of the other run
};

/// Axes in which the motion of a node is written (*DATABASE_HISTORY_NODE_LOCAL).
struct NodeAxes {
  Index node = no_index;
  std::array<std::array<double, 3>, 3> axes{};  ///< of unit length, in global components; at time zero
  /// Nodes whose present places give the axes, x from the first to the second, the third in the plane x, y;
  /// no_index: the axes stay.
  std::array<Index, 3> moving{no_index, no_index, no_index};
};

/// What to write and how often.
struct OutputRequests {
  double state_interval = 0;  ///< *DATABASE_BINARY_D3PLOT [time]; 0 if the deck does not ask
  std::array<HistoryRequest, history_files> histories;
  std::vector<Index> history_nodes;      ///< *DATABASE_HISTORY_NODE
  std::vector<NodeAxes> history_axes;    ///< of some of these, by ascending node, each once
  std::vector<Index> history_shells;     ///< *DATABASE_HISTORY_SHELL
  std::vector<Index> history_solids;     ///< *DATABASE_HISTORY_SOLID
  std::vector<Index> history_beams;      ///< *DATABASE_HISTORY_BEAM
  std::vector<Index> history_discretes;  ///< *DATABASE_HISTORY_DISCRETE
  std::vector<CrossSection> cross_sections;
  StateExtent extent;
  RestartRequests restart;
  SpringbackRequest springback;

  const HistoryRequest& of(HistoryFile file) const { return histories[static_cast<std::size_t>(file)]; }
  HistoryRequest& of(HistoryFile file) { return histories[static_cast<std::size_t>(file)]; }
};

}  // namespace crumple::model
