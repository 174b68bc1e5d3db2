// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace crumple::deck {

/// Kinds of ids, as *INCLUDE_TRANSFORM distinguishes them: each has an offset of its own.
enum class IdKind {
  None,        ///< no id
  Node,        ///< IDNOFF
  Element,     ///< IDEOFF
  Part,        ///< IDPOFF: parts, nodal rigid bodies, constrained node sets, rigid walls, cross-sections
  Material,    ///< IDMOFF: materials and equations of state
  Set,         ///< IDSOFF
  Function,    ///< IDFOFF: curves, tables, functions
  Definition,  ///< IDDOFF: all else that *DEFINE defines
  Other,       ///< IDROFF: sections, hourglass controls, contacts and all others
};

inline constexpr std::size_t id_kinds = 9;

/// What is added to the ids of a file, by kind.
using IdOffsets = std::array<std::int64_t, id_kinds>;

/// What a field of this name in LS-DYNA's manual is the id of. None: the name says nothing.
constexpr IdKind kind_of_name(std::string_view name) {
  struct Named {
    std::string_view name;
    IdKind kind;
  };
  constexpr Named table[] = {
      {"NID", IdKind::Node},         {"NODEID", IdKind::Node},       {"N1", IdKind::Node},
      {"N2", IdKind::Node},          {"N3", IdKind::Node},           {"N4", IdKind::Node},
      {"N5", IdKind::Node},          {"N6", IdKind::Node},           {"N7", IdKind::Node},
      {"N8", IdKind::Node},          {"EID", IdKind::Element},       {"PID", IdKind::Part},
      {"PIDL", IdKind::Part},        {"PIDC", IdKind::Part},         {"MID", IdKind::Material},
      {"EOSID", IdKind::Material},   {"SID", IdKind::Set},           {"NSID", IdKind::Set},
      {"NSIDEX", IdKind::Set},       {"HSID", IdKind::Set},          {"BSID", IdKind::Set},
      {"SSID", IdKind::Set},         {"DSID", IdKind::Set},          {"PSID", IdKind::Set},
      {"ESID", IdKind::Set},         {"LCID", IdKind::Function},     {"LCSS", IdKind::Function},
      {"LCSR", IdKind::Function},    {"LCD", IdKind::Function},      {"LCR", IdKind::Function},
      {"LCDR", IdKind::Function},    {"TBID", IdKind::Function},     {"CURVEID", IdKind::Function},
      {"BOXID", IdKind::Definition}, {"SBOXID", IdKind::Definition}, {"MBOXID", IdKind::Definition},
      {"CID", IdKind::Definition},   {"VID", IdKind::Definition},    {"TRANID", IdKind::Definition},
      {"SECID", IdKind::Other},      {"HGID", IdKind::Other},
  };
  for (const Named& named : table)
    if (named.name == name) return named.kind;
  return IdKind::None;
}

}  // namespace crumple::deck
