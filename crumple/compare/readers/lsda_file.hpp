// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::compare {

/// A file of LSTC's data archive (LSDA), the format of LS-DYNA's binout: variables of numbers in folders.
///
/// Layout: a header of 8 bytes (its own length, widths of the fields LENGTH, OFFSET, COMMAND and TYPE, order
/// of bytes); then records LENGTH COMMAND BODY. At byte 8 stands the offset of the first symbol table; each
/// table lists variables with the offsets of their data and ends with the offset of the next table, or zero.
class LsdaFile {
 public:
  /// Numbers of one variable.
  struct Variable {
    int type = 0;  ///< 1 to 4 signed, 5 to 8 unsigned integers of 1, 2, 4, 8 bytes; 9, 10 real of 4, 8
    std::size_t place = 0;    ///< of the first byte
    std::uint64_t count = 0;  ///< of numbers
  };

  /// Takes the bytes of a file. Throws Error if they do not begin as such a file. Where the symbol tables are
  /// damaged or missing, as in a file that was cut off, the records themselves are looked through up to the
  /// first that is not whole; `damage` then says so.
  explicit LsdaFile(std::string bytes);

  /// By path, `/glstat/d000001/time`.
  const std::map<std::string, Variable, std::less<>>& variables() const { return variables_; }

  std::vector<double> numbers(const Variable& variable) const;

  /// A sentence on what is wrong with the file; empty if nothing is.
  const std::string& damage() const { return damage_; }

 private:
  struct Record {
    std::uint64_t length = 0;  ///< with its head
    std::uint64_t command = 0;
    std::size_t body = 0;  ///< place behind the head
  };

  bool read_header();
  bool fits(std::uint64_t place, std::uint64_t size) const;
  std::uint64_t unsigned_at(std::size_t place, std::size_t width) const;
  bool read_record(std::uint64_t place, Record& record) const;
  bool read_tables();
  bool read_table(std::uint64_t place, std::uint64_t& next);
  bool read_symbol(const Record& record, const std::string& folder);
  void scan_records();
  bool read_data(std::uint64_t place, const Record& record, Variable& variable, std::string& name) const;
  double number_at(std::size_t place, int type) const;

  std::string bytes_;
  std::map<std::string, Variable, std::less<>> variables_;
  std::string damage_;
  std::uint64_t listed_bytes_ = 0;  ///< of the variables in the tables
  std::size_t header_width_ = 0;
  std::size_t length_width_ = 0;
  std::size_t offset_width_ = 0;
  std::size_t command_width_ = 0;
  std::size_t type_width_ = 0;
  bool little_endian_ = true;
};

}  // namespace crumple::compare
