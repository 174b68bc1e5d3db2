// SPDX-License-Identifier: BSD-3-Clause
#include "output/recorder.hpp"

#include "output/files/own_file.hpp"
#include "output/files/set_aside.hpp"
#include "output/initial_overlaps.hpp"

namespace crumple::output {
namespace {

/// How long rows may wait for their files.
constexpr std::chrono::milliseconds longest_wait{100};

}  // namespace

Recorder::Recorder(const std::filesystem::path& folder, const std::string& name, const View& view,
                   const ExtraFiles& extra)
    : folder_(folder),
      series_(folder, name, view, extra.opening, extra.all_fields),
      frame_schedule_(view.model.output.state_interval, default_frames, view.model.control) {
  if (extra.d3plot) d3plot_.emplace(folder, view, D3plotFamily::default_file_words, extra.opening);
  for (HistoryEntry& entry : histories_of(view))
    tables_.push_back({CsvFile(folder / entry.file, entry.header, extra.opening),
                       Schedule(entry.interval, entry.points, view.model.control),
                       std::move(entry.history),
                       {}});
  ask_for_foreign_forms(folder, view, extra.opening);
  if (const auto path = write_initial_overlaps(folder, view)) start_files_.push_back(*path);
}

void Recorder::ask_for_foreign_forms(const std::filesystem::path& folder, const View& view, Opening opening) {
  std::vector<std::string> branches;
  for (Table& table : tables_)
    for (SampledHistory* const sampled : table.history->sampled()) {
      const HistoryForm& form = sampled->form();
      const model::HistoryRequest& request = view.model.output.of(form.file);
      if (!request.asked) continue;
      sampled->complete();
      ForeignForm& foreign = table.foreign.emplace_back(ForeignForm{sampled, {}, {}});
      if (request.ascii) foreign.text = text_of(folder / form.name, opening);
      if (!request.binary) continue;
      foreign.branch = branches.size();
      branches.emplace_back(form.branch);
    }
  if (!branches.empty())
    binout_.emplace(folder / "binout0000", view.model.title, std::move(branches), opening);
}

std::size_t Recorder::text_of(const std::filesystem::path& path, Opening opening) {
  for (std::size_t i = 0; i < texts_.size(); ++i)
    if (texts_[i].path() == path) return i;
  texts_.emplace_back(path, opening);
  return texts_.size() - 1;
}

void Recorder::declare(domain::StateList& list) {
  series_.declare(list);
  if (d3plot_) d3plot_->declare(list);
  if (binout_) binout_->declare(list);
  for (TextFile& text : texts_) text.declare(list);
  frame_schedule_.declare("frames", list);
  for (Table& table : tables_) {
    table.file.declare(list);
    table.schedule.declare(table.file.path().filename().string(), list);
    table.history->declare(list);
  }
}

std::vector<std::string> Recorder::resume(const domain::Clock& clock) {
  std::vector<std::string> notes;
  remove_unfinished_files(folder_);
  series_.resume();
  if (d3plot_ && !d3plot_->is_whole())
    for (std::string& note : set_family_aside(folder_)) notes.push_back(std::move(note));
  if (d3plot_) d3plot_->resume();
  if (binout_) binout_->resume();
  for (TextFile& text : texts_) text.resume();
  frame_schedule_.resume(clock);
  for (Table& table : tables_) {
    table.file.resume();
    table.schedule.resume(clock);
  }
  return notes;
}

void Recorder::write_rows(Table& table, const View& view) {
  table.history->add_rows(view, table.file);
  has_waiting_rows_ = true;
  for (const ForeignForm& foreign : table.foreign) {
    const SampledHistory& sampled = *foreign.history;
    if (foreign.text)
      texts_[*foreign.text].add(view.model.title, sampled.form(), sampled.items(), sampled.sample());
    if (foreign.branch) binout_->add(*foreign.branch, sampled.form(), sampled.items(), sampled.sample());
  }
  table.schedule.mark_written(view.domain.clock);
}

void Recorder::flush() {
  has_waiting_rows_ = false;
  for (Table& table : tables_) table.file.flush();
  for (TextFile& text : texts_) text.flush();
  if (binout_) binout_->flush();
  flushed_ = std::chrono::steady_clock::now();
}

void Recorder::write_due(const View& view) {
  for (Table& table : tables_)
    if (table.schedule.due(view.domain.clock)) write_rows(table, view);
  if (binout_) binout_->end_group();
  if (has_waiting_rows_ && std::chrono::steady_clock::now() - flushed_ > longest_wait) flush();
  if (frame_schedule_.due(view.domain.clock)) write_frame(view);
}

void Recorder::write_last(const View& view) {
  for (Table& table : tables_)
    if (!table.schedule.has_written(view.domain.clock)) write_rows(table, view);
  flush();
  write_frame(view);
}

void Recorder::write_frame(const View& view) {
  if (frame_schedule_.has_written(view.domain.clock)) return;
  flush();
  series_.write_frame(view);
  if (d3plot_) d3plot_->write_state(view);
  frame_schedule_.mark_written(view.domain.clock);
}

std::vector<std::filesystem::path> Recorder::files() const {
  std::vector<std::filesystem::path> paths{series_.collection()};
  if (d3plot_) paths.push_back(d3plot_->first_file());
  for (const Table& table : tables_) paths.push_back(table.file.path());
  if (binout_) paths.push_back(binout_->path());
  for (const TextFile& text : texts_) paths.push_back(text.path());
  paths.insert(paths.end(), start_files_.begin(), start_files_.end());
  return paths;
}

}  // namespace crumple::output
