// SPDX-License-Identifier: BSD-3-Clause
#include "report/payload.hpp"

#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>
#include <span>

#include "base/error.hpp"
#include "report/history_text.hpp"
#include "report/packing.hpp"
#include "report/scatter_folder.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

using Json = nlohmann::ordered_json;
using Section = VtuReader::Section;

/// With more values than this a field takes 8 bits for each, for the sake of the file's size.
constexpr std::size_t most_exact_values = 4U << 20U;

class Payload {
 public:
  Payload(const ResultFolder& results, const RunSurvey& survey, const Progress& progress)
      : results_(results), survey_(survey), progress_(progress) {}

  std::string make() {
    add_description();
    add_mesh();
    add_frames();
    add_walls();
    add_tables();
    add_bands();
    // JSON ends no element of HTML as long as it holds no "<".
    std::string json = meta_.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
      json.replace(at, 1, "\\u003c");
    return "<script type=\"application/json\" id=\"crumple-meta\">" + json + "</script>\n" + elements_;
  }

 private:
  void add_data(const std::string& name, std::string_view bytes) {
    fmt::format_to(std::back_inserter(elements_),
                   "<script type=\"text/plain\" id=\"crumple-data-{}\">{}</script>\n", name,
                   deflated_base64(bytes));
  }

  void add_description() {
    meta_["format"] = 1;
    meta_["name"] = results_.name;
    meta_["run"] = nullptr;
    if (results_.has_record) {
      meta_["run"] = Json::parse(read_file(results_.folder / "run.json"), nullptr, false);
      if (meta_["run"].is_discarded())
        throw Error(fmt::format("{} is not JSON.", (results_.folder / "run.json").string()));
    }
    Json times = Json::array();
    for (const FrameFiles& frame : results_.frames) times.push_back(frame.time);
    meta_["times"] = times;
    meta_["model"] = {{"nodes", survey_.all_nodes}, {"cells", survey_.all_cells}};
  }

  /// Ids and topology, which do not change.
  void add_mesh() {
    const VtuReader first(results_.frames.front().grid);
    const Surface& surface = survey_.surface;
    meta_["nodes"] = surface.nodes.size();
    meta_["cells"] = surface.cells.size();
    meta_["faces"] = surface.faces.size();
    meta_["lines"] = surface.lines.size();
    const auto add = [&](const std::string& name, const std::vector<std::int64_t>& values) {
      add_data(name, pack_integers(values));
    };
    const auto chosen = [](const std::vector<std::int64_t>& values, const std::vector<Index>& places) {
      std::vector<std::int64_t> list;
      list.reserve(places.size());
      for (const Index place : places) list.push_back(values[place]);
      return list;
    };
    add("node_id", chosen(first.integers(Section::PointData, "node_id"), surface.nodes));
    add("element_id", chosen(first.integers(Section::CellData, "element_id"), surface.cells));
    add("part", chosen(first.integers(Section::CellData, "part"), surface.cells));
    add("type", survey_.cell_types);
    add("death", {survey_.cell_death.begin(), survey_.cell_death.end()});
    add("faces", columns(surface.faces, true));
    add("lines", columns(surface.lines, false));
  }

  /// First all first nodes, then all second ones, ..., then the cells: neighbours in the text are alike.
  static std::vector<std::int64_t> columns(const std::vector<Face>& faces, bool quadrilaterals) {
    std::vector<std::int64_t> list;
    for (std::size_t corner = 0; corner < (quadrilaterals ? 4 : 2); ++corner)
      for (const Face& face : faces) list.push_back(face.node[corner]);
    for (const Face& face : faces) list.push_back(face.cell);
    if (quadrilaterals)
      for (const Face& face : faces) list.push_back(face.behind);
    return list;
  }

  struct FieldWriter {
    const Field* field;
    Quantiser quantiser;
    FramePacker packer;
  };

  void add_frames() {
    std::vector<FieldWriter> writers = make_writers();
    std::vector<FieldWriter> axes;
    Json low = Json::array();
    Json high = Json::array();
    for (const Range& range : survey_.box) {
      axes.push_back({nullptr, Quantiser(range, 16), FramePacker(16)});
      low.push_back(range.low);
      high.push_back(range.high);
    }
    meta_["box"] = {{"low", low}, {"high", high}};
    for (std::size_t i = 0; i < results_.frames.size(); ++i) {
      const VtuReader frame(results_.frames[i].grid);
      add_positions(frame, i, axes);
      for (std::size_t f = 0; f < writers.size(); ++f) {
        const std::vector<float> values = field_values(frame, survey_, *writers[f].field);
        std::string bytes;
        add_codes(writers[f], values, bytes);
        add_data(fmt::format("field{}_{}", f, i), bytes);
      }
      progress_("Packing", i + 1, results_.frames.size());
    }
  }

