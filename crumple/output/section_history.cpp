// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class SectionHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (const domain::SectionReport& section : view.sections) {
      const math::Vec3& f = section.force;
      const math::Vec3& m = section.moment;
      const math::Vec3& x = section.centroid;
      table.add_row(view.domain.clock.time, section.id, f.x, f.y, f.z, m.x, m.y, m.z, norm(f), x.x, x.y, x.z);
    }
  }
};

}  // namespace

std::unique_ptr<History> make_section_history() {
  return std::make_unique<SectionHistory>();
}

}  // namespace crumple::output
