// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "output/files/csv_file.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Rows of each history over a run if the deck does not ask for an interval.
inline constexpr int default_history_points = 1000;

class SampledHistory;

/// One table over time.
class History {
 public:
  virtual ~History() = default;
  virtual void add_rows(const View& view, CsvFile& table) = 0;
  /// Declares what it remembers from row to row, for a restart.
  virtual void declare(domain::StateList& /*list*/) {}
  /// What LS-DYNA has of it: mostly itself, or nothing, or a part for each branch of binout
  /// (sampled_history.hpp).
  virtual std::vector<SampledHistory*> sampled() { return {}; }
};

/// A history of a run: its file, its columns, and the interval that the deck asks for.
struct HistoryEntry {
  std::string_view file;
  std::string_view header;
  double interval = 0;  ///< [time]; 0 if the deck does not ask
  std::unique_ptr<History> history;
  int points = default_history_points;  ///< rows over the run where there is no interval
};

/// Energies of the whole model, as crumple's energy ledger has them.
std::unique_ptr<History> make_energy_history();
/// The time step and the element that controls it.
std::unique_ptr<History> make_step_history();
/// Energy that no motion has put in, by part and contact.
std::unique_ptr<History> make_residual_history();
/// Energies, velocity of the centre of mass, and mass by part. Masses are those of the elements: lumped
/// masses belong to no part.
std::unique_ptr<History> make_part_history(const View& view);
/// Forces on rigid walls, the normal one positive where nodes press: the mean since the row before, so that
/// the sum of force times time is the impulse.
std::unique_ptr<History> make_wall_history(const View& view);
/// Displacement, velocity and kinetic energy of the rigid walls that move.
std::unique_ptr<History> make_wall_motion_history();
/// Resultant force of contact interfaces.
std::unique_ptr<History> make_contact_history();
/// Energies of contact interfaces and tied contacts.
std::unique_ptr<History> make_interface_energy_history();
/// Motion of the nodes of *DATABASE_HISTORY_NODE.
std::unique_ptr<History> make_node_history();

/// Motion of the rigid bodies, and the forces that hold or move them as prescribed.
std::unique_ptr<History> make_rigid_body_history(const View& view);

/// Tension and shear in the spot welds, and whether they are broken.
std::unique_ptr<History> make_weld_history();

/// Forces and moments of joints.
std::unique_ptr<History> make_joint_history();
/// Angles and moments, or displacements and forces, of joint stiffnesses.
std::unique_ptr<History> make_joint_stiffness_history();

/// Nodes that are still tied, and the resultant force of the tied contacts on them.
std::unique_ptr<History> make_tie_history();

/// Forces of springs and dampers: of those of *DATABASE_HISTORY_DISCRETE, or of all.
std::unique_ptr<History> make_discrete_history(const View& view);

/// Stress and plastic strain at every point of the shells of *DATABASE_HISTORY_SHELL, in global axes.
std::unique_ptr<History> make_shell_history(const View& view);
/// The same of the solids of *DATABASE_HISTORY_SOLID.
std::unique_ptr<History> make_solid_history(const View& view);
/// Forces and moments in the beams of *DATABASE_HISTORY_BEAM, in their own axes.
std::unique_ptr<History> make_beam_history(const View& view);
/// Stresses at the points of integrated beams among them.
std::unique_ptr<History> make_beam_point_history(const View& view);

/// Forces and moments in the cross-sections of *DATABASE_CROSS_SECTION.
std::unique_ptr<History> make_section_history();
/// What contacts put on the nodes that they touch.
std::unique_ptr<History> make_contact_node_history(const View& view);

/// What is in the control volumes of *AIRBAG.
std::unique_ptr<History> make_airbag_history();

/// What holds the nodes of *BOUNDARY_SPC, and the sum of it.
std::unique_ptr<History> make_support_history();

/// Every history that has something to show in this model.
std::vector<HistoryEntry> histories_of(const View& view);

}  // namespace crumple::output
