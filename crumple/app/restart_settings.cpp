// SPDX-License-Identifier: BSD-3-Clause
#include "app/restart_settings.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <nlohmann/json.hpp>

#include "app/restart_writer.hpp"
#include "base/error.hpp"

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
  return {{"deck", options.deck.string()},
          {"threads", optional(options.threads)},
          {"precision", optional(options.precision)},
          {"isa", optional(options.isa)},
          {"search", optional(options.search)},
          {"local_search", optional(options.local_search)},
          {"end_time", optional(options.end_time)},
          {"parameters", options.parameters},
          {"automatic_contact", options.automatic_contact},
          {"allow_unsupported", options.allow_unsupported},
          {"d3plot", options.d3plot},
          {"trace_energy", options.trace_energy},
          {"move_apart", options.move_apart},
          {"perturbation", options.perturbation},
          {"seed", options.seed}};
}

Options options_of(const Json& json) {
  Options options;
  options.deck = json.at("deck").get<std::string>();
  take(json, "threads", options.threads);
  take(json, "precision", options.precision);
  take(json, "isa", options.isa);
  take(json, "search", options.search);
  take(json, "local_search", options.local_search);
  take(json, "end_time", options.end_time);
  options.parameters = json.at("parameters").get<std::vector<std::pair<std::string, std::string>>>();
  options.automatic_contact = json.at("automatic_contact");
  options.allow_unsupported = json.at("allow_unsupported");
  options.d3plot = json.at("d3plot");
  options.trace_energy = json.at("trace_energy");
  options.move_apart = json.at("move_apart");
  options.perturbation = json.at("perturbation");
  options.seed = json.at("seed");
  return options;
}

RestartSettings settings_of(const output::RestartRecord& record) {
  RestartSettings settings;
  const Json json = Json::parse(record.settings);
  settings.options = options_of(json.at("options"));
  settings.warnings = json.at("warnings").get<std::vector<std::string>>();
  const Json& names = json.at("texts");
  if (names.size() != record.texts.size()) throw Error("The restart file is damaged: it lacks texts.");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [including, asked, name, identity] = names[i].get<std::array<std::string, 4>>();
    settings.texts.push_back({including, asked, name, identity, record.texts[i]});
  }
  return settings;
}

/// Where restart files may be, the newest first.
std::vector<std::filesystem::path> places_to_look(const std::filesystem::path& place) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(place, ignored)) return {place};
  std::filesystem::path folder = place;
  if (std::filesystem::is_directory(place / restart_folder, ignored)) folder = place / restart_folder;
  return {folder / newest_restart, folder / earlier_restart(1)};
}

/// Whether a deck of changes says when the run ends: that goes before what an earlier command line said.
bool changes_end_time(const std::filesystem::path& changes) {
  if (changes.empty()) return false;
  std::string text = deck::load_text(changes).text.value_or("");
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text.find("*CONTROL_TERMINATION") != std::string::npos;
}

}  // namespace

output::RestartRecord make_restart_record(const RestartSettings& settings) {
  output::RestartRecord record;
  record.version = program_version();
  Json names = Json::array();
  for (const deck::RecordedText& text : settings.texts) {
    names.push_back(std::array<std::string, 4>{text.including, text.asked, text.name, text.identity});
    record.texts.push_back(text.text);
  }
  const Json json = {
      {"options", json_of(settings.options)}, {"warnings", settings.warnings}, {"texts", names}};
  record.settings = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return record;
}

Restart read_restart(const std::filesystem::path& place) {
  std::string fault;
  for (const std::filesystem::path& path : places_to_look(place)) {
    try {
      Restart restart{path, output::read_restart_file(path), {}, {}};
      restart.settings = settings_of(restart.content.record);
      if (!fault.empty()) restart.note = fmt::format("{} {} is taken instead.", fault, path.string());
      return restart;
    } catch (const Json::exception&) {
      fault = path.string() + " is damaged: its settings cannot be read.";
    } catch (const Error& error) {
      if (fault.empty()) fault = error.what();
    }
  }
  throw Error(fault);
}

Options continued_options(const Options& asked, const Restart& restart) {
  Options options = restart.settings.options;
  options.restart = asked.restart;
  options.restart_every = asked.restart_every;
  options.folder = asked.folder.empty() ? continued_folder(restart) : asked.folder;
  options.quiet = asked.quiet;
  options.report = asked.report;
  options.verify_search = asked.verify_search;
  options.notes = asked.notes;
  options.d3plot = options.d3plot || asked.d3plot;
  if (asked.threads) options.threads = asked.threads;
  if (asked.isa) options.isa = asked.isa;
  if (changes_end_time(asked.deck)) options.end_time.reset();
  if (asked.end_time) options.end_time = asked.end_time;
  return options;
}

std::filesystem::path continued_folder(const Restart& restart) {
  const std::filesystem::path folder = restart.file.parent_path();
  if (folder.filename() == restart_folder) return folder.has_parent_path() ? folder.parent_path() : ".";
  std::filesystem::path results = restart.settings.options.deck.stem();
  return results += ".out";
}

}  // namespace crumple::app
