// SPDX-License-Identifier: Apache-2.0
// Derivations of grammars: trees as text, data and drawings.
#include "scene.h"

#include <fmt/format.h>
#include <vug/grammar/tree_output.h>

namespace vug::python {

void bind_derivation(py::module_& module) {
  py::class_<Derivation>(module, "Derivation",
                         "The derivation of a grammar. str() gives the tree as text.")
      .def_property_readonly("name", [](const Derivation& d) { return d.derivation->name; })
      .def_property_readonly(
          "productions", [](const Derivation& d) { return d.derivation->productions; },
          "Number of applied productions.")
      .def("__len__", [](const Derivation& d) { return d.tree().nodes.size(); })
      .def(
          "text", [](const Derivation& d) { return grammar::tree_text(d.tree()); },
          "The tree as text, as `vug tree` prints it.")
      .def(
          "svg", [](const Derivation& d) { return grammar::tree_svg(d.tree()); },
          "The tree as an SVG drawing.")
      .def(
          "data", [](const Derivation& d) { return from_json(grammar::tree_json(d.tree())); },
          "Nodes and productions as dicts and lists, as in `vug tree --json`.")
      .def("__str__", [](const Derivation& d) { return grammar::tree_text(d.tree()); })
      .def("__repr__", [](const Derivation& d) {
        return fmt::format("<vug.Derivation '{}', {} productions>", d.derivation->name,
                           d.derivation->productions);
      });
}

}  // namespace vug::python
