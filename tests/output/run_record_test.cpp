// SPDX-License-Identifier: BSD-3-Clause
#include "output/run_record.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "output/sample.hpp"

namespace crumple::output::run_record_test {
namespace {

class RunRecordTest : public SampleTest {
 protected:
  nlohmann::json written(const RunRecord& record) {
    write_run_record(folder_, record, view());
    return nlohmann::json::parse(read(folder_ / "run.json"));
  }
};

TEST_F(RunRecordTest, HasEveryDocumentedName) {
  domain_.contacts.push_back({.id = 2, .method = "linked-cell", .searches = 12});
  RunRecord record;
  record.checks.push_back({"a", 0.5, 1, true, "b", {}});
  const auto json = written(record);
  for (const char* name : {"version",
                           "deck",
                           "deck_hash",
                           "perturbation",
                           "seed",
                           "termination",
                           "reason",
                           "end_time",
                           "cycles",
                           "nodes",
                           "elements",
                           "threads",
                           "precision",
                           "isa",
                           "search",
                           "wall_seconds",
                           "loop_seconds",
                           "ns_per_element_cycle",
                           "peak_memory_bytes",
                           "energy",
                           "added_mass",
                           "state_hash",
                           "timings",
                           "contact",
                           "ties",
                           "embedded_beams",
                           "units",
                           "parts",
                           "plane_walls",
                           "checks",
                           "warnings",
                           "left_out",
                           "files"})
    EXPECT_TRUE(json.contains(name)) << name;
  for (const char* name : {"error", "kinetic", "internal", "hourglass", "contact", "friction", "rigidwall",
                           "damping", "external_work", "eroded", "total", "initial_total", "ratio"})
    EXPECT_TRUE(json["energy"].contains(name)) << name;
  for (const char* name : {"elements", "contact_search", "contact_local", "contact_forces", "constraints",
                           "integrate", "output"})
    EXPECT_TRUE(json["timings"].contains(name)) << name;
  for (const char* name :
       {"searches", "candidates", "active_pairs", "worst_penetration", "search", "timings"})
    EXPECT_TRUE(json["contact"][0].contains(name)) << name;
  for (const char* name : {"name", "value", "limit", "pass", "source"})
    EXPECT_TRUE(json["checks"][0].contains(name)) << name;
}

TEST_F(RunRecordTest, HashesAreHexadecimalAndCountsNumbers) {
  RunRecord record;
  record.state_hash = 0x00ab;
  go_to(0.5, 1000);
  domain_.execution.threads = 2;
  record.loop_seconds = 3e-3;
  record.files = {"run.pvd"};
  const auto json = written(record);
  EXPECT_EQ(json["state_hash"], "00000000000000ab");
  EXPECT_EQ(json["nodes"], 6);
  EXPECT_EQ(json["elements"]["shells"], 3);
  EXPECT_EQ(json["cycles"], 1000);
  EXPECT_EQ(json["precision"], "double");
  EXPECT_DOUBLE_EQ(json["ns_per_element_cycle"], 2000) << "3e6 ns x 2 threads / 3 shells / 1000 cycles";
  EXPECT_EQ(json["files"][0], "run.pvd");
}

TEST_F(RunRecordTest, SaysWhatTheSearchOfAContactCost) {
  domain::ContactReport contact;
  contact.search = {.expansion = 0.25,
                    .node_visits = 700,
                    .cell_visits = 90,
                    .participants = 40,
                    .cells = 60,
                    .bytes = 400,
                    .find_seconds = 0.5};
  contact.times.search = 0.75;
  domain_.contacts.push_back(contact);
  const auto written_contact = written({})["contact"][0];
  const nlohmann::json expected = {{"expansion", 0.25},  {"node_visits", 700}, {"cell_visits", 90},
                                   {"participants", 40}, {"cells", 60},        {"bytes", 400}};
  EXPECT_EQ(written_contact["search"], expected);
  EXPECT_EQ(written_contact["timings"]["find"], 0.5);
  EXPECT_EQ(written_contact["timings"]["search"], 0.75);
}

TEST_F(RunRecordTest, SaysWhatBecameOfBeamsInSolids) {
  domain::Embedding embedding;
  embedding.id = 8;
  embedding.nodes.resize(3);
  embedding.outside = {41, 42};
  embedding.released = 1;
  embedding.lost = 0.25;
  domain_.embeddings.push_back(embedding);
  const auto beams = written({})["embedded_beams"];
  ASSERT_EQ(beams.size(), 1U);
  EXPECT_EQ(beams[0]["id"], 8);
  EXPECT_EQ(beams[0]["coupled"], 3);
  EXPECT_EQ(beams[0]["outside"], 2);
  EXPECT_EQ(beams[0]["released"], 1);
  EXPECT_EQ(beams[0]["energy"], 0.25);
}

TEST_F(RunRecordTest, WhatIsNotANumberIsNullAndBadTextDoesNotStopIt) {
  domain_.energy.kinetic = std::nan("");
  model_.title = "caf\xe9";
  RunRecord record;
  record.termination = "error";
  const auto json = written(record);
  EXPECT_TRUE(json["energy"]["kinetic"].is_null());
  EXPECT_EQ(json["termination"], "error");
}

}  // namespace
}  // namespace crumple::output::run_record_test
