// SPDX-License-Identifier: BSD-3-Clause
#include "output/initial_overlaps.hpp"

#include <algorithm>

#include "output/files/csv_file.hpp"

namespace crumple::output {

std::optional<std::filesystem::path> write_initial_overlaps(const std::filesystem::path& folder,
                                                            const View& view) {
  const auto& contacts = view.domain.contacts;
  if (std::all_of(contacts.begin(), contacts.end(),
                  [](const auto& contact) { return contact.initial_overlaps.empty(); }))
    return std::nullopt;
  CsvFile table(folder / "initial_penetrations.csv", "interface,node,element,penetration");
  for (const domain::ContactReport& contact : contacts)
    for (const domain::InitialOverlap& overlap : contact.initial_overlaps)
      table.add_row(contact.id, overlap.node, overlap.element, overlap.depth);
  table.flush();
  return table.path();
}

}  // namespace crumple::output
