// SPDX-License-Identifier: BSD-3-Clause
//
// The extension module crumple._crumple: what the package crumple (python/crumple) needs of the library. The
// package is what users see; names here serve it alone.

#include "binding/arrays.hpp"

#include <fmt/core.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <sstream>

#include "app/program.hpp"
#include "binding/model_tables.hpp"
#include "binding/run.hpp"
#include "compare/measures/channel_filter.hpp"
#include "deck/build/units.hpp"
#include "output/files/write_error.hpp"

namespace crumple::python {

namespace py = pybind11;

namespace {

template <class T>
std::optional<T> optional_of(const py::dict& options, const char* name) {
  if (!options.contains(name) || options[name].is_none()) return std::nullopt;
  return options[name].cast<T>();
}

bool flag_of(const py::dict& options, const char* name) {
  return optional_of<bool>(options, name).value_or(false);
}

/// Of reading; names and meanings of app::Options.
app::Options reading_options(const std::string& path, const py::dict& asked) {
  app::Options options;
  options.deck = path;
  options.quiet = true;
  options.parameters = asked["parameters"].cast<std::vector<std::pair<std::string, std::string>>>();
  options.end_time = optional_of<double>(asked, "end_time");
  options.search = optional_of<std::string>(asked, "search");
  options.local_search = optional_of<std::string>(asked, "local_search");
  options.automatic_contact = flag_of(asked, "automatic_contact");
  options.ls_dyna_defaults = flag_of(asked, "ls_dyna_defaults");
  options.allow_unsupported = flag_of(asked, "allow_unsupported");
  options.perturbation = optional_of<double>(asked, "perturbation").value_or(0);
  options.seed = optional_of<std::uint64_t>(asked, "seed").value_or(1);
  return options;
}

/// Those of the deck and of running.
app::Options run_options(const DeckReading& deck, const py::dict& asked) {
  app::Options options = deck.options;
  options.threads = optional_of<int>(asked, "threads");
  options.precision = optional_of<std::string>(asked, "precision");
  options.isa = optional_of<std::string>(asked, "isa");
  options.folder = optional_of<std::string>(asked, "output").value_or("");
  options.d3plot = flag_of(asked, "d3plot");
  options.allow_negative_contact_energy = flag_of(asked, "allow_negative_contact_energy");
  options.accelerations = true;
  options.command = asked["command"].cast<std::vector<std::string>>();
  return options;
}

void add_errors(py::module_& module) {
  // Later ones are tried first, so bases come before what they are bases of.
  const auto& error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<NumericalError>(module, "NumericalError", error.ptr());
  py::register_exception<output::WriteError>(module, "OutputError", error.ptr());
  py::register_exception<InputError>(module, "DeckError", error.ptr());
}

void add_deck(py::module_& module) {
  py::class_<DeckReading, std::shared_ptr<DeckReading>>(module, "DeckReading")
      .def_property_readonly("can_be_built",
                             [](const DeckReading& deck) { return deck.result.model.has_value(); })
      .def_readonly("console", &DeckReading::console)
      .def_readonly("faults", &DeckReading::faults)
      .def_property_readonly("diagnostics", &diagnostics_of)
      .def_property_readonly("parameters", &parameters_of)
      .def_property_readonly("files",
                             [](const DeckReading& deck) {
                               std::vector<std::string> files;
                               for (const auto& file : deck.result.files) files.push_back(file.string());
                               return files;
                             })
      .def_property_readonly(
          "hash",
          [](const DeckReading& deck) { return fmt::format("{:016x}", hash_with_parameters(deck.result)); })
      .def_property_readonly("units",
                             [](const DeckReading& deck) { return deck::guess_units(model_of(deck)); })
      .def_property_readonly("title", [](const DeckReading& deck) { return py::bytes(model_of(deck).title); })
      .def_property_readonly("end_time",
                             [](const DeckReading& deck) { return model_of(deck).control.end_time; })
      .def_property_readonly("node_ids", &node_ids)
      .def_property_readonly("positions",
                             [](const py::object& self) {
                               const auto& nodes = model_of(self.cast<const DeckReading&>()).nodes;
                               return view_of_vectors(nodes.position, nodes.position.size(), self);
                             })
      .def("elements", &element_table)
      .def_property_readonly("parts", &part_table)
      .def("fault_at_start", &fault_at_start, py::call_guard<py::gil_scoped_release>());
  module.def("read_deck", [](const std::string& path, const py::dict& asked) {
    app::Options options = reading_options(path, asked);
    const py::gil_scoped_release other_threads_run;
    return std::const_pointer_cast<DeckReading>(read_deck(std::move(options)));
  });
}

py::array ids_of(const Run& run) {
  const std::vector<Index>& model_node = run.simulation().domain().nodes.model_node;
  const std::vector<UserId>& ids = run.simulation().model().nodes.id;
  py::array_t<std::int64_t> array(static_cast<py::ssize_t>(model_node.size()));
  for (std::size_t i = 0; i < model_node.size(); ++i)
    array.mutable_at(static_cast<py::ssize_t>(i)) = ids[static_cast<std::size_t>(model_node[i])];
  return array;
}

/// A view of a field of the nodes.
template <class Field>
auto node_view(Field domain::NodeFields::*field) {
  return [field](const py::object& self) {
    const domain::NodeFields& nodes = self.cast<const Run&>().simulation().domain().nodes;
    return view_of_vectors(nodes.*field, static_cast<std::size_t>(nodes.count()), self);
  };
}

py::array contact_forces_of(const py::object& self) {
  const domain::Domain& domain = self.cast<const Run&>().simulation().domain();
  return view_of_vectors(domain.contact_force, domain.contact_force.size(), self);
}

void add_arrays(py::class_<Run>& run) {
  run.def_property_readonly("node_ids", &ids_of)
      .def_property_readonly("deck_order",
                             [](const Run& self) {
                               const auto& order = self.simulation().domain().nodes.domain_node;
                               return py::array_t<Index>(static_cast<py::ssize_t>(order.size()),
                                                         order.data());
                             })
      .def_property_readonly("positions", node_view(&domain::NodeFields::position))
      .def_property_readonly("reference", node_view(&domain::NodeFields::reference))
      .def_property_readonly("velocities", node_view(&domain::NodeFields::velocity))
      .def_property_readonly("angular_velocities", node_view(&domain::NodeFields::angular_velocity))
      .def_property_readonly("accelerations", node_view(&domain::NodeFields::acceleration))
      .def_property_readonly("contact_forces", &contact_forces_of)
      .def_property_readonly("masses",
                             [](const py::object& self) {
                               const auto& nodes = self.cast<const Run&>().simulation().domain().nodes;
                               return view_of(nodes.mass.data(),
                                              {static_cast<py::ssize_t>(nodes.mass.size())}, {sizeof(double)},
                                              self);
                             })
      .def_property_readonly("energy_history", [](const Run& self) {
        const std::vector<EnergyRow>& rows = self.energy_history();
        return py::array_t<EnergyRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
      });
}

void add_run(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(EnergyRow, time, kinetic, internal, hourglass, contact, friction, rigidwall, damping,
                       external_work, eroded, total);
  py::class_<Run> run(module, "Run");
  run.def(py::init([](const std::shared_ptr<DeckReading>& deck, const py::dict& asked) {
       const app::Options options = run_options(*deck, asked);
       const double every = asked["history_every"].cast<double>();
       const py::gil_scoped_release other_threads_run;
       return std::make_unique<Run>(deck, options, every);
     }))
      .def("advance", &Run::advance)
      .def("interrupt", &Run::interrupt)
      .def("close", &Run::close)
      .def_property_readonly("closed", &Run::closed)
      .def_property_readonly("ending",
                             [](const Run& self) -> py::object {
                               const auto ending = self.ending();
                               if (!ending) return py::none();
                               return py::make_tuple(ending->termination, ending->reason,
                                                     static_cast<int>(ending->code));
                             })
      .def_property_readonly("warnings", &Run::warnings)
      .def_property_readonly("time", [](const Run& self) { return self.simulation().domain().clock.time; })
      .def_property_readonly("cycle", [](const Run& self) { return self.simulation().domain().clock.cycle; })
      .def_property_readonly("next_step", [](const Run& self) { return self.simulation().next_step(); })
      .def_property_readonly("energies",
                             [](const Run& self) {
                               const EnergyRow row = self.energies();
                               return py::array_t<EnergyRow>(1, &row);
                             })
      .def_property_readonly(
          "state_hash", [](Run& self) { return fmt::format("{:016x}", self.simulation().state_hash()); });
  add_arrays(run);
}

/// The program itself: exit code, standard output, standard error.
py::tuple run_program(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  app::ExitCode code = app::ExitCode::Normal;
  {
    const py::gil_scoped_release other_threads_run;
    code = app::run_program(arguments, {out, err});
  }
  return py::make_tuple(static_cast<int>(code), py::bytes(out.str()), py::bytes(err.str()));
}

/// The filter of SAE J211-1; the interval in seconds. Throws pybind11::value_error where there are too few
/// samples.
py::array filtered(const std::vector<double>& values, int cfc, double interval) {
  if (!compare::can_filter(cfc, interval))
    throw py::value_error(fmt::format(
        "Samples every {:g} s do not do for the channel frequency class {}: its corner frequency, 2.0775 "
        "times the class, must be below a quarter of their rate.",
        interval, cfc));
  const std::vector<double> result = compare::channel_filter(values, cfc, interval);
  return py::array_t<double>(static_cast<py::ssize_t>(result.size()), result.data());
}

}  // namespace

}  // namespace crumple::python

PYBIND11_MODULE(_crumple, module) {
  crumple::python::add_errors(module);
  crumple::python::add_deck(module);
  crumple::python::add_run(module);
  module.def("run_program", &crumple::python::run_program);
  module.def("channel_filter", &crumple::python::filtered);
  module.attr("version") = crumple::app::program_version();
}
