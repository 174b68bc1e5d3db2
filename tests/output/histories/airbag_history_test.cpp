// SPDX-License-Identifier: BSD-3-Clause
// abstat: the table, the text file and binout.
#include "output/lsda_reader.hpp"
#include "output/recorder.hpp"
#include "output/sample.hpp"

namespace crumple::output::airbag_history_test {
namespace {

class AirbagHistoryTest : public SampleTest {
 protected:
  AirbagHistoryTest() : SampleTest(with_airbags()) {
    domain_.control_volumes = {{.id = 17,
                                .volume = 2,
                                .pressure = 0.5,
                                .energy = 3,
                                .inflow = 0.25,
                                .outflow = 0.125,
                                .mass = 4,
                                .temperature = 300,
                                .area = 9},
                               {.id = 5, .volume = 1, .pressure = 1}};
  }
  static model::Model with_airbags() {
    model::Model model = sample_model();
    model.control_volumes.push_back({.id = 17, .title = "tyre", .segments = {}, .filling = {}});
    model.control_volumes.push_back({.id = 5, .title = "", .segments = {}, .filling = {}});
    model.output.of(model::HistoryFile::Abstat) = {
        .asked = true, .interval = 0.5, .ascii = true, .binary = true};
    return model;
  }
};

TEST_F(AirbagHistoryTest, HasTheSameNumbersInAllForms) {
  Recorder recorder(folder_, "run", view());
  recorder.write_due(view());
  const std::vector<std::string> table = lines(folder_ / "abstat.csv");
  ASSERT_EQ(table.size(), 3U);
  EXPECT_EQ(table[0], "time,airbag,volume,pressure,energy,inflow,outflow,mass,temperature,area");
  EXPECT_EQ(table[1], "0,17,2,0.5,3,0.25,0.125,4,300,9");
  EXPECT_EQ(table[2], "0,5,1,1,0,0,0,0,0,0");
  const LsdaReader binout(folder_ / "binout0000");
  EXPECT_EQ(binout.integers("/abstat/metadata/ids"), (std::vector<std::int64_t>{17, 5}));
  EXPECT_EQ(binout.reals("/abstat/d000001/pressure"), (std::vector<double>{0.5, 1}));
  EXPECT_EQ(binout.reals("/abstat/d000001/gas_temp"), (std::vector<double>{300, 0}));
  EXPECT_EQ(binout.reals("/abstat/d000001/density"), (std::vector<double>{2, 0}));
  const std::vector<std::string> text = lines(folder_ / "abstat");
  EXPECT_EQ(text.back(),
            " 0.00000E+00         5  1.0000E+00  1.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00  0.0000E+00"
            "  0.0000E+00  0.0000E+00  0.0000E+00");
}

}  // namespace
}  // namespace crumple::output::airbag_history_test