  std::vector<FieldWriter> make_writers() {
    std::vector<FieldWriter> writers;
    meta_["fields"] = Json::array();
    for (const Field& field : survey_.fields) {
      const std::size_t places = field.by_node ? survey_.surface.nodes.size() : survey_.surface.cells.size();
      const int bits = places * results_.frames.size() > most_exact_values ? 8 : 16;
      writers.push_back({&field, Quantiser(field.range, bits), FramePacker(bits)});
      meta_["fields"].push_back({{"name", field.name},
                                 {"by_node", field.by_node},
                                 {"bits", bits},
                                 {"low", field.range.low},
                                 {"high", field.range.high}});
    }
    return writers;
  }

  /// Nodes of failed elements stay where these were last seen.
  void add_positions(const VtuReader& frame, std::size_t number, std::vector<FieldWriter>& axes) {
    const std::vector<float> positions = frame.reals(Section::Points, "position", 3);
    seen_.resize(3);
    std::string bytes;
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<float> values = coordinates(positions, survey_.surface, axis);
      if (seen_[axis].empty()) seen_[axis] = values;
      for (std::size_t node = 0; node < values.size(); ++node)
        if (static_cast<Index>(number) < survey_.node_death[node]) seen_[axis][node] = values[node];
      add_codes(axes[axis], seen_[axis], bytes);
    }
    add_data(fmt::format("position_{}", number), bytes);
  }

  void add_codes(FieldWriter& writer, std::span<const float> values, std::string& bytes) {
    codes_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      codes_[i] = writer.quantiser.code(static_cast<double>(values[i]));
    writer.packer.add(codes_, bytes);
  }

  /// Surfaces of rigid walls, and how far each wall has moved in each frame.
  void add_walls() {
    meta_["walls"] = nullptr;
    if (results_.frames.front().walls.empty()) return;
    const VtuReader first(results_.frames.front().walls);
    const auto connectivity = first.integers(Section::Cells, "connectivity");
    const auto offsets = first.integers(Section::Cells, "offsets");
    const auto ids = first.integers(Section::CellData, "wall");
    const std::vector<float> points = first.reals(Section::Points, "position", 3);
    Json faces = Json::array();
    std::map<std::int64_t, std::int64_t> first_point;  // of each wall
    std::int64_t start = 0;
    for (std::size_t face = 0; face < offsets.size(); ++face) {
      if (start < 0 || offsets[face] <= start ||
          offsets[face] > static_cast<std::int64_t>(connectivity.size()))
        throw Error(fmt::format("{} has a face without points.", results_.frames.front().walls.string()));
      faces.push_back(
          std::vector<std::int64_t>(connectivity.begin() + start, connectivity.begin() + offsets[face]));
      first_point.emplace(ids[face], connectivity[start]);
      start = offsets[face];
    }
    Json motion = Json::object();
    for (const FrameFiles& files : results_.frames) {
      const std::vector<float> now = VtuReader(files.walls).reals(Section::Points, "position", 3);
      if (now.size() != points.size()) throw Error(fmt::format("{} has other points.", files.walls.string()));
      for (const auto& [id, point] : first_point)
        for (std::int64_t i = 3 * point; i < 3 * point + 3; ++i)
          motion[std::to_string(id)].push_back(now.at(i) - points.at(i));
    }
    meta_["walls"] = {{"points", points}, {"faces", faces}, {"wall", ids}, {"motion", motion}};
  }

  void add_tables() {
    meta_["tables"] = Json::array();
    for (const std::filesystem::path& file : results_.tables) {
      const ThinnedHistory history = thin_history(whole_rows(read_file(file)), most_history_bytes);
      const std::size_t number = meta_["tables"].size();
      meta_["tables"].push_back({{"name", file.filename().string()}, {"every", history.every}});
      add_data(fmt::format("table{}", number), history.text);
    }
  }

  void add_bands() {
    meta_["scatter"] = nullptr;
    if (results_.scatter.empty()) return;
    const BandTable bands = split_bands(read_file(results_.scatter / bands_file), most_history_bytes);
    Json scatter = {{"runs", bands.runs}, {"perturbation", nullptr}, {"histories", Json::array()}};
    if (const auto perturbation = perturbation_of(results_.scatter)) scatter["perturbation"] = *perturbation;
    for (const HistoryBands& history : bands.histories) {
      add_data(fmt::format("bands{}", scatter["histories"].size()), history.text);
      scatter["histories"].push_back({{"name", history.history}, {"every", history.every}});
    }
    meta_["scatter"] = std::move(scatter);
  }

  const ResultFolder& results_;
  const RunSurvey& survey_;
  const Progress& progress_;
  Json meta_;
  std::string elements_;
  std::vector<std::uint16_t> codes_;
  std::vector<std::vector<float>> seen_;  ///< by axis, last position of each node with a living cell
};

}  // namespace

std::string make_payload(const ResultFolder& results, const RunSurvey& survey, const Progress& progress) {
  return Payload(results, survey, progress).make();
}

}  // namespace crumple::report
