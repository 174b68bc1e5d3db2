// SPDX-License-Identifier: BSD-3-Clause
#include "deck/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <map>
#include <unordered_map>

#include "deck/build/build.hpp"
#include "deck/build/units.hpp"
#include "deck/format/cards.hpp"
#include "deck/format/numbers.hpp"
#include "deck/format/recorded_source.hpp"
#include "deck/format/scanner.hpp"
#include "deck/format/text_source.hpp"
#include "deck/keywords/control/settings.hpp"
#include "deck/keywords/keywords.hpp"
#include "deck/keywords/nearest_keyword.hpp"
#include "deck/keywords/read_includes.hpp"

namespace crumple::deck {

namespace {

/// What a keyword that is not supported would define.
IdKind kind_of_definition(std::string_view keyword) {
  if (keyword.starts_with("MAT_") || keyword.starts_with("EOS_")) return IdKind::Material;
  if (keyword.starts_with("SET_")) return IdKind::Set;
  if (keyword.starts_with("PART_")) return IdKind::Part;
  for (const std::string_view function : {"DEFINE_CURVE", "DEFINE_TABLE", "DEFINE_FUNCTION"})
    if (keyword.starts_with(function)) return IdKind::Function;
  return keyword.starts_with("DEFINE_") ? IdKind::Definition : IdKind::Other;
}

/// One reading: hands blocks to their readers and keeps account of what was left out.
class Reading final : private DeckHandler {
 public:
  /// `changes`: name of the file that may hold cards of a small restart alone; empty if there is none.
  Reading(TextSource& source, const ReadOptions& options, std::string changes = {})
      : options_(options),
        changes_(std::move(changes)),
        report_(options.allow_unsupported),
        recorder_(source, texts_),
        scanner_(options.keep_texts ? static_cast<TextSource&>(recorder_) : source, report_, *this) {
    for (const auto& [name, value] : options.parameters) parameters_.preset(name, value);
  }

  ReadResult run();

 private:
  void take_block(const Block& block) override;
  void take_setting(std::string_view text, const Where& where) override {
    if (may_set(where)) read_settings(text, where, options_.search_methods, deck_, report_);
  }
  std::vector<Inclusion> inclusions_of(const Block& block) override;
  void begin_file() override { parameters_.begin_file(); }
  void end_file() override { parameters_.end_file(); }
  void leave_out(const Block& block);
  void note_definition(const Block& block);
  void check_whole(const model::Model& model);

  bool is_change(const Where& where) const {
    return !changes_.empty() && report_.file_name(where.file) == changes_;
  }
  bool may_change(const Block& block);
  bool may_set(const Where& where);

