// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/restart_settings.hpp"

#include <fmt/core.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "app/session/restart_writer.hpp"
#include "base/error.hpp"
#include "output/files/own_file.hpp"

namespace crumple::app {

namespace {

using Json = nlohmann::json;

template <class T>
Json optional(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

template <class T>
void take(const Json& json, const char* name, std::optional<T>& value) {
  if (const Json& found = json.at(name); !found.is_null()) value = found.get<T>();
}

Json json_of(const Options& options) {
  return {{"threads", optional(options.threads)},
          {"precision", optional(options.precision)},
          {"isa", optional(options.isa)},
          {"search", optional(options.search)},
          {"local_search", optional(options.local_search)},
          {"end_time", optional(options.end_time)},
          {"parameters", options.parameters},
          {"automatic_contact", options.automatic_contact},
          {"ls_dyna_defaults", options.ls_dyna_defaults},
          {"allow_unsupported", options.allow_unsupported},
          {"allow_negative_contact_energy", options.allow_negative_contact_energy},
          {"d3plot", options.d3plot},
          {"all_fields", options.all_fields},
          {"dynain", options.dynain},
          {"trace_energy", options.trace_energy},
          {"move_apart", options.move_apart},
          {"perturbation", options.perturbation},
          {"seed", options.seed},
          {"restart_cycles", options.restart_every.cycles},
          {"restart_seconds", options.restart_every.seconds}};
}

Options options_of(const Json& json) {
  Options options;
  take(json, "threads", options.threads);
  take(json, "precision", options.precision);
  take(json, "isa", options.isa);
  take(json, "search", options.search);
  take(json, "local_search", options.local_search);
  take(json, "end_time", options.end_time);
  options.parameters = json.at("parameters").get<std::vector<std::pair<std::string, std::string>>>();
  options.automatic_contact = json.at("automatic_contact");
  options.ls_dyna_defaults = json.at("ls_dyna_defaults");
  options.allow_unsupported = json.at("allow_unsupported");
  options.allow_negative_contact_energy = json.at("allow_negative_contact_energy");
  options.d3plot = json.at("d3plot");
  options.all_fields = json.at("all_fields");
  options.dynain = json.at("dynain");
  options.trace_energy = json.at("trace_energy");
  options.move_apart = json.at("move_apart");
  options.perturbation = json.at("perturbation");
  options.seed = json.at("seed");
  options.restart_every = {json.at("restart_cycles"), json.at("restart_seconds")};
  return options;
}

RestartSettings settings_of(const output::RestartRecord& record) {
  RestartSettings settings;
  const Json json = Json::parse(record.settings);
  settings.options = options_of(json.at("options"));
  settings.warnings = json.at("warnings").get<std::vector<std::string>>();
  constexpr std::size_t each = 5;
  const std::vector<std::string>& texts = record.texts;
  if (texts.size() % each != 1) throw Error("The restart file is damaged: it lacks texts.");
  settings.options.deck = texts[0];
  for (std::size_t i = 1; i < texts.size(); i += each)
    settings.texts.push_back({texts[i], texts[i + 1], texts[i + 2], texts[i + 3], texts[i + 4]});
  return settings;
}

Restart read_one(const std::filesystem::path& path) {
  try {
    Restart restart{path, output::read_restart_file(path), {}, {}};
    const std::string& version = restart.content.record.version;
    if (version != program_version())
      throw Error(path.string() + " was written by " + version + ": take up the run with that version.");
    restart.settings = settings_of(restart.content.record);
    return restart;
  } catch (const Json::exception&) {
    throw Error(path.string() + " is damaged: its settings cannot be read.");
  }
}

/// The file of the latest cycle that can be read. The state before an error is for whoever names it.
Restart read_newest(const std::filesystem::path& folder) {
  std::optional<Restart> newest;
  bool damaged = false;
  std::string fault = "There is no restart file in " + folder.string() + ".";
  for (const std::filesystem::path& path : restart_files(folder)) {
    if (path.filename().string().starts_with("last_good")) continue;
    try {
      Restart found = read_one(path);
      if (!newest || found.content.record.cycle > newest->content.record.cycle) newest = std::move(found);
    } catch (const Error& error) {
      fault = error.what();
      damaged = true;
    }
  }
  if (!newest) throw Error(fault);
  if (damaged) newest->note = fault + " " + newest->file.string() + " is taken instead.";
  return std::move(*newest);
}

/// Whether a deck of changes says when the run ends: that goes before what an earlier command line said.
bool changes_end_time(const std::filesystem::path& changes) {
  if (changes.empty()) return false;
  std::string text = deck::load_text(changes).text.value_or("");
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text.find("*CONTROL_TERMINATION") != std::string::npos;
}

}  // namespace

std::string options_text(const Options& options) {
  Json json = json_of(options);
  json.erase("parameters");
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

output::RestartRecord make_restart_record(const RestartSettings& settings) {
  output::RestartRecord record;
  record.version = program_version();
  // Names of files may be in any encoding, which JSON does not allow.
  record.texts.push_back(settings.options.deck.string());
  for (const deck::RecordedText& text : settings.texts)
    for (const std::string* part : {&text.including, &text.asked, &text.name, &text.identity, &text.text})
      record.texts.push_back(*part);
  const Json json = {{"options", json_of(settings.options)}, {"warnings", settings.warnings}};
  record.settings = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return record;
}

Restart read_restart(const std::filesystem::path& place) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(place, ignored)) return read_one(place);
  const bool results = std::filesystem::is_directory(place / restart_folder, ignored);
  return read_newest(results ? place / restart_folder : place);
}

void set_restart_files_aside(const std::filesystem::path& results, const Restart& restart) {
  std::error_code ignored;
  output::remove_unfinished_files(results / restart_folder);
  for (const std::filesystem::path& path : restart_files(results / restart_folder)) {
    std::filesystem::path other = path;
    try {
      if (output::read_restart_file(path).record.cycle <= restart.content.record.cycle) continue;
      other += abandoned_ending;
    } catch (const Error&) {
      other += damaged_ending;
    }
    std::filesystem::rename(path, other, ignored);
  }
}

Options continued_options(const Options& asked, const Restart& restart) {
  Options options = restart.settings.options;
  options.restart = asked.restart;
  if (asked.restart_every.cycles > 0 || asked.restart_every.seconds > 0)
    options.restart_every = asked.restart_every;
  options.folder = asked.folder.empty() ? continued_folder(restart) : asked.folder;
  options.quiet = asked.quiet;
  options.report = asked.report;
  options.serve = asked.serve;
  options.token = asked.token;
  options.verify_search = asked.verify_search;
  options.notes = asked.notes;
  options.command = asked.command;
  options.allow_negative_contact_energy |= asked.allow_negative_contact_energy;
  options.d3plot = options.d3plot || asked.d3plot;
  options.all_fields = options.all_fields || asked.all_fields;
  options.dynain = options.dynain || asked.dynain;
  if (asked.threads) options.threads = asked.threads;
  if (asked.isa) options.isa = asked.isa;
  if (changes_end_time(asked.deck)) options.end_time.reset();
  if (asked.end_time) options.end_time = asked.end_time;
  return options;
}

std::filesystem::path continued_folder(const Restart& restart) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::weakly_canonical(restart.file, ignored);
  if (file.parent_path().filename() == restart_folder) {
    const std::filesystem::path results = restart.file.parent_path().parent_path();
    const bool is_named = restart.file.has_parent_path() && !results.empty();
    return is_named ? results : file.parent_path().parent_path();
  }
  throw Error(restart.file.string() +
              " does not lie in the folder of its results: name one for the new results with -o.");
}

}  // namespace crumple::app
