// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/block.hpp"
#include "deck/format/field.hpp"
#include "deck/format/parameters.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

/// The values of one card, by the names of its layout. Asking for a name that the layout lacks is a bug.
class Card {
 public:
  double real(std::string_view name) const { return value(name).real; }
  std::int64_t integer(std::string_view name) const { return value(name).integer; }
  std::string_view text(std::string_view name) const { return value(name).text; }
  /// The field is not blank.
  bool given(std::string_view name) const { return !value(name).text.empty(); }
  /// The field was read and checked without a fault.
  bool good(std::string_view name) const { return value(name).good; }
  /// An id as the card has it, without the offset of its file.
  std::int64_t written(std::string_view name) const { return value(name).written; }
  /// A number as the card has it, before the transformation of its file.
  double written_real(std::string_view name) const { return value(name).written_real; }
  /// By position, for cards that are lists of the same kind of value.
  std::int64_t integer(std::size_t field) const { return values_[field].integer; }
  bool good(std::size_t field) const { return values_[field].good; }

  const Where& where() const { return where_; }

 private:
  friend class Cards;
  struct Value {
    double real = 0;
    std::int64_t integer = 0;
    std::int64_t written = 0;
    double written_real = 0;
    std::string_view text;  ///< as written, parameters not replaced
    bool good = true;
  };

  const Value& value(std::string_view name) const;

  Layout layout_;
  std::array<Value, max_fields> values_{};
  Where where_;
};

/// The kind of the id in a keyword that acts on a node, on a node set (_SET) or on a rigid part (_RIGID).
IdKind kind_of_target(const Card& card);

/// What the _TITLE and _ID forms of a keyword put before an item.
struct Heading {
  std::int64_t id = 0;
  std::string title;
};

/// Which line, if any, goes before every item of a keyword.
enum class HeadingKind {
  None,
  Title,     ///< a line of text
  Identity,  ///< a card with a number and a text
};

/// What a reader has asked for: a card, or a line of text.
struct CardUse {
  Layout layout;          ///< empty of a line of text
  std::string_view text;  ///< what that is for
};

/// Reads the lines of a block card by card: fixed columns or, where a line has a comma, comma-separated.
/// Faults are reported with keyword, card and field; the value is then the field's default.
class Cards {
 public:
  Cards(const Block& block, HeadingKind heading, const Parameters& parameters, Report& report);

  /// A line is left, maybe a blank one.
  bool has_line() const { return next_ < block_->lines.size(); }
  /// A line that is not blank is left.
  bool more() const;
  /// The next line as it stands; empty if there is none.
  std::string_view peek() const { return has_line() ? block_->lines[next_].text : std::string_view(); }
  /// The next line as a card. A blank line has all defaults; a missing one is an error.
  /// A line without any number where one is expected is reported and skipped: what follows is read again as
  /// it was meant.
  Card next(Layout layout);
  /// The same for a last card that may be missing: it then has all defaults.
  Card next_or_default(Layout layout);
  /// The next line that is not blank. Call only where more() holds.
  Card next_filled(Layout layout);
  /// The heading that goes before an item; empty where the keyword's form has none.
  Heading heading();
  /// Leaves the rest of the block alone, because it has no influence on the run.
  void skip_rest() { next_ = block_->lines.size(); }
  /// Reports lines that nobody has read, unless they are blank or hold zeros only.
  void report_unread();
  /// The next line as text, blanks at the ends removed.
  std::string text_line(std::string_view what);

  /// Has every card and line of text that is read noted there, headings apart.
  void note_uses(std::vector<CardUse>& uses) { uses_ = &uses; }

  /// The parameters that are defined so far.
  const Parameters& parameters() const { return *parameters_; }

  /// What the ids and coordinates of the file become.
  const Placement& placement() const;

  /// A card was missing, out of its place or without a number as its first value, so that items may be
  /// missing.
  bool is_damaged() const { return is_damaged_; }

  /// The keyword as a whole.
  const Where& where() const { return block_->where; }
  Report& report() const { return *report_; }

 private:
  void split_fixed(std::string_view line, Layout layout);
  void split_free(std::string_view line, Layout layout);
  bool is_free(std::string_view line, Layout layout) const;
  std::string_view without_tabs(std::string_view line, Layout layout, const Where& where);
  int width_of(const Field& field) const;
  std::string place_of(std::size_t field, Layout layout) const;
  Card empty_card(Layout layout);
  void take_line(Layout layout, Card& card);
  bool is_stray(Layout layout) const;
  void report_missing(const Card& card, Layout layout);
  void parse(std::size_t index, Card& card);
  void report_unreadable(const Card& card);
  bool read_number(std::size_t index, Card& card);
  void report_rest(const Card& card);
  void add_offsets(Card& card);
  void place(Card& card);
  void place_vector(Card& card, std::size_t first);
  void check_placed(const Card& card, std::size_t index);

  const Block* block_;
  HeadingKind heading_;
  const Parameters* parameters_;
  Report* report_;
  std::vector<CardUse>* uses_ = nullptr;
  std::size_t next_ = 0;
  std::int32_t card_ = 0;
  bool free_ = false;
  bool is_lost_ = false;  ///< no line was found that can be the card expected: the block is given up
  bool is_damaged_ = false;
  bool cut_by_tab_ = false;  ///< the fields of the line at hand cannot be told apart
  std::array<std::string_view, max_fields> slots_;
  std::string_view rest_;               ///< what follows the last field
  std::vector<FieldFault> unreadable_;  ///< fields of the card at hand that are not numbers
  std::string expanded_;                ///< the line at hand with its tabs replaced
};

}  // namespace crumple::deck
