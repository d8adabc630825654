// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the Python module, each of which binds one subject.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>

namespace vug::python {

namespace py = pybind11;
using namespace py::literals;

/// Functions that bind the subjects, in the order in which their classes depend on each other.
void bind_errors(py::module_& module);
void bind_mesh(py::module_& module);
void bind_grids(py::module_& module);
void bind_cells(py::module_& module);
void bind_image(py::module_& module);
void bind_diff(py::module_& module);
void bind_derivation(py::module_& module);
void bind_scene(py::module_& module);
void bind_build(py::module_& module);
void bind_export(py::module_& module);
void bind_catalogue(py::module_& module);

/// Converts JSON text to dicts, lists and numbers; T is the type of its top-level value.
template <class T = py::dict>
T from_json(const std::string& text) {
  return T(py::module_::import("json").attr("loads")(text));
}

}  // namespace vug::python
