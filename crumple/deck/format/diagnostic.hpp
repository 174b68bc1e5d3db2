// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace crumple::deck {

enum class Severity {
  Error,    ///< the deck cannot be run
  Warning,  ///< the run is possible, and differs from what the deck may have meant
  Note,     ///< for information
};

/// Something to tell the user about a place in the deck.
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string file;     ///< as the user wrote it, or as reached through *INCLUDE
  int line = 0;         ///< counted from 1; 0 is the file as a whole
  std::string message;  ///< starts with the keyword, ends with what to do
  int count = 1;        ///< for how many of one kind it stands
  /// What crumple lacks, such as "*SECTION_SHELL ELFORM 13"; empty if the deck is at fault.
  std::string missing{};
  std::string keyword{};  ///< with its asterisk, upper case; empty if it is about none
  int card = 0;           ///< data card of the keyword, counted from 1; 0 is the keyword as a whole
  std::string field{};    ///< empty if it is about none
};

/// `file:line: error: message`, the form that editors and compilers' users know. No newline.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace crumple::deck
