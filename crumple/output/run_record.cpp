// SPDX-License-Identifier: BSD-3-Clause
#include "output/run_record.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <nlohmann/json.hpp>

#include "base/isa.hpp"
#include "output/files/atomic_file.hpp"

namespace crumple::output {

namespace {

using Json = nlohmann::ordered_json;

Json energy_of(const domain::EnergyLedger& energy) {
  return {
      {"error", energy.error()},       {"kinetic", energy.kinetic}, {"internal", energy.internal},
      {"hourglass", energy.hourglass}, {"contact", energy.contact}, {"friction", energy.friction},
      {"rigidwall", energy.rigidwall}, {"damping", energy.damping}, {"external_work", energy.external_work},
      {"eroded", energy.eroded},       {"total", energy.total()},   {"initial_total", energy.initial_total},
      {"ratio", energy.ratio()}};
}

Json left_out_list(const std::vector<LeftOut>& list) {
  Json items = Json::array();
  for (const LeftOut& item : list)
    items.push_back({{"name", item.name},
                     {"reason", name_of(item.reason)},
                     {"count", item.count},
                     {"place", item.place}});
  return items;
}

Json timings_of(const domain::StageTimes& times) {
  return {{"elements", times.elements},
          {"contact_search", times.contact_search},
          {"contact_local", times.contact_local},
          {"contact_forces", times.contact_forces},
          {"constraints", times.constraints},
          {"integrate", times.integrate},
          {"output", times.output}};
}

Json search_of(const domain::SearchReport& search) {
  return {{"expansion", search.expansion},
          {"node_visits", search.node_visits},
          {"cell_visits", search.cell_visits},
          {"participants", search.participants},
          {"cells", search.cells},
          {"bytes", search.bytes}};
}

Json lost_of(const domain::LostContacts& lost) {
  return {{"count", lost.count}, {"cycle", lost.cycle}, {"node", lost.node}, {"segment", lost.segment}};
}

Json contacts_of(const std::vector<domain::ContactReport>& contacts) {
  Json list = Json::array();
  for (const domain::ContactReport& contact : contacts)
    list.push_back(
        {{"id", contact.id},
         {"method", contact.method},
         {"thickness_cut",
          {{"shells", contact.thickness_cut.shells},
           {"from", contact.thickness_cut.from},
           {"to", contact.thickness_cut.to},
           {"shell", contact.thickness_cut.shell},
           {"part", contact.thickness_cut.part}}},
         {"searches", contact.searches},
         {"candidates", contact.candidates},
         {"active_pairs", contact.active_pairs},
         {"penetration", contact.penetration},
         {"worst_penetration", contact.worst_penetration},
         {"deepest_penetration",
          {{"share", contact.deepest.share},
           {"cycle", contact.deepest.cycle},
           {"node", contact.deepest.node},
           {"segment", contact.deepest.segment}}},
         {"initial_penetrations", contact.initial_overlaps.size()},
         {"worst_initial_penetration",
          contact.initial_overlaps.empty() ? 0.0 : contact.initial_overlaps.front().depth},
         {"force", {contact.force.x, contact.force.y, contact.force.z}},
         {"intersections", contact.inspection.intersections},
         {"initial_intersections", contact.inspection.initial_intersections},
         {"worst_intersections",
          {{"count", contact.worst_intersections.count},
           {"cycle", contact.worst_intersections.cycle},
           {"time", contact.worst_intersections.time},
           {"segments",
            {contact.worst_intersections.first_segment, contact.worst_intersections.second_segment}}}},
         {"nodes_in_solids", contact.inspection.nodes_in_solids},
         {"nodes_beyond_mid_surface", contact.inspection.nodes_beyond},
         {"largest_relative_depth", contact.inspection.largest_depth},
         {"percentile_99_relative_depth", contact.inspection.percentile_99},
         {"worst_node", contact.worst_node},
         {"overlap_forces",
          {{"share_of_impulse", contact.overlap_forces.share()},
           {"largest", contact.overlap_forces.largest},
           {"node", contact.overlap_forces.node}}},
         {"withheld_forces",
          {{"count", contact.withheld.count},
           {"largest", contact.withheld.largest},
           {"cycle", contact.withheld.cycle},
           {"node", contact.withheld.node},
           {"segment", contact.withheld.segment}}},
         {"lost_nodes", lost_of(contact.lost_nodes)},
         {"lost_edges", lost_of(contact.lost_edges)},
         {"energy", contact.energy},
         {"friction_energy", contact.friction_energy},
         {"eroded_energy", contact.eroded_energy},
         {"search", search_of(contact.search)},
         {"timings",
          {{"search", contact.times.search},
           {"find", contact.search.find_seconds},
           {"local", contact.times.local},
           {"forces", contact.times.forces}}}});
  return list;
}

Json ties_of(const std::vector<domain::Tie>& ties) {
  Json list = Json::array();
  for (const domain::Tie& tie : ties)
    list.push_back({{"id", tie.id},
                    {"tied", tie.nodes.size()},
                    {"not_tied", tie.untied.size()},
                    {"largest_move", tie.largest_move},
                    {"released", tie.released},
                    {"broken", tie.broken},
                    {"energy", tie.energy}});
  return list;
}

Json embeddings_of(const std::vector<domain::Embedding>& embeddings) {
  Json list = Json::array();
  for (const domain::Embedding& embedding : embeddings)
    list.push_back({{"id", embedding.id},
                    {"coupled", embedding.nodes.size()},
                    {"outside", embedding.outside.size()},
                    {"released", embedding.released},
                    {"energy", embedding.lost}});
  return list;
}

/// Null if there was none.
Json relaxation_of(const RelaxationRecord& record) {
  if (record.cycles == 0) return nullptr;
  return {{"cycles", record.cycles},  {"converged", record.converged != 0},
          {"time", record.time},      {"ratio", record.ratio},
          {"factor", record.factor},  {"energy_error", record.energy_error},
          {"seconds", record.seconds}};
}

Json parts_of(const model::Model& model) {
  Json list = Json::array();
  for (const model::Part& part : model.parts) list.push_back({{"id", part.id}, {"title", part.title}});
  return list;
}

/// Infinite planes have no place among the frames' surfaces. Where they are at time zero; rwmotion.csv tells
/// how they move.
Json plane_walls_of(const model::Model& model) {
  Json list = Json::array();
  for (const model::RigidWall& wall : model.rigid_walls)
    if (wall.shape == model::WallShape::Plane)
      list.push_back({{"id", wall.id}, {"point", wall.point}, {"normal", wall.normal}});
  return list;
}

/// Null if energy was not traced.
Json energy_trace_of(const View& view) {
  if (!view.energy_trace) return nullptr;
  const domain::EnergyTraceReport report = view.energy_trace();
  const auto list_of = [](const std::vector<domain::EnergyResidual>& entries) {
    Json list = Json::array();
    for (const domain::EnergyResidual& entry : entries)
      list.push_back({{"id", entry.id}, {"energy", entry.energy}, {"residual", entry.residual}});
    return list;
  };
  Json worst = Json::array();
  for (const domain::ElementResidual& entry : report.worst)
    worst.push_back({{"part", entry.part},
                     {"kind", entry.kind},
                     {"first", entry.first},
                     {"last", entry.last},
                     {"elements", entry.elements},
                     {"residual", entry.residual},
                     {"fastest_node", entry.node},
                     {"speed", entry.speed},
                     {"place", {entry.place.x, entry.place.y, entry.place.z}}});
  return {
      {"parts", list_of(report.parts)}, {"contacts", list_of(report.contacts)}, {"worst_elements", worst}};
}

/// As numbers where they can be read back as they are.
Json parameters_of(const std::vector<RunParameter>& parameters) {
  Json json = Json::object();
  for (const RunParameter& parameter : parameters) {
    Json value = Json::parse(parameter.value, nullptr, false);
    if (!value.is_number()) value = parameter.value;
    json[parameter.name] = {{"value", std::move(value)},
                            {"source", parameter.by_command_line ? "command line" : "deck"}};
  }
  return json;
}

Json versions_of(const RunRecord& record) {
#if defined(__clang__)
  const std::string compiler = "Clang " __clang_version__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return {{"crumple", record.version},
          {"compiler", compiler},
          {"fmt", FMT_VERSION},
          {"zlib", ZLIB_VERSION},
          {"json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)}};
}

Json checks_of(const std::vector<Check>& checks) {
  Json list = Json::array();
  for (const Check& check : checks) {
    Json entry = {{"name", check.name}, {"value", check.value},   {"limit", check.limit},
                  {"pass", check.pass}, {"source", check.source}, {"source_limit", nullptr}};
    if (check.source_limit) entry["source_limit"] = *check.source_limit;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

const char* name_of(LeftOutReason reason) {
  switch (reason) {
    case LeftOutReason::WithoutEffect:
      return "without effect";
    case LeftOutReason::OnRequest:
      return "on request";
    case LeftOutReason::NotSupported:
      return "not supported";
  }
  return "";
}

double nanoseconds_per_element_cycle(const domain::Domain& domain, double seconds) {
  const double work =
      static_cast<double>(domain::element_count(domain.shells) + domain::element_count(domain.solids) +
                          domain::element_count(domain.beams) + domain::element_count(domain.discretes)) *
      static_cast<double>(domain.clock.cycle);
  return work > 0 ? 1e9 * seconds * domain.execution.threads / work : 0.0;
}

void write_run_record(const std::filesystem::path& folder, const RunRecord& record, const View& view) {
  const domain::Domain& domain = view.domain;
  Json files = Json::array();
  for (const auto& file : record.files) files.push_back(file.generic_string());
  const Json json = {
      {"version", record.version},
      {"deck", record.deck},
      {"deck_hash", fmt::format("{:016x}", record.deck_hash)},
      {"deck_hash_with_parameters", fmt::format("{:016x}", record.deck_hash_with_parameters)},
      {"parameters", parameters_of(record.parameters)},
      {"command", record.command},
      {"options", record.options.empty() ? Json() : Json::parse(record.options, nullptr, false)},
      {"versions", versions_of(record)},
      {"perturbation", record.perturbation},
      {"seed", record.seed},
      {"title", view.model.title},
      {"units", record.units},
      {"termination", record.termination},
      {"reason", record.reason},
      {"end_time", domain.clock.time},
      {"cycles", domain.clock.cycle},
      {"nodes", domain.nodes.count()},
      {"elements",
       {{"shells", domain::element_count(domain.shells)},
        {"solids", domain::element_count(domain.solids)},
        {"beams", domain::element_count(domain.beams)},
        {"discretes", domain::element_count(domain.discretes)}}},
      {"threads", domain.execution.threads},
      {"precision", domain.execution.precision == Precision::Mixed ? "mixed" : "double"},
      {"isa", std::string(isa_name(domain.execution.isa))},
      {"search", view.model.search.method},
      {"wall_seconds", record.wall_seconds},
      {"loop_seconds", record.loop_seconds},
      {"ns_per_element_cycle", nanoseconds_per_element_cycle(domain, record.loop_seconds)},
      {"peak_memory_bytes", record.peak_memory_bytes},
      {"dynamic_relaxation", relaxation_of(record.relaxation)},
      {"energy", energy_of(domain.energy)},
      {"energy_trace", energy_trace_of(view)},
      {"added_mass", domain.added_mass},
      {"state_hash", fmt::format("{:016x}", record.state_hash)},
      {"timings", timings_of(domain.times)},
      {"contact", contacts_of(domain.contacts)},
      {"ties", ties_of(domain.ties)},
      {"embedded_beams", embeddings_of(domain.embeddings)},
      {"parts", parts_of(view.model)},
      {"plane_walls", plane_walls_of(view.model)},
      {"checks", checks_of(record.checks)},
      {"warnings", record.warnings},
      {"left_out", left_out_list(record.left_out)},
      {"files", files}};
  // Titles come from decks in any encoding: bytes that are no UTF-8 must not stop the record.
  write_atomically(folder / "run.json",
                   json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace crumple::output
