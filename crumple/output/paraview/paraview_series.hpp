// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/files/csv_file.hpp"
#include "output/paraview/paraview_walls.hpp"
#include "output/paraview/vtu_file.hpp"
#include "output/results/block_places.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Removes the frames of a run from the number `first` on from a folder of results, those of its walls as
/// well; its collection stays. Other files are left alone.
void remove_frames(const std::filesystem::path& folder, const std::string& name, int first = 0);

/// The frames of a run for ParaView: `<name>.pvd` and `vtu/<name>_000000.vtu`, `..._000001.vtu`, ... Points
/// and cells are in the order of the deck. Rigid walls that have a shape are a second part of each frame,
/// `vtu/<name>_walls_000000.vtu`. Every file is replaced as a whole, so that what lies in the folder
/// loads at any moment.
class ParaviewSeries {
 public:
  /// Makes the folders and removes frames that an earlier run of that name left, unless they are continued.
  /// `all_fields`: stress tensors, plastic strain by surface and change of thickness as well. Throws
  /// WriteError.
  ParaviewSeries(std::filesystem::path folder, std::string name, const View& view,
                 Opening opening = Opening::New, bool all_fields = false);

  /// Declares the frames so far, for a restart.
  void declare(domain::StateList& list);
  /// To be called after a restart has filled what was declared: frames behind those, and those that are not
  /// there any more, are dropped. Throws WriteError.
  void resume();

  /// Adds the present state as the next frame. Throws WriteError.
  void write_frame(const View& view);

  int frames() const { return static_cast<int>(times_.size()); }
  std::filesystem::path collection() const { return folder_ / (name_ + ".pvd"); }

 private:
  void remove_earlier_frames() const;
  void pack_constant_arrays(const View& view);
  std::vector<VtuArray> point_fields(const View& view);
  std::vector<VtuArray> cell_fields(const View& view);
  struct CellResults;
  template <std::size_t Count, class Number, class OfShell, class OfSolid, class OfLine>
  VtuArray cell_array(const std::string& name, const CellResults& results, OfShell of_shell, OfSolid of_solid,
                      OfLine of_line);
  void add_detailed_fields(const CellResults& results, const View& view, std::vector<VtuArray>& fields);
  bool has_lines() const { return !beam_place_.empty() || !discrete_place_.empty(); }
  std::size_t cell_count() const {
    return place_.size() + solid_place_.size() + beam_place_.size() + discrete_place_.size();
  }
  std::string frame_name(int frame) const;
  std::string walls_name(int frame) const;
  std::string collection_text() const;

  std::filesystem::path folder_;
  std::string name_;
  bool all_fields_;
  std::vector<double> times_;
  VtuPacker packer_;
  ParaviewWalls walls_;
  BlockPlaces place_;  ///< of the shells
  BlockPlaces solid_place_;
  BlockPlaces beam_place_;
  BlockPlaces discrete_place_;
  std::vector<VtuArray> topology_;  ///< connectivity, offsets, types
  VtuArray node_id_;
  VtuArray part_id_;
  VtuArray element_id_;
};

}  // namespace crumple::output
