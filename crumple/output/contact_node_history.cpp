// SPDX-License-Identifier: BSD-3-Clause
#include "output/history.hpp"

namespace crumple::output {

namespace {

class ContactNodeHistory : public History {
 public:
  void add_rows(const View& view, CsvFile& table) override {
    for (const domain::ContactNodeForce& found : view.contact_node_forces()) {
      const domain::ContactReport& contact = view.domain.contacts[found.contact];
      table.add_row(view.domain.clock.time, contact.id, name_of(contact, found.side),
                    view.model.nodes.id[view.domain.nodes.model_node[found.node]], found.force.x,
                    found.force.y, found.force.z);
    }
  }

 private:
  /// As rcforc.csv calls the sides.
  static const char* name_of(const domain::ContactReport& contact, std::uint8_t side) {
    if (!contact.two_sided) return "single";
    return side == 1 ? "first" : side == 2 ? "second" : "both";
  }
};

}  // namespace

std::unique_ptr<History> make_contact_node_history() {
  return std::make_unique<ContactNodeHistory>();
}

}  // namespace crumple::output
