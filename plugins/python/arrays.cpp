// SPDX-License-Identifier: Apache-2.0
#include "arrays.h"

#include <fmt/format.h>

namespace vug::python {
namespace {

using Strides = std::vector<py::ssize_t>;

/// Converts an argument to an array whose numbers have one of the kinds ("f" floats, ...).
py::array as_array(const py::handle& given, const std::string& what, const std::string& kinds,
                   const std::string& meaning) {
  const py::array array = py::module_::import("numpy").attr("asarray")(given);
  // numpy converts an empty list to floats; it holds no values of a wrong type.
  if (array.size() > 0 && kinds.find(array.dtype().kind()) == std::string::npos)
    throw py::type_error(fmt::format("{} must be {}, not {}", what, meaning,
                                     py::str(array.dtype()).cast<std::string>()));
  return array;
}

void require_shape(const py::array& array, const std::string& what, py::ssize_t columns,
                   py::ssize_t rows) {
  const bool column = columns == 0 && array.ndim() == 1;
  const bool fits = column || (array.ndim() == 2 && (columns == 0 || array.shape(1) == columns));
  if (fits && (rows < 0 || array.shape(0) == rows)) return;
  throw py::value_error(fmt::format("{} must have the shape ({}, {}), not {}", what,
                                    rows < 0 ? "n" : fmt::format("{}", rows),
                                    columns == 0 ? "k" : fmt::format("{}", columns),
                                    py::str(array.attr("shape")).cast<std::string>()));
}

/// Whether the array was an empty list, which has no columns.
bool is_nothing(const py::array& array) { return array.ndim() == 1 && array.shape(0) == 0; }

}  // namespace

py::array view(const py::dtype& type, Strides shape, Strides strides, const void* data,
               const py::handle& owner) {
  py::array out(type, std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(out.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return out;
}

py::array view(const std::vector<float>& values, int arity, const py::handle& owner) {
  if (arity == 1) return view(values, owner);
  return view(py::dtype::of<float>(), {static_cast<py::ssize_t>(values.size()) / arity, arity},
              {static_cast<py::ssize_t>(sizeof(float)) * arity, sizeof(float)}, values.data(),
              owner);
}

py::array view(const std::vector<Vec3f>& values, const py::handle& owner) {
  return view(py::dtype::of<float>(), {static_cast<py::ssize_t>(values.size()), 3},
              {sizeof(Vec3f), sizeof(float)}, values.data(), owner);
}

py::array_t<double> number_array(const py::handle& given, const std::string& what,
                                 py::ssize_t columns, py::ssize_t rows) {
  const py::array array = as_array(given, what, "fiu", "real numbers");
  if (!is_nothing(array) || rows > 0) require_shape(array, what, columns, rows);
  return array.cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
}

py::array_t<int64_t> integer_array(const py::handle& given, const std::string& what,
                                   py::ssize_t columns) {
  const py::array array = as_array(given, what, "iu", "integers");
  if (!is_nothing(array)) require_shape(array, what, columns, -1);
  return array.cast<py::array_t<int64_t, py::array::c_style | py::array::forcecast>>();
}

std::optional<py::array_t<double>> corners(const Box3d& box) {
  if (box.isEmpty()) return std::nullopt;
  py::array_t<double> out({2, 3});
  for (int i = 0; i < 3; ++i) {
    out.mutable_at(0, i) = box.min[i];
    out.mutable_at(1, i) = box.max[i];
  }
  return out;
}

}  // namespace vug::python
