// SPDX-License-Identifier: BSD-3-Clause
//
// The file: 16 bytes of name, format and byte order, then the length of the header (8 bytes), the header
// (JSON: record and the lengths of what follows), the texts, the arrays of the simulation and those of the
// files, and 8 bytes of checksum over all before them. Numbers are those of the processor.
#include "output/files/restart_file.hpp"

#include <fmt/core.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/state_hash.hpp"
#include "files/input_file.hpp"
#include "output/files/own_file.hpp"

namespace crumple::output {

namespace {

using Json = nlohmann::json;

constexpr std::string_view mark = "crumple";
constexpr std::uint32_t format_version = 1;
constexpr std::uint32_t byte_order = 0x01020304;

struct Preamble {
  char name[8] = {};
  std::uint32_t format = format_version;
  std::uint32_t order = byte_order;
  std::uint64_t header_bytes = 0;
};
static_assert(sizeof(Preamble) == 24);

/// A file with a checksum over all that goes into it.
class SummedFile {
 public:
  explicit SummedFile(const std::filesystem::path& path) : file_(path) {}

  void write(std::span<const std::byte> bytes) {
    hash_.add(bytes);
    file_.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  /// The checksum, then the rename.
  void finish() {
    const std::uint64_t sum = hash_.value();
    file_.write({reinterpret_cast<const char*>(&sum), sizeof sum});
    // The results that the file counts on must not be older than itself after a loss of power.
    file_.synchronize();
    file_.put_in_place();
  }

 private:
  NewFile file_;
  StateHash hash_;
};

Json lengths_of(const domain::StateList& list) {
  Json arrays = Json::array();
  for (const domain::StateArray& array : list.arrays()) arrays.push_back({array.name, array.bytes.size()});
  return arrays;
}

/// Takes pieces from the front of a file in memory.
class Pieces {
 public:
  Pieces(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) throw Error(name_ + " is cut off: it was not written to its end.");
    const std::string_view piece = rest_.substr(0, bytes);
    hash_.add(std::as_bytes(std::span(piece)));
    rest_.remove_prefix(bytes);
    return piece;
  }
  std::vector<domain::StateSnapshot::Array> arrays(const Json& lengths) {
    std::vector<domain::StateSnapshot::Array> found;
    found.reserve(lengths.size());
    for (const Json& entry : lengths) {
      const auto bytes = std::as_bytes(std::span(take(entry.at(1).get<std::size_t>())));
      found.push_back({entry.at(0).get<std::string>(), {bytes.begin(), bytes.end()}});
    }
    return found;
  }
  std::uint64_t hash() const { return hash_.value(); }

 private:
  std::string_view rest_;
  std::string name_;
  StateHash hash_;
};

std::string read_whole(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw Error("There is no restart file " + path.string() + ".");
  InputFile input = read_input_file(path);
  if (!input.fault.empty()) throw Error(path.string() + " cannot be read: " + input.fault + ".");
  return std::move(input.text);
}

Preamble checked_preamble(std::string_view bytes, const std::string& name) {
  Preamble preamble;
  std::memcpy(&preamble, bytes.data(), sizeof(preamble));
  if (std::string_view(preamble.name, mark.size()) != mark)
    throw Error(name + " is no restart file of crumple.");
  if (preamble.order != byte_order) throw Error(name + " was written on a machine of another byte order.");
  if (preamble.format != format_version)
    throw Error(
        fmt::format("{} has the format {}, this program reads {}: take up the run with the version that "
                    "wrote it.",
                    name, preamble.format, format_version));
  return preamble;
}

}  // namespace

void write_restart_file(const std::filesystem::path& path, const RestartRecord& record,
                        const domain::StateList& simulation, const domain::StateList& files) {
  Json lengths = Json::array();
  for (const std::string& text : record.texts) lengths.push_back(text.size());
  const Json json = {{"version", record.version},   {"settings", record.settings},
                     {"time", record.time},         {"cycle", record.cycle},
                     {"texts", std::move(lengths)}, {"simulation", lengths_of(simulation)},
                     {"files", lengths_of(files)}};
  // Names of files may be in any encoding.
  const std::string header = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  Preamble preamble;
  mark.copy(preamble.name, mark.size());
  preamble.header_bytes = header.size();
  SummedFile file(path);
  file.write(std::as_bytes(std::span(&preamble, 1)));
  file.write(std::as_bytes(std::span(header)));
  for (const std::string& text : record.texts) file.write(std::as_bytes(std::span(text)));
  for (const domain::StateArray& array : simulation.arrays()) file.write(array.bytes);
  for (const domain::StateArray& array : files.arrays()) file.write(array.bytes);
  file.finish();
}

RestartContent read_restart_file(const std::filesystem::path& path) {
  const std::string bytes = read_whole(path);
  const std::string name = path.string();
  if (bytes.size() < sizeof(Preamble)) throw Error(name + " is no restart file of crumple.");
  Pieces pieces(bytes, name);
  const Preamble preamble = checked_preamble(pieces.take(sizeof(Preamble)), name);
  RestartContent content;
  try {
    const Json json = Json::parse(pieces.take(preamble.header_bytes));
    content.record.version = json.at("version");
    content.record.settings = json.at("settings");
    content.record.time = json.at("time");
    content.record.cycle = json.at("cycle");
    for (const Json& length : json.at("texts"))
      content.record.texts.emplace_back(pieces.take(length.get<std::size_t>()));
    content.simulation = domain::StateSnapshot(pieces.arrays(json.at("simulation")));
    content.files = domain::StateSnapshot(pieces.arrays(json.at("files")));
  } catch (const Json::exception&) {
    throw Error(name + " is damaged: its header cannot be read.");
  }
  if (content.record.cycle < 0) throw Error(name + " is damaged: its cycle is negative.");
  const std::uint64_t expected = pieces.hash();
  std::uint64_t found = 0;
  std::memcpy(&found, pieces.take(sizeof(found)).data(), sizeof(found));
  if (found != expected) throw Error(name + " is damaged: its checksum is wrong.");
  return content;
}

}  // namespace crumple::output
