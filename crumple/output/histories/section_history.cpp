// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/sampled_history.hpp"

namespace crumple::output {

namespace {

constexpr Variable section_variables[] = {
    {"fx", "x_force"},   {"fy", "y_force"},   {"fz", "z_force"},        {"mx", "x_moment"},
    {"my", "y_moment"},  {"mz", "z_moment"},  {"force", "total_force"}, {"x", "x_centroid"},
    {"y", "y_centroid"}, {"z", "z_centroid"}, {"", "total_moment"},
};

void print_sections(const HistoryItems& items, const Sample& sample, std::string& text) {
  for (std::size_t i = 0; i < items.ids.size(); ++i) {
    const auto end = std::back_inserter(text);
    const auto line = [&](std::string_view start, std::initializer_list<std::string_view> names) {
      fmt::format_to(end, "{:27}   ", start);
      for (const std::string_view name : names) fmt::format_to(end, "{:12.4E}", sample.of(name)[i]);
    };
    line(fmt::format("{:12}{:15.5E}", items.ids[i], sample.time()),
         {"x_force", "y_force", "z_force", "total_force"});
    text += '\n';
    line("global system", {"x_moment", "y_moment", "z_moment", "total_moment"});
    text += '\n';
    line("", {"x_centroid", "y_centroid", "z_centroid"});
    // The area, which is not computed; readers count on a number there.
    fmt::format_to(end, "{:12.4E}\n\n", 0.0);
  }
}

constexpr HistoryForm secforc_form{
    model::HistoryFile::Secforc, "secforc", "secforc",
    "\n\n line#1  section#     time        x-force     y-force     z-force    magnitude\n"
    " line#2  resultant  moments       x-moment    y-moment    z-moment   magnitude\n"
    " line#3  centroids                x           y           z            area  \n",
    print_sections};

class SectionHistory : public SampledHistory {
 public:
  SectionHistory() : SampledHistory(secforc_form, section_variables) {}

 protected:
  HistoryItems find_items(const View& view) override {
    HistoryItems items;
    for (const domain::SectionReport& section : view.sections) items.ids.push_back(section.id);
    for (const model::CrossSection& section : view.model.output.cross_sections)
      items.titles.push_back(section.title);
    items.titles.resize(items.ids.size());
    // All forces are in global axes: those of no rigid body, accelerometer or coordinate system.
    const std::vector<std::int64_t> none(items.ids.size(), 0);
    items.marks = {{"rigidbody", none}, {"accelerometer", none}, {"coordinate_system", none}};
    return items;
  }

  void take(const View& view, Sample& sample) override {
    for (const domain::SectionReport& section : view.sections) {
      const math::Vec3& f = section.force;
      const math::Vec3& m = section.moment;
      const math::Vec3& x = section.centroid;
      sample.add_item({f.x, f.y, f.z, m.x, m.y, m.z, norm(f), x.x, x.y, x.z, norm(m)});
    }
  }
};

}  // namespace

std::unique_ptr<History> make_section_history() {
  return std::make_unique<SectionHistory>();
}

}  // namespace crumple::output
