// Memory of ours as numpy arrays, and arrays of others as ours.
#pragma once

#include "binding.h"

#include <pybind11/numpy.h>
#include <vug/base/vec.h>

#include <memory>
#include <vector>

namespace vug::python {

/// Who owns what a view shows: `shared` lives as long as an array that has this base.
template <class T>
py::capsule capsule_of(std::shared_ptr<const T> shared) {
  return py::capsule(new std::shared_ptr<const T>(std::move(shared)),
                     [](void* held) { delete static_cast<std::shared_ptr<const T>*>(held); });
}

/// An array that shows memory of its owner, no copy; nobody can write through it. Strides in bytes.
py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* data, const py::handle& owner);

/// (n,) numbers.
template <class T>
py::array view(const std::vector<T>& values, const py::handle& owner) {
  return view(py::dtype::of<T>(), {static_cast<py::ssize_t>(values.size())}, {sizeof(T)},
              values.data(), owner);
}
/// (n, arity) numbers, or (n,) of arity 1.
py::array view(const std::vector<float>& values, int arity, const py::handle& owner);
/// (n, 3) numbers.
py::array view(const std::vector<Vec3f>& values, const py::handle& owner);

/// What was given as an array of real numbers with that many columns (0: any, then one dimension
/// is a column, too) and rows (-1: any); `what` is its name in messages. TypeError for what holds
/// no such numbers, ValueError for another shape.
py::array_t<double> number_array(const py::handle& given, const std::string& what,
                                 py::ssize_t columns, py::ssize_t rows = -1);
/// The same of whole numbers.
py::array_t<int64_t> integer_array(const py::handle& given, const std::string& what,
                                   py::ssize_t columns);

/// ((x, y, z), (x, y, z)) as an array of 2 x 3; nothing for an empty box.
std::optional<py::array_t<double>> corners(const Box3d& box);

}  // namespace vug::python
