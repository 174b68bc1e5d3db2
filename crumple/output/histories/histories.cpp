// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "output/histories/history.hpp"

namespace crumple::output {

namespace {

bool any_wall_moves(const model::Model& model) {
  return std::any_of(model.rigid_walls.begin(), model.rigid_walls.end(), [](const model::RigidWall& wall) {
    return wall.mass > 0 || wall.motion.curve != no_index;
  });
}

/// By constraints, or as beams.
bool has_welds(const View& view) {
  return !view.domain.welds.empty() ||
         std::any_of(view.domain.beams.begin(), view.domain.beams.end(), [](const domain::BeamBlock& block) {
           return block.formulation == model::BeamFormulation::SpotWeld;
         });
}

/// Before the deck could ask for it, the file came as often as glstat does.
double interval_or_glstat(const model::OutputRequests& asked, model::HistoryFile file) {
  return asked.of(asked.of(file).asked ? file : model::HistoryFile::Glstat).interval;
}

/// Of those of *DATABASE_HISTORY_BEAM.
bool has_integrated_beams(const View& view) {
  const auto& beams = view.model.output.history_beams;
  return std::any_of(beams.begin(), beams.end(), [&](Index beam) {
    const model::Part& part = view.model.parts[view.model.beams[beam].part];
    return view.model.beam_sections[part.beam_section].formulation == model::BeamFormulation::Integrated;
  });
}

/// Those that are only written where the deck has their card.
void add_asked(const View& view, std::vector<HistoryEntry>& entries) {
  using File = model::HistoryFile;
  const model::OutputRequests& asked = view.model.output;
  const auto add = [&](File file, bool has_content, std::string_view name, std::string_view header,
                       const auto& make) {
    if (asked.of(file).asked && has_content)
      entries.push_back({name, header, asked.of(file).interval, make(view)});
  };
  add(File::Deforc, !view.model.discretes.empty(), "deforc.csv",
      "time,element,resultant,fx,fy,fz,displacement", make_discrete_history);
  add(File::Elout, !asked.history_shells.empty(), "elout_shells.csv",
      "time,element,plane,point,xx,yy,zz,xy,yz,zx,plastic_strain", make_shell_history);
  add(File::Elout, !asked.history_solids.empty(), "elout_solids.csv",
      "time,element,point,xx,yy,zz,xy,yz,zx,plastic_strain", make_solid_history);
  add(File::Elout, !asked.history_beams.empty(), "elout_beams.csv",
      "time,element,axial,shear_s,shear_t,moment_s,moment_t,torsion,plastic_strain", make_beam_history);
  add(File::Elout, has_integrated_beams(view), "elout_beam_points.csv",
      "time,element,point,s,t,rr,rs,rt,plastic_strain", make_beam_point_history);
  add(File::Secforc, !view.sections.empty(), "secforc.csv", "time,section,fx,fy,fz,mx,my,mz,force,x,y,z",
      [](const View&) { return make_section_history(); });
  add(File::Ncforc, !view.domain.contacts.empty() && view.contact_node_forces, "ncforc.csv",
      "time,interface,side,node,fx,fy,fz", make_contact_node_history);
  add(File::Abstat, !view.domain.control_volumes.empty(), "abstat.csv",
      "time,airbag,volume,pressure,energy,inflow,outflow,mass,temperature,area",
      [](const View&) { return make_airbag_history(); });
  add(File::Spcforc, !view.domain.supports.empty(), "spcforc.csv", "time,node,fx,fy,fz,mx,my,mz",
      [](const View&) { return make_support_history(); });
}

}  // namespace

std::vector<HistoryEntry> histories_of(const View& view) {
  const model::OutputRequests& asked = view.model.output;
  std::vector<HistoryEntry> entries;
  entries.push_back({"glstat.csv",
                     "time,dt,kinetic,internal,hourglass,contact,friction,rigidwall,damping,external_work,"
                     "eroded,total,ratio,added_mass",
                     asked.of(model::HistoryFile::Glstat).interval, make_energy_history()});
  // To find the element takes a look at all: rows few enough that a run does not feel them.
  if (view.controlling)
    entries.push_back({"timestep.csv", "time,dt,kind,element,part", 0, make_step_history(), 200});
  if (view.energy_trace)
    entries.push_back({"energy_residual.csv", "time,kind,id,energy,residual",
                       asked.of(model::HistoryFile::Glstat).interval, make_residual_history()});
  entries.push_back({"matsum.csv", "time,part,internal,kinetic,hourglass,vx,vy,vz,mass",
                     asked.of(model::HistoryFile::Matsum).interval, make_part_history(view)});
  if (!view.domain.walls.empty())
    entries.push_back({"rwforc.csv", "time,wall,normal,fx,fy,fz",
                       asked.of(model::HistoryFile::Rwforc).interval, make_wall_history(view)});
  if (any_wall_moves(view.model))
    entries.push_back({"rwmotion.csv", "time,wall,ux,uy,uz,vx,vy,vz,kinetic",
                       asked.of(model::HistoryFile::Rwforc).interval, make_wall_motion_history()});
  if (!view.domain.contacts.empty() || !view.domain.transducers.empty())
    entries.push_back({"rcforc.csv", "time,interface,side,fx,fy,fz,mass",
                       asked.of(model::HistoryFile::Rcforc).interval, make_contact_history()});
  if (!view.domain.ties.empty())
    entries.push_back({"ties.csv", "time,interface,tied,broken,fx,fy,fz,energy",
                       asked.of(model::HistoryFile::Rcforc).interval, make_tie_history()});
  if (asked.of(model::HistoryFile::Sleout).asked &&
      !(view.domain.contacts.empty() && view.domain.ties.empty()))
    entries.push_back({"sleout.csv", "time,interface,energy,friction",
                       asked.of(model::HistoryFile::Sleout).interval, make_interface_energy_history()});
  if (!view.model.rigid_bodies.empty())
    entries.push_back({"rbdout.csv", "time,body,x,y,z,vx,vy,vz,wx,wy,wz,kinetic,fx,fy,fz",
                       interval_or_glstat(asked, model::HistoryFile::Rbdout), make_rigid_body_history(view)});
  if (has_welds(view))
    entries.push_back({"swforc.csv", "time,weld,axial,shear,broken",
                       interval_or_glstat(asked, model::HistoryFile::Swforc), make_weld_history()});
  if (!view.domain.joints.empty())
    entries.push_back({"jntforc.csv", "time,joint,fx,fy,fz,mx,my,mz,force,moment,energy,damping,opening",
                       interval_or_glstat(asked, model::HistoryFile::Jntforc), make_joint_history()});
  if (!view.domain.joint_stiffnesses.empty())
    entries.push_back(
        {"jntstiff.csv",
         "time,joint,q1,q2,q3,rate1,rate2,rate3,elastic1,elastic2,elastic3,damping1,damping2,damping3,"
         "energy,friction,damped",
         interval_or_glstat(asked, model::HistoryFile::Jntforc), make_joint_stiffness_history()});
  if (!asked.history_nodes.empty())
    entries.push_back({"nodout.csv", "time,node,ux,uy,uz,vx,vy,vz,ax,ay,az,x,y,z",
                       asked.of(model::HistoryFile::Nodout).interval, make_node_history()});
  add_asked(view, entries);
  return entries;
}

}  // namespace crumple::output
