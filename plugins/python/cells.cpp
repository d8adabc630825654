// SPDX-License-Identifier: Apache-2.0
// Cells on a surface: their positions and attributes as arrays that share memory.
#include "cells.h"

#include "arrays.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/building/cell_points.h>
#include <vug/delivery/cells_files.h>

namespace vug::python {
namespace {

/// Getter of an array of the network.
template <class Member>
auto network_array(Member cells::Network::*member) {
  return [member](const Cells& self) {
    return view(self.layer->network().*member, capsule_of(self.layer));
  };
}

py::dict cell_attributes(const Cells& self) {
  py::dict out;
  const py::capsule owner = capsule_of(self.layer);
  for (const cells::Attribute& each : self.layer->simulation.attributes().all())
    std::visit([&](const auto& column) { out[py::str(each.name)] = view(column.now, owner); },
               each.column);
  return out;
}

py::array states(const Cells& self) {
  const std::vector<cells::CellState>& all = self.layer->simulation.states();
  static_assert(sizeof(cells::CellState) == 1);
  return view(py::dtype::of<uint8_t>(), {static_cast<py::ssize_t>(all.size())}, {1}, all.data(),
              capsule_of(self.layer));
}

std::vector<std::string> state_names() {
  std::vector<std::string> names;
  for (int s = 0; s <= static_cast<int>(cells::CellState::transparent); ++s)
    names.emplace_back(cells::name_of(static_cast<cells::CellState>(s)));
  return names;
}

py::tuple links(const Cells& self) {
  const cells::Links& links = self.layer->network().links;
  const py::capsule owner = capsule_of(self.layer);
  return py::make_tuple(view(links.begin, owner), view(links.to, owner));
}

void save_cells(const Cells& self, const std::filesystem::path& file) {
  const py::gil_scoped_release others;
  const std::string extension = extension_of(file);
  if (extension == ".csv") return delivery::write_table(file, *self.layer);
  if (extension != ".vdb")
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid file name '{}' for cells", file.string()), {},
                "use the extension .vdb for points or .csv for a table");
  volume::write(file, {building::cell_points(*self.plan, *self.layer)}, self.write);
}

}  // namespace

void bind_cells(py::module_& module) {
  using cells::Network;
  py::class_<Cells>(module, "Cells",
                    "A layer of n cells on meshes, with the results of its rules.\n\n"
                    "Its arrays are read-only views that share its memory and keep it alive.")
      .def_property_readonly("name", [](const Cells& c) { return c.plan->name; })
      .def_property_readonly(
          "spacing", [](const Cells& c) { return c.layer->network().spacing; },
          "Approximate distance between neighbouring cells, metres.")
      .def_property_readonly(
          "step", [](const Cells& c) { return c.layer->simulation.step(); },
          "Number of completed simulation steps.")
      .def("__len__", [](const Cells& c) { return c.layer->network().size(); })
      .def_property_readonly("positions", network_array(&Network::position),
                             "(n, 3) float32, metres.")
      .def_property_readonly("normals", network_array(&Network::normal),
                             "(n, 3) float32, unit normals that point out of the solid.")
      .def_property_readonly("tangents", network_array(&Network::right),
                             "(n, 3) float32, unit tangents that point right along the surface.")
      .def_property_readonly("areas", network_array(&Network::area),
                             "(n,) float32, area of each cell, square metres.")
      .def_property_readonly("objects", network_array(&Network::object),
                             "(n,) uint32, index of the mesh of each cell.")
      .def_property_readonly("states", &states, "(n,) uint8, indices into state_names.")
      .def_property_readonly_static("state_names", [](const py::object&) { return state_names(); })
      .def_property_readonly("links", &links,
                             "(begin, to): neighbours of cell i are to[begin[i]:begin[i + 1]].")
      .def_property_readonly("attributes", &cell_attributes,
                             "Attributes by name: (n,) float32 or int32, or (n, 3) float32.")
      .def("save", &save_cells, "file"_a,
           "Writes points to a .vdb or a table to a .csv, as `vug build` does.")
      .def("__repr__", [](const Cells& c) {
        return fmt::format("<vug.Cells '{}', {} after {} steps>", c.plan->name,
                           c.layer->network().size(), c.layer->simulation.step());
      });
}

}  // namespace vug::python
