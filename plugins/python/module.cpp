// The extension module vug._vug, which the Python package `vug` imports.
#include "binding.h"

PYBIND11_MODULE(_vug, module) {
  using namespace vug::python;
  if (!__builtin_cpu_supports("avx2"))
    throw py::import_error("this build of vug needs a processor with AVX2 (2013 or later)");
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
