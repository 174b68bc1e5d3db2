// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

void add_side(CsvFile& table, double time, UserId id, const char* side, const math::Vec3& force,
              double mass) {
  table.add_row(time, id, side, force.x, force.y, force.z, mass);
}

/// The resultant on each side of an interface, and what transducers measure. A surface in contact with itself
/// has one side, and no resultant by Newton's third law.
class ContactHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    const double time = view.domain.clock.time;
    for (const domain::ContactReport& contact : view.domain.contacts) {
      if (!contact.two_sided) {
        add_side(table, time, contact.id, "single", {}, contact.mass[0]);
        continue;
      }
      add_side(table, time, contact.id, "first", contact.force, contact.mass[0]);
      add_side(table, time, contact.id, "second", -contact.force, contact.mass[1]);
    }
    for (const domain::TransducerReport& transducer : view.domain.transducers)
      add_side(table, time, transducer.id, "transducer", transducer.force, transducer.mass);
  }
};

}  // namespace

std::unique_ptr<History> make_contact_history() {
  return std::make_unique<ContactHistory>();
}

}  // namespace crumple::output
