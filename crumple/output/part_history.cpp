// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"
#include "output/part_masses.hpp"

namespace crumple::output {

namespace {

class PartHistory : public History {
 public:
  explicit PartHistory(const View& view) : masses_(view) {}

  void add_rows(const View& view, CsvFile& table) override {
    std::vector<double> internal(view.model.parts.size());
    std::vector<double> hourglass(view.model.parts.size());
    for (const domain::ElementBlock* block : view.domain.blocks()) {
      internal[block->part] += block->internal_energy;
      hourglass[block->part] += block->hourglass_energy;
    }
    for (Index part = 0; part < static_cast<Index>(view.model.parts.size()); ++part) {
      const PartMasses::Motion motion = masses_.motion_with_body(view.domain, part);
      table.add_row(view.domain.clock.time, view.model.parts[part].id, internal[part], motion.kinetic_energy,
                    hourglass[part], motion.velocity.x, motion.velocity.y, motion.velocity.z, motion.mass);
    }
  }

 private:
  PartMasses masses_;
};

}  // namespace

std::unique_ptr<History> make_part_history(const View& view) {
  return std::make_unique<PartHistory>(view);
}

}  // namespace crumple::output
