// SPDX-License-Identifier: BSD-3-Clause
#include "binding/model_tables.hpp"

#include <cstdint>

namespace crumple::python {

namespace py = pybind11;

namespace {

const char* name_of(model::ElementKind kind) {
  switch (kind) {
    case model::ElementKind::Shell:
      return "shell";
    case model::ElementKind::Solid:
      return "solid";
    case model::ElementKind::Beam:
      return "beam";
    case model::ElementKind::Discrete:
      return "discrete";
  }
  return "";
}

template <class Element>
py::dict table_of(const model::Model& model, const std::vector<Element>& elements) {
  const auto count = static_cast<py::ssize_t>(elements.size());
  const auto corners = static_cast<py::ssize_t>(Element{}.node.size());
  py::array_t<std::int64_t> id(count);
  py::array_t<std::int64_t> part(count);
  py::array_t<std::int64_t> nodes(std::vector<py::ssize_t>{count, corners});
  auto ids = id.mutable_unchecked<1>();
  auto parts = part.mutable_unchecked<1>();
  auto corner = nodes.mutable_unchecked<2>();
  for (py::ssize_t e = 0; e < count; ++e) {
    const Element& element = elements[static_cast<std::size_t>(e)];
    ids(e) = element.id;
    parts(e) = model.parts[static_cast<std::size_t>(element.part)].id;
    for (py::ssize_t k = 0; k < corners; ++k) corner(e, k) = element.node[static_cast<std::size_t>(k)];
  }
  py::dict table;
  table["id"] = id;
  table["part"] = part;
  table["nodes"] = nodes;
  return table;
}

std::vector<int> elements_by_part(const model::Model& model) {
  std::vector<int> count(model.parts.size());
  const auto add = [&](const auto& elements) {
    for (const auto& element : elements) ++count[static_cast<std::size_t>(element.part)];
  };
  add(model.shells);
  add(model.solids);
  add(model.beams);
  add(model.discretes);
  return count;
}

/// A deck may have any bytes; what is no UTF-8 becomes a replacement character.
py::str text_of(const std::string& bytes) {
  PyObject* const text =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

const char* name_of(deck::Severity severity) {
  switch (severity) {
    case deck::Severity::Error:
      return "error";
    case deck::Severity::Warning:
      return "warning";
    case deck::Severity::Note:
      return "note";
  }
  return "";
}

}  // namespace

const model::Model& model_of(const DeckReading& deck) {
  if (!deck.result.model) throw InputError(deck.console);
  return *deck.result.model;
}

py::array node_ids(const DeckReading& deck) {
  const std::vector<UserId>& ids = model_of(deck).nodes.id;
  return py::array_t<std::int64_t>(static_cast<py::ssize_t>(ids.size()), ids.data());
}

py::dict element_table(const DeckReading& deck, const std::string& kind) {
  const model::Model& model = model_of(deck);
  if (kind == "shell") return table_of(model, model.shells);
  if (kind == "solid") return table_of(model, model.solids);
  if (kind == "beam") return table_of(model, model.beams);
  if (kind == "discrete") return table_of(model, model.discretes);
  throw py::value_error("There are no elements of kind '" + kind + "': shell, solid, beam and discrete are.");
}

py::list part_table(const DeckReading& deck) {
  const model::Model& model = model_of(deck);
  const std::vector<int> counts = elements_by_part(model);
  py::list parts;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const model::Part& part = model.parts[i];
    py::dict row;
    row["id"] = part.id;
    row["title"] = text_of(part.title);
    row["kind"] = name_of(model::kind_of(part));
    row["rigid"] = model::is_rigid(model, part);
    row["elements"] = counts[i];
    parts.append(row);
  }
  return parts;
}

py::list diagnostics_of(const DeckReading& deck) {
  py::list list;
  for (const deck::Diagnostic& diagnostic : deck.result.diagnostics) {
    py::dict row;
    row["severity"] = name_of(diagnostic.severity);
    row["file"] = text_of(diagnostic.file);
    row["line"] = diagnostic.line;
    row["keyword"] = text_of(diagnostic.keyword);
    row["card"] = diagnostic.card;
    row["field"] = text_of(diagnostic.field);
    row["message"] = text_of(diagnostic.message);
    row["count"] = diagnostic.count;
    row["text"] = text_of(deck::to_string(diagnostic));
    list.append(row);
  }
  return list;
}

py::dict parameters_of(const DeckReading& deck) {
  py::dict parameters;
  for (const deck::SetParameter& parameter : deck.result.parameters)
    parameters[text_of(parameter.name)] =
        py::make_tuple(text_of(parameter.value), parameter.is_preset ? "command line" : "deck");
  return parameters;
}

}  // namespace crumple::python
