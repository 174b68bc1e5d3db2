// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable contact_variables[] = {
    {"fx", "x_force"}, {"fy", "y_force"}, {"fz", "z_force"}, {"mass", "mass"}};

void print_contacts(const HistoryItems& items, const Sample& sample, std::string& text) {
  const auto& sides = items.marks[0].second;
  for (std::size_t i = 0; i < items.ids.size(); ++i)
    fmt::format_to(std::back_inserter(text),
                   "  {}{:11} time{:12.5E}  x {:12.5E}  y {:12.5E}  z {:12.5E} mass {:12.5E}\n",
                   sides[i] == 0 ? "slave " : "master", items.ids[i], sample.time(), sample.of("x_force")[i],
                   sample.of("y_force")[i], sample.of("z_force")[i], sample.of("mass")[i]);
}

constexpr HistoryForm rcforc_form{model::HistoryFile::Rcforc, "rcforc", "rcforc", "", print_contacts};

/// The resultant on each side of an interface, and what transducers measure. A surface in contact with itself
/// has one side, and no resultant by Newton's third law.
class ContactHistory : public SampledHistory {
 public:
  ContactHistory() : SampledHistory(rcforc_form, contact_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    items.marks.push_back({"side", {}});
    const auto add = [&](UserId id, const char* word, std::int64_t side) {
      items.ids.push_back(id);
      items.words.emplace_back(word);
      items.titles.push_back(side == 0 ? title_of(view, id) : "");
      items.marks[0].second.push_back(side);
    };
    for (const domain::ContactReport& contact : view.domain.contacts) {
      add(contact.id, contact.two_sided ? "first" : "single", 0);
      if (contact.two_sided) add(contact.id, "second", 1);
    }
    for (const domain::TransducerReport& transducer : view.domain.transducers)
      add(transducer.id, "transducer", 0);
    return items;
  }

  void take(const View& view, Sample& sample) override {
    const auto add = [&](const math::Vec3& force, double mass) {
      sample.add_item({force.x, force.y, force.z, mass});
    };
    for (const domain::ContactReport& contact : view.domain.contacts) {
      if (!contact.two_sided) {
        add({}, contact.mass[0]);
        continue;
      }
      add(contact.force, contact.mass[0]);
      add(-contact.force, contact.mass[1]);
    }
    for (const domain::TransducerReport& transducer : view.domain.transducers)
      add(transducer.force, transducer.mass);
  }

 private:
  static std::string title_of(const View& view, UserId id) {
    for (const model::Contact& contact : view.model.contacts)
      if (contact.id == id) return contact.title;
    for (const model::ForceTransducer& transducer : view.model.force_transducers)
      if (transducer.id == id) return transducer.title;
    return {};
  }
};

}  // namespace

std::unique_ptr<History> make_contact_history() {
  return std::make_unique<ContactHistory>();
}

}  // namespace crumple::output