  const ReadOptions& options_;
  std::string changes_;
  Report report_;
  std::vector<RecordedText> texts_;
  RecordingSource recorder_;
  Scanner scanner_;
  Parameters parameters_;
  RawDeck deck_;
  std::deque<Placement> placements_;        ///< of the files of *INCLUDE_TRANSFORM
  std::map<const Keyword*, Where> single_;  ///< keywords that count once, with their last place
  std::vector<IgnoredKeyword> ignored_;
  std::unordered_map<std::string_view, std::size_t> ignored_index_;  ///< by keyword
  bool has_keywords_ = false;
};

/// Whether a keyword may stand where it does: a small restart changes neither the model nor the step.
bool Reading::may_change(const Block& block) {
  if (!is_change(block.where)) return true;
  if (block.name == "TITLE" || block.name == "CONTROL_TERMINATION" || block.name.starts_with("DATABASE_"))
    return true;
  report_.error(
      block.where, "restart",
      "cannot change at a restart; *CONTROL_TERMINATION and *DATABASE can, anything else needs a new "
      "run");
  return false;
}

bool Reading::may_set(const Where& where) {
  if (!is_change(where)) return true;
  report_.error(where, "restart", "$crumple settings cannot change at a restart");
  return false;
}

void Reading::take_block(const Block& block) {
  has_keywords_ = true;
  if (!may_change(block)) return;
  if (Parameters::is_keyword(block.name)) {
    Cards cards(block, HeadingKind::None, parameters_, report_);
    parameters_.read(block.name, cards);
    return;
  }
  const std::optional<FoundKeyword> found = find_keyword(block.name);
  if (!found) {
    leave_out(block);
    return;
  }
  if (!found->keyword->repeats) {
    const auto [earlier, is_first] = single_.try_emplace(found->keyword, block.where);
    if (!is_first)
      report_.warning(
          block.where, "again",
          fmt::format("replaces what the same keyword says at {}", report_.place(earlier->second)));
    earlier->second = block.where;
  }
  Cards cards(block, found->heading, parameters_, report_);
  found->keyword->read(cards, deck_);
  cards.report_unread();
  if (cards.is_damaged() && std::ranges::find(deck_.faulty, block.where.keyword) == deck_.faulty.end())
    deck_.faulty.push_back(block.where.keyword);
}

std::vector<Inclusion> Reading::inclusions_of(const Block& block) {
  if (!may_change(block)) return {};
  Cards cards(block, HeadingKind::None, parameters_, report_);
  return read_include_transform(cards, deck_, placements_);
}

void Reading::leave_out(const Block& block) {
  note_definition(block);
  if (!options_.parameters.empty())
    for (const Line& line : block.lines) parameters_.note_references(line.text);
  if (block.name == "COMMENT") return;
  const IgnoredRow* row = find_ignored(block.name);
  if (row) {
    report_.warning(block.where, "ignored", fmt::format("is left out: {}", row->reason));
  } else if (block.name.empty()) {
    report_.error(block.where, "empty", "a keyword is missing behind the asterisk");
    return;
  } else {
    // All output keywords of LS-DYNA are known: another one is a mistake.
    const std::string_view fault =
        block.name.starts_with("DATABASE_") ? "LS-DYNA has no such keyword" : "this keyword is not supported";
    // Beyond so many there is no message, and finding the nearest keyword takes longer than reading.
    const bool is_shown = ignored_.size() < Report::most_kinds;
    const std::string advice = is_shown ? advice_on(block.name) : "";
    const std::string_view left_out = report_.allow_unsupported() ? ", and is left out" : "";
    const std::string_view link = advice.ends_with('?')                ? " If not, "
                                  : advice.starts_with("; nearest is") ? "; otherwise "
                                                                       : "; ";
    const std::string ending =
        report_.allow_unsupported()
            ? ""
            : fmt::format("{}remove it, or leave it out with --allow-unsupported", link);
    report_.unsupported(block.where, "keyword", fmt::format("{}{}{}{}", fault, left_out, advice, ending));
  }
  const Omission why = row                           ? Omission::Harmless
                       : report_.allow_unsupported() ? Omission::OnRequest
                                                     : Omission::Refused;
  // The scanner keeps the names.
  const auto [known, is_new] = ignored_index_.try_emplace(block.where.keyword, ignored_.size());
  if (is_new)
    ignored_.push_back(
        {std::string(block.where.keyword), report_.file_name(block.where.file), block.where.line, 1, why});
  else
    ++ignored_[known->second].count;
}

void Reading::note_definition(const Block& block) {
  constexpr std::string_view defining[] = {"MAT_",    "EOS_",  "SECTION_",  "SET_",
                                           "DEFINE_", "PART_", "HOURGLASS_"};
  const bool defines = std::any_of(std::begin(defining), std::end(defining),
                                   [&](std::string_view prefix) { return block.name.starts_with(prefix); });
  if (!defines) return;
  // The id is the first value of the first card, behind the title where there is one.
  const bool has_title = block.name.ends_with("_TITLE") || block.name.starts_with("PART_");
  const std::size_t line = has_title ? 1 : 0;
  if (line >= block.lines.size()) return;
  const std::string_view text = block.lines[line].text;
  const std::size_t comma = text.find(',');
  const std::size_t columns = block.format == ColumnFormat::Long ? 20 : 10;
  const auto id = parse_integer(trimmed(text.substr(0, std::min(comma, columns))));
  const std::int64_t placed = id && block.placement != nullptr
                                  ? block.placement->id(kind_of_definition(block.name), *id)
                                  : id.value_or(0);
  if (id) deck_.unsupported.push_back({placed, block.where});
}

void Reading::check_whole(const model::Model& model) {
  const Where whole{{}, 0, 0, 0};
  if (!deck_.termination)
    report_.error(whole, "termination", "*CONTROL_TERMINATION is missing; add it with the end time ENDTIM");
  if (deck_.nodes.empty()) report_.error(whole, "nodes", "the deck has no nodes; add *NODE");
  if (deck_.shells.empty() && deck_.solids.empty() && deck_.beams.empty() && deck_.discretes.empty() &&
      !deck_.nodes.empty())
    report_.error(whole, "elements",
                  "the deck has no elements that are supported; add *ELEMENT_SHELL or *ELEMENT_SOLID");
  else if (model.shells.empty() && model.solids.empty() && model.beams.empty() && model.discretes.empty() &&
           !report_.has_errors())
    report_.error(whole, "elements", "no element is left of the deck; see the messages about parts");
}

ReadResult Reading::run() {
  scanner_.read_deck();
  ReadResult result;
  result.files = scanner_.files();
  result.text_hash = scanner_.text_hash();
  result.ignored_keywords = ignored_;
  result.texts = std::move(texts_);
  result.parameters = parameters_.all();
  if (has_keywords_) {
    check_settings(deck_, report_);
    parameters_.report_unused_presets(report_);
    model::Model model = build_model(deck_, options_, report_);
    check_whole(model);
    result.unit_system = guess_units(model);
    if (!result.unit_system.empty() && !report_.has_errors())
      report_.add(Severity::Note, {{}, 0, 0, 0}, "units",
                  fmt::format("densities and moduli look like the units {}", result.unit_system));
    if (!report_.has_errors()) result.model = std::move(model);
  } else if (!report_.has_errors()) {
    report_.error({{}, 0, 0, 0}, "empty", "the file has no keywords, expected lines such as *NODE");
  }
  result.diagnostics = report_.sorted();
  return result;
}

}  // namespace

ReadResult read_deck(const std::filesystem::path& deck, const ReadOptions& options) {
  DiskSource source(deck);
  return Reading(source, options).run();
}

ReadResult read_recorded_deck(const std::vector<RecordedText>& texts, const ReadOptions& options,
                              const std::optional<std::filesystem::path>& changes) {
  std::optional<LoadedText> loaded;
  if (changes) loaded = load_text(*changes);
  const auto is_taken = [&](const RecordedText& text) { return loaded && text.name == loaded->name; };
  // The deck may have been overwritten by its changes.
  while (std::any_of(texts.begin(), texts.end(), is_taken)) loaded->name.insert(0, "./");
  const std::string name = loaded ? loaded->name : std::string();
  ReplaySource source(texts, std::move(loaded));
  return Reading(source, options, name).run();
}

ReadResult read_deck_text(std::string_view text, const ReadOptions& options,
                          const std::map<std::string, std::string>& included, const std::string& name) {
  MemorySource source(name, text, included);
  return Reading(source, options).run();
}

std::uint64_t hash_with_parameters(const ReadResult& deck) {
  std::uint64_t hash = deck.text_hash;
  for (const SetParameter& parameter : deck.parameters)
    if (parameter.is_preset) hash = fnv1a(hash, fmt::format("{}={}\n", parameter.name, parameter.value));
  return hash;
}

int error_count(const std::vector<Diagnostic>& diagnostics) {
  int count = 0;
  for (const Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == Severity::Error) count += diagnostic.count;
  return count;
}

}  // namespace crumple::deck
