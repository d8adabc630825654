// SPDX-License-Identifier: Apache-2.0
// Views of the library's memory as numpy arrays, and conversion of arrays from Python.
#pragma once

#include "binding.h"

#include <pybind11/numpy.h>
#include <vug/base/vec.h>

#include <memory>
#include <vector>

namespace vug::python {

/// A capsule that keeps `shared` alive as long as an array that has it as base.
template <class T>
py::capsule capsule_of(std::shared_ptr<const T> shared) {
  return py::capsule(new std::shared_ptr<const T>(std::move(shared)),
                     [](void* held) { delete static_cast<std::shared_ptr<const T>*>(held); });
}

/// A read-only array that shares the memory of its owner without a copy. Strides are in bytes.
py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* data, const py::handle& owner);

/// View with the shape (n,).
template <class T>
py::array view(const std::vector<T>& values, const py::handle& owner) {
  return view(py::dtype::of<T>(), {static_cast<py::ssize_t>(values.size())}, {sizeof(T)},
              values.data(), owner);
}
/// View with the shape (n, arity), or (n,) if arity is 1.
py::array view(const std::vector<float>& values, int arity, const py::handle& owner);
/// View with the shape (n, 3).
py::array view(const std::vector<Vec3f>& values, const py::handle& owner);

/// Converts an argument to an array of real numbers with this number of columns (0: any; then a
/// one-dimensional array is one column) and rows (-1: any). Messages call it `what`. TypeError for
/// other types of numbers, ValueError for another shape.
py::array_t<double> number_array(const py::handle& given, const std::string& what,
                                 py::ssize_t columns, py::ssize_t rows = -1);
/// Converts an argument to an array of integers; see number_array.
py::array_t<int64_t> integer_array(const py::handle& given, const std::string& what,
                                   py::ssize_t columns);

/// The lowest and the highest corner as an array with the shape (2, 3); no value for an empty box.
std::optional<py::array_t<double>> corners(const Box3d& box);

}  // namespace vug::python
