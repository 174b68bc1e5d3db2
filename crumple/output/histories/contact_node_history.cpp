// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

using domain::ContactNodeForce;

constexpr Variable contact_node_variables[] = {{"", "x_force"}, {"", "y_force"}, {"", "z_force"},
                                               {"", "x"},       {"", "y"},       {"", "z"}};

void print_side(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto end = std::back_inserter(text);
  fmt::format_to(end,
                 "\n\n\n forces (t={:11.5E}) for interface {:9} {} side\n\n"
                 "     node           x-force/      y-force/      z-force/     pressure/\n"
                 "                   coordinate    coordinate    coordinate\n",
                 sample.time(), items.marks[0].second[0],
                 items.marks[1].second[0] == 0 ? "slave " : "master");
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    const auto add = [&](std::initializer_list<std::string_view> names) {
      for (const std::string_view name : names) fmt::format_to(end, "{:14.5E}", sample.of(name)[i]);
    };
    fmt::format_to(end, "{:10}      ", items.ids[i]);
    add({"x_force", "y_force", "z_force"});
    // The pressure, which is not computed; readers count on a number there.
    fmt::format_to(end, "{:14.5E}\n{:16}", 0.0, "");
    add({"x", "y", "z"});
    text += '\n';
  }
}

/// Nodes of the model that may touch something as part of a side, ascending: elements that fail lay more of
/// a solid bare, so that all of its nodes count.
std::vector<Index> nodes_of(const model::Model& model, const model::ContactSide& side) {
  std::vector<Index> nodes = side.nodes;
  const auto add_elements = [&](const auto& elements) {
    for (const auto& element : elements)
      if (std::binary_search(side.parts.begin(), side.parts.end(), element.part))
        nodes.insert(nodes.end(), element.node.begin(), element.node.end());
  };
  add_elements(model.shells);
  add_elements(model.solids);
  add_elements(model.beams);
  for (const Index shell : side.shells)
    nodes.insert(nodes.end(), model.shells[shell].node.begin(), model.shells[shell].node.end());
  for (const std::array<Index, 4>& segment : side.segments)
    nodes.insert(nodes.end(), segment.begin(), segment.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// What a side is called in binout; its first base, to be there before the form that names it.
struct BranchName {
  std::string branch;
};

/// One side of a contact in LS-DYNA's forms, with all of its nodes.
class SideHistory : private BranchName, public SampledHistory {
 public:
  /// The `forces` are those of the time that is measured. They must outlive this.
  SideHistory(const View& view, std::size_t contact, std::size_t side,
              const std::vector<ContactNodeForce>& forces)
      : BranchName{fmt::format("ncforc/{}_{}", side == 0 ? "slave" : "master",
                               view.domain.contacts[contact].id)},
        SampledHistory({model::HistoryFile::Ncforc, "ncforc", branch, "", print_side},
                       contact_node_variables),
        contact_(contact),
        side_(side),
        forces_(forces),
        nodes_(nodes_of(view.model, view.model.contacts[contact].side[side])) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const Index node : nodes_) items.ids.push_back(view.model.nodes.id[node]);
    items.marks = {{"interface", {view.domain.contacts[contact_].id}},
                   {"side", {static_cast<std::int64_t>(side_)}}};
    return items;
  }

  void take(const View& view, Sample& sample) override {
    const domain::NodeFields& nodes = view.domain.nodes;
    std::vector<math::Vec3> forces(nodes_.size());
    for (const ContactNodeForce& found : forces_) {
      if (static_cast<std::size_t>(found.contact) != contact_ || (found.side == 2) != (side_ == 1)) continue;
      const Index node = nodes.model_node[found.node];
      const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), node);
      if (place != nodes_.end() && *place == node)
        forces[static_cast<std::size_t>(place - nodes_.begin())] = found.force;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const math::Vec3& f = forces[i];
      const math::Vec3& x = nodes.position[nodes.domain_node[nodes_[i]]];
      sample.add_item({f.x, f.y, f.z, x.x, x.y, x.z});
    }
  }

 private:
  std::size_t contact_;
  std::size_t side_;
  const std::vector<ContactNodeForce>& forces_;
  std::vector<Index> nodes_;  ///< of the model, ascending
};

/// Whether contacts name the sides that LS-DYNA's files show; if none does, they show all.
bool sides_are_named(const model::Model& model) {
  return std::any_of(model.contacts.begin(), model.contacts.end(), [](const model::Contact& contact) {
    return contact.side[0].node_forces || contact.side[1].node_forces;
  });
}

/// The nodes that a contact touches, in our table; for LS-DYNA all, by side.
class ContactNodeHistory : public History {
 public:
  explicit ContactNodeHistory(const View& view) {
    const bool named = sides_are_named(view.model);
    for (std::size_t i = 0; i < view.model.contacts.size() && i < view.domain.contacts.size(); ++i) {
      const bool two_sided = view.model.contacts[i].kind != model::ContactKind::SingleSurface;
      for (std::size_t side = 0; side < (two_sided ? 2U : 1U); ++side)
        if (!named || view.model.contacts[i].side[side].node_forces)
          sides_.push_back(std::make_unique<SideHistory>(view, i, side, forces_));
    }
  }

  void add_rows(const View& view, CsvFile& table) override {
    forces_ = view.contact_node_forces();
    for (const ContactNodeForce& found : forces_) {
      const domain::ContactReport& contact = view.domain.contacts[found.contact];
      table.add_row(view.domain.clock.time, contact.id, name_of(contact, found.side),
                    view.model.nodes.id[view.domain.nodes.model_node[found.node]], found.force.x,
                    found.force.y, found.force.z);
    }
    for (const std::unique_ptr<SideHistory>& side : sides_)
      if (side->is_complete()) side->measure(view);
  }

  std::vector<SampledHistory*> sampled() override {
    std::vector<SampledHistory*> all;
    for (const std::unique_ptr<SideHistory>& side : sides_) all.push_back(side.get());
    return all;
  }

 private:
  /// As rcforc.csv calls the sides.
  static const char* name_of(const domain::ContactReport& contact, std::uint8_t side) {
    if (!contact.two_sided) return "single";
    return side == 1 ? "first" : side == 2 ? "second" : "both";
  }

  std::vector<ContactNodeForce> forces_;  ///< of the last row
  std::vector<std::unique_ptr<SideHistory>> sides_;
};

}  // namespace

std::unique_ptr<History> make_contact_node_history(const View& view) {
  return std::make_unique<ContactNodeHistory>(view);
}

}  // namespace crumple::output
