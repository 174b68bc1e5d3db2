// SPDX-License-Identifier: BSD-3-Clause
// Frames and collections of a folder from somebody else: the reader must answer with arrays that fit, or with
// a sentence. The first byte chooses the file; in frames it also says whether the bytes are put into the
// arrays of a frame that is well-formed otherwise, as a compressor lets nothing through by chance.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "output/paraview/vtu_file.hpp"
#include "report/payload.hpp"
#include "report/result_folder.hpp"
#include "report/run_survey.hpp"

namespace {

using namespace crumple;

/// Numbers from the fuzzer; zeros when it has no more.
class Source {
 public:
  Source(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int number(int count) { return size_ == 0 ? 0 : take() % count; }
  bool chance() { return number(16) == 1; }

 private:
  int take() {
    --size_;
    return *data_++;
  }
  const std::uint8_t* data_;
  std::size_t size_;
};

/// A list as it should be, or of another length, or with other numbers.
template <class Number>
std::vector<Number> changed(std::vector<Number> list, Source& source) {
  if (source.chance()) list.resize(static_cast<std::size_t>(source.number(40)));
  for (Number& value : list)
    if (source.chance()) value = static_cast<Number>(source.number(256) - 128);
  return list;
}

/// Two quadrilaterals, a hexahedron and a beam.
std::string frame_of(Source& source) {
  constexpr int points = 14;
  constexpr int cells = 4;
  output::VtuPacker packer;
  const auto count = [&](int right) { return source.chance() ? source.number(10) : right; };
  std::vector<float> coordinates;
  for (int i = 0; i < 3 * points; ++i) coordinates.push_back(static_cast<float>((i * 7) % 11));
  const auto position = packer.array<float>("position", count(3), changed(coordinates, source));
  const auto connectivity = packer.array<std::int32_t>(
      "connectivity", count(1),
      changed(std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2, 6, 7, 8, 9, 10, 11, 12, 13, 0, 6}, source));
  const auto offsets = packer.array<std::int32_t>("offsets", count(1),
                                                  changed(std::vector<std::int32_t>{4, 8, 16, 18}, source));
  const auto types =
      packer.array<std::uint8_t>("types", count(1), changed(std::vector<std::uint8_t>{9, 9, 12, 3}, source));
  const auto node_id =
      packer.array<std::int32_t>("node_id", count(1), changed(std::vector<std::int32_t>(points, 1), source));
  const auto velocity = packer.array<float>("velocity", count(3), changed(coordinates, source));
  const auto part =
      packer.array<std::int32_t>("part", count(1), changed(std::vector<std::int32_t>(cells, 1), source));
  const auto element = packer.array<std::int32_t>("element_id", count(1),
                                                  changed(std::vector<std::int32_t>(cells, 1), source));
  const auto alive =
      packer.array<std::uint8_t>("alive", count(1), changed(std::vector<std::uint8_t>(cells, 1), source));
  const auto strain = packer.array<float>("strain", count(1), changed(std::vector<float>(cells, 1), source));
  output::VtuGrid grid;
  grid.points = source.chance() ? source.number(40) : points;
  grid.cells = source.chance() ? source.number(40) : cells;
  grid.positions = {&position};
  grid.topology = {&connectivity, &offsets, &types};
  grid.point_data = {&node_id, &velocity};
  grid.cell_data = {&part, &element, &alive, &strain};
  return output::vtu_text(grid);
}

const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    // In memory where there is such a place: files are written thousands of times a second.
    const std::filesystem::path root = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
    std::filesystem::path path = root / ("crumple_fuzz_results_" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    return path;
  }();
  return made;
}

void write(const char* name, std::string_view text) {
  std::ofstream(folder() / name, std::ios::binary) << text;
}

void read_frames() {
  report::ResultFolder results;
  results.frames = {{0.0, folder() / "a.vtu", {}}, {1.0, folder() / "b.vtu", {}}};
  const report::Progress quiet = [](const std::string&, std::size_t, std::size_t) {};
  const report::RunSurvey survey = report::survey_run(results, quiet);
  if (report::make_payload(results, survey, quiet).empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    if (data[0] % 4 == 0) {
      write("run.pvd", bytes);
      report::open_results(folder());
    } else if (data[0] % 4 == 1) {
      write("a.vtu", bytes);
      write("b.vtu", bytes);
      read_frames();
    } else {
      Source source(data + 1, size - 1);
      Source none(nullptr, 0);
      write("a.vtu", frame_of(data[0] % 4 == 2 ? source : none));
      write("b.vtu", frame_of(source));
      read_frames();
    }
  } catch (const Error&) {
    // A sentence is an answer.
  }
  return 0;
}
