// SPDX-License-Identifier: BSD-3-Clause
//
// The extension module cellsearch._cellsearch: the search of the package cellsearch (python/cellsearch).

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cellsearch/search.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cellsearch::python {

namespace py = pybind11;

namespace {

template <class T>
using Numbers = py::array_t<T, py::array::c_style | py::array::forcecast>;

template <class T>
std::span<const T> span_of(const Numbers<T>& numbers) {
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}

/// Moves the memory of an array of the library to one of NumPy.
template <class T>
py::array_t<T> array_of(Array<T>&& numbers) {
  auto* const kept = new Array<T>(std::move(numbers));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<Array<T>*>(memory); });
  return py::array_t<T>(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}

/// A search with the arrays that it looks at.
class SearchOfArrays {
 public:
  SearchOfArrays(const std::string& method, int threads) : search_(settings_of(method, threads)) {}

  void set_mesh(Numbers<double> positions, Numbers<Index> segments) {
    positions_ = std::move(positions);
    segments_ = std::move(segments);
    scene_.positions = Positions(span_of(positions_));
    scene_.segments = Segments(span_of(segments_));
  }
  void set_segment_expansion(Numbers<double> values) {
    segment_expansion_ = std::move(values);
    scene_.segment_expansion = span_of(segment_expansion_);
  }
  void set_node_radius(Numbers<double> values) {
    node_radius_ = std::move(values);
    scene_.node_radius = span_of(node_radius_);
  }
  void set_nodes(const std::optional<Numbers<Index>>& nodes) {
    scene_.nodes.reset();
    if (!nodes) return;
    nodes_ = *nodes;
    scene_.nodes = span_of(nodes_);
  }
  void set_active(Numbers<std::uint8_t> active) {
    active_ = std::move(active);
    scene_.segment_active = span_of(active_);
  }
  void set_exclude_neighbours(bool exclude) { scene_.exclude_neighbours = exclude; }

  py::tuple query(double expansion) {
    scene_.expansion = expansion;
    {
      const py::gil_scoped_release other_threads_run;
      search_.find(scene_);
    }
    Candidates found = search_.take();
    return py::make_tuple(array_of(std::move(found.first)), array_of(std::move(found.node)));
  }

  py::dict statistics() const {
    const Statistics& counts = search_.statistics();
    py::dict result;
    result["segments"] = counts.segments;
    result["participants"] = counts.participants;
    result["cells"] = counts.cells;
    result["bytes"] = counts.bytes;
    result["cell_visits"] = counts.cell_visits;
    result["raw_visits"] = counts.raw_visits;
    result["candidates"] = counts.candidates;
    return result;
  }

 private:
  static Settings settings_of(const std::string& method, int threads) {
    Settings settings;
    const std::optional<Method> named = method_named(method);
    if (!named)
      throw py::value_error("There is no method '" + method + "': cellsearch.methods() lists them.");
    settings.method = *named;
    settings.threads = threads;
    return settings;
  }

  Scene scene_;
  Numbers<double> positions_;
  Numbers<Index> segments_;
  Numbers<double> segment_expansion_;
  Numbers<double> node_radius_;
  Numbers<Index> nodes_;
  Numbers<std::uint8_t> active_;
  Search search_;
};

}  // namespace

}  // namespace cellsearch::python

PYBIND11_MODULE(_cellsearch, module) {
  namespace py = pybind11;
  using cellsearch::python::SearchOfArrays;
  py::register_exception<cellsearch::Error>(module, "Error", PyExc_ValueError);
  py::class_<SearchOfArrays>(module, "SearchOfArrays")
      .def(py::init<const std::string&, int>())
      .def("set_mesh", &SearchOfArrays::set_mesh)
      .def("set_segment_expansion", &SearchOfArrays::set_segment_expansion)
      .def("set_node_radius", &SearchOfArrays::set_node_radius)
      .def("set_nodes", &SearchOfArrays::set_nodes)
      .def("set_active", &SearchOfArrays::set_active)
      .def("set_exclude_neighbours", &SearchOfArrays::set_exclude_neighbours)
      .def("query", &SearchOfArrays::query)
      .def_property_readonly("statistics", &SearchOfArrays::statistics);
  module.def("methods", [] {
    std::vector<std::string> names;
    for (const cellsearch::Method method : cellsearch::methods()) names.emplace_back(name_of(method));
    return names;
  });
}
