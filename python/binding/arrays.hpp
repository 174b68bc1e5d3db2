// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace crumple::python {

/// A read-only array of NumPy over memory of `owner`, which lives as long as the array. Nothing is copied.
/// `shape` in numbers, `strides` in bytes.
template <class T>
pybind11::array view_of(const T* data, std::vector<pybind11::ssize_t> shape,
                        std::vector<pybind11::ssize_t> strides, const pybind11::object& owner) {
  pybind11::array array(pybind11::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// The same of the first three doubles of each entry: shape (count, 3).
template <class Entries>
pybind11::array view_of_vectors(const Entries& entries, std::size_t count, const pybind11::object& owner) {
  using Entry = typename Entries::value_type;
  static_assert(sizeof(Entry) >= 3 * sizeof(double));
  return view_of(reinterpret_cast<const double*>(entries.data()), {static_cast<pybind11::ssize_t>(count), 3},
                 {static_cast<pybind11::ssize_t>(sizeof(Entry)), sizeof(double)}, owner);
}

}  // namespace crumple::python
