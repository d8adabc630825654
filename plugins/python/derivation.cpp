// How grammars derived: trees as text, data and drawings.
#include "scene.h"

#include <fmt/format.h>
#include <vug/grammar/tree_output.h>

namespace vug::python {

void bind_derivation(py::module_& module) {
  py::class_<Derivation>(module, "Derivation",
                         "How a grammar derived its word. Printed, it is a tree.")
      .def_property_readonly("name", [](const Derivation& d) { return d.derivation->name; })
      .def_property_readonly(
          "productions", [](const Derivation& d) { return d.derivation->productions; },
          "How many productions were applied.")
      .def("__len__", [](const Derivation& d) { return d.tree().nodes.size(); })
      .def(
          "text", [](const Derivation& d) { return grammar::tree_text(d.tree()); },
          "As `vug tree` prints it.")
      .def(
          "svg", [](const Derivation& d) { return grammar::tree_svg(d.tree()); }, "A drawing.")
      .def(
          "data", [](const Derivation& d) { return from_json(grammar::tree_json(d.tree())); },
          "Nodes and productions as `vug tree --json` gives them, in dicts and lists.")
      .def("__str__", [](const Derivation& d) { return grammar::tree_text(d.tree()); })
      .def("__repr__", [](const Derivation& d) {
        return fmt::format("<vug.Derivation '{}', {} productions>", d.derivation->name,
                           d.derivation->productions);
      });
}

}  // namespace vug::python
