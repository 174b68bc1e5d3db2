// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "output/history.hpp"

namespace crumple::output {

namespace {

/// The nodes of the parts of one interface.
struct InterfaceNodes {
  std::vector<Index> nodes;  ///< domain nodes, ascending
  double mass = 0;           ///< [mass]
};

InterfaceNodes nodes_of(const View& view, const model::SingleSurfaceContact& contact) {
  std::vector<bool> takes_part(view.model.parts.size());
  for (const Index part : contact.parts) takes_part[part] = true;
  InterfaceNodes result;
  for (const model::ShellElement& shell : view.model.shells)
    if (takes_part[shell.part])
      for (const Index node : shell.node) result.nodes.push_back(view.domain.nodes.domain_node[node]);
  std::sort(result.nodes.begin(), result.nodes.end());
  result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()), result.nodes.end());
  for (const Index node : result.nodes) result.mass += view.domain.nodes.mass[node];
  return result;
}

/// A surface in contact with itself has one side. The resultant of its forces is zero by Newton's third law:
/// the row shows that it is.
class ContactHistory : public History {
 public:
  explicit ContactHistory(const View& view) {
    for (const model::SingleSurfaceContact& contact : view.model.contacts)
      interfaces_.push_back(nodes_of(view, contact));
  }

  void add_rows(const View& view, CsvFile& table) override {
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
      math::Vec3 force;
      if (!view.domain.contact_force.empty())
        for (const Index node : interfaces_[i].nodes) force += view.domain.contact_force[node];
      table.add_row(view.domain.clock.time, view.model.contacts[i].id, "single", force.x, force.y, force.z,
                    interfaces_[i].mass);
    }
  }

 private:
  std::vector<InterfaceNodes> interfaces_;
};

}  // namespace

std::unique_ptr<History> make_contact_history(const View& view) {
  return std::make_unique<ContactHistory>(view);
}

}  // namespace crumple::output
