// What every file of the Python module shares: each binds one subject.
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

/// In the order in which their classes need each other.
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

/// Text of JSON as dicts, lists and numbers; T is what it holds.
template <class T = py::dict>
T from_json(const std::string& text) {
  return T(py::module_::import("json").attr("loads")(text));
}

}  // namespace vug::python
