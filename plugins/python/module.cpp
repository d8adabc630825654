// SPDX-License-Identifier: Apache-2.0
// The extension module vug._vug, which the Python package `vug` imports.
#include "binding.h"

#include <vug/base/cpu_support.h>

PYBIND11_MODULE(_vug, module) {
  using namespace vug::python;
  if (const std::string missing = vug::missing_cpu_features(); !missing.empty())
    throw py::import_error("this processor lacks " + missing +
                           ", but this build of vug requires x86-64-v3");
  module.doc() = "The compiled part of the package vug.";
  module.attr("__version__") = VUG_VERSION;
  bind_errors(module);
  bind_mesh(module);
  bind_grids(module);
  bind_cells(module);
  bind_image(module);
  bind_diff(module);
  bind_derivation(module);
  bind_scene(module);
  bind_build(module);
  bind_export(module);
  bind_catalogue(module);
}
