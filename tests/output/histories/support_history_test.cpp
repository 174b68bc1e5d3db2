// SPDX-License-Identifier: BSD-3-Clause
// spcforc: which supports have forces and moments.
#include "output/lsda_reader.hpp"
#include "output/recorder.hpp"
#include "output/sample.hpp"

namespace crumple::output::support_history_test {
namespace {

/// Node 0 is fixed along x, node 1 held along axes of its own, node 2 about one after a time.
class SupportHistoryTest : public SampleTest {
 protected:
  SupportHistoryTest() : SampleTest(with_supports()) {
    domain_.supports.clear();
    for (const Index node : {0, 1, 2})
      domain_.supports.push_back({.node = domain_.nodes.domain_node[node], .force = {1, 2, 3}, .moment = {}});
  }
  static model::Model with_supports() {
    model::Model model = sample_model();
    model.fixed_nodes = {{.node = 0, .translation = {true, false, false}, .rotation = {}}};
    model.local_supports.push_back({.node = 1,
                                    .axes = {{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}},
                                    .translation = {true, false, false},
                                    .rotation = {false, false, true}});
    model.local_supports.push_back(
        {.node = 2, .translation = {}, .rotation = {true, false, false}, .birth = 3, .death = 4});
    model.output.of(model::HistoryFile::Spcforc) = {
        .asked = true, .interval = 0.5, .ascii = true, .binary = true};
    return model;
  }
};

TEST_F(SupportHistoryTest, HasWhatIsHeldAlongOtherAxesOrForATime) {
  Recorder recorder(folder_, "run", view());
  recorder.write_due(view());
  const auto id = [&](Index node) -> std::int64_t { return model_.nodes.id[node]; };
  const LsdaReader binout(folder_ / "binout0000");
  EXPECT_EQ(binout.integers("/spcforc/metadata/force_ids"), (std::vector<std::int64_t>{id(0), id(1)}));
  EXPECT_EQ(binout.integers("/spcforc/metadata/moment_ids"), (std::vector<std::int64_t>{id(1), id(2)}));
  int forces = 0;
  int moments = 0;
  for (const std::string& line : lines(folder_ / "spcforc")) {
    forces += line.find("local x,y,z forces") != std::string::npos ? 1 : 0;
    moments += line.find("local x,y,z moments") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(forces, 2);
  EXPECT_EQ(moments, 2);
}

}  // namespace
}  // namespace crumple::output::support_history_test
