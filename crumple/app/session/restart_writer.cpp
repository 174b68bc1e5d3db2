// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/restart_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

#include "output/files/atomic_file.hpp"
#include "output/files/own_file.hpp"
#include "output/files/write_error.hpp"

namespace crumple::app {

namespace {

constexpr const char* extension = ".restart";

/// latest.restart, previous2.restart, dump03.restart, last_good.restart, latest.restart.new.
bool is_our_name(std::string name) {
  constexpr std::string_view fresh = ".new";
  if (name.ends_with(fresh)) name.resize(name.size() - fresh.size());
  if (!name.ends_with(extension)) return false;
  name.resize(name.size() - std::string_view(extension).size());
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0) name.pop_back();
  return name == "latest" || name == "previous" || name == "dump" || name == "last_good";
}

bool is_multiple(long cycle, long interval) {
  return interval > 0 && cycle % interval == 0;
}

}  // namespace

std::string earlier_restart(int age) {
  return age == 1 ? "previous.restart" : fmt::format("previous{}.restart", age);
}

RestartWriter::RestartWriter(std::filesystem::path folder, const model::RestartRequests& deck,
                             const RestartInterval& asked, const domain::Clock& clock)
    : folder_(std::move(folder)), deck_(deck), asked_(asked), first_cycle_(clock.cycle) {}

void RestartWriter::goes_on_from(const std::filesystem::path& file, const domain::Clock& clock) {
  if (file.filename() == newest_restart) newest_cycle_ = clock.cycle;
}

bool RestartWriter::running_due(const domain::Clock& clock) const {
  return is_multiple(clock.cycle, deck_.running_cycles) || is_multiple(clock.cycle, asked_.cycles) ||
         (asked_.seconds > 0 && since_last_.seconds() >= asked_.seconds);
}

bool RestartWriter::dump_due(const domain::Clock& clock) const {
  return is_multiple(clock.cycle, deck_.dump_cycles);
}

bool RestartWriter::due(const domain::Clock& clock) const {
  return clock.cycle != first_cycle_ && (running_due(clock) || dump_due(clock));
}

bool RestartWriter::wanted() const {
  return deck_.running_cycles > 0 || deck_.dump_cycles > 0 || asked_.cycles > 0 || asked_.seconds > 0;
}

void RestartWriter::write(RestartKind kind, const domain::Clock& clock, const RestartSource& source) {
  if (kind == RestartKind::LastGood) write_file(folder_ / "last_good.restart", clock, source);
  if (kind == RestartKind::Due && dump_due(clock))
    write_file(folder_ / fmt::format("dump{:02}{}", clock.cycle / deck_.dump_cycles, extension), clock,
               source);
  if (kind == RestartKind::Newest || (kind == RestartKind::Due && running_due(clock)))
    write_newest(clock, source);
}

/// Unless it is that of this cycle.
void RestartWriter::write_newest(const domain::Clock& clock, const RestartSource& source) {
  if (clock.cycle == newest_cycle_) return;
  std::filesystem::path fresh = newest();
  fresh += ".new";
  write_file(fresh, clock, source);
  keep_earlier();
  std::error_code fault;
  std::filesystem::rename(fresh, newest(), fault);
  if (fault)
    throw output::WriteError(fmt::format("Cannot write {}: {}.", newest().string(), fault.message()));
  newest_cycle_ = clock.cycle;
  since_last_.restart();
}

void RestartWriter::write_file(const std::filesystem::path& path, const domain::Clock& clock,
                               const RestartSource& source) const {
  output::make_subfolder(folder_);
  output::RestartRecord record = make_restart_record(source.settings);
  record.time = clock.time;
  record.cycle = clock.cycle;
  output::write_restart_file(path, record, source.simulation, source.files);
}

/// Moves the newest file and those before it one place on; the oldest goes.
void RestartWriter::keep_earlier() const {
  std::error_code ignored;
  // Up to the first number that is free: the deck may ask for any count of files.
  int last = 1;
  while (last < deck_.running_files && std::filesystem::exists(folder_ / earlier_restart(last), ignored))
    ++last;
  for (int age = last; age > 0; --age) {
    const std::filesystem::path from = age == 1 ? newest() : folder_ / earlier_restart(age - 1);
    if (std::filesystem::exists(from, ignored))
      std::filesystem::rename(from, folder_ / earlier_restart(age), ignored);
  }
}

std::vector<std::filesystem::path> RestartWriter::files() const {
  return restart_files(folder_);
}

std::vector<std::filesystem::path> restart_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (is_our_name(entry.path().filename().string()) && entry.is_regular_file(ignored))
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

void remove_restart_files(const std::filesystem::path& results) {
  std::error_code ignored;
  const std::filesystem::path folder = results / restart_folder;
  if (!std::filesystem::is_directory(std::filesystem::symlink_status(folder, ignored))) return;
  output::remove_unfinished_files(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    std::string name = entry.path().filename().string();
    for (const std::string_view ending : {damaged_ending, abandoned_ending})
      if (name.ends_with(ending)) name.resize(name.size() - ending.size());
    if (is_our_name(name)) std::filesystem::remove(entry.path(), ignored);
  }
  std::filesystem::remove(folder, ignored);
}

}  // namespace crumple::app
