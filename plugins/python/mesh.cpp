// SPDX-License-Identifier: Apache-2.0
// Meshes: arrays that share memory, files, metrics, and construction from arrays.
#include "mesh.h"

#include "arrays.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/mesh/format.h>
#include <vug/metrics/report.h>

namespace vug::python {
namespace {

std::vector<Vec3f> vectors(const py::handle& given, const std::string& what,
                           py::ssize_t rows = -1) {
  const auto array = number_array(given, what, 3, rows);
  std::vector<Vec3f> out(static_cast<size_t>(array.size() / 3));
  for (size_t i = 0; i < out.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      out[i][axis] = static_cast<float>(array.data()[3 * i + static_cast<size_t>(axis)]);
  return out;
}

std::vector<mesh::Triangle> triangles(const py::handle& given, size_t vertices) {
  const auto array = integer_array(given, "triangles", 3);
  std::vector<mesh::Triangle> out(static_cast<size_t>(array.size() / 3));
  for (size_t i = 0; i < out.size(); ++i)
    for (size_t c = 0; c < 3; ++c) {
      const int64_t vertex = array.data()[3 * i + c];
      if (vertex < 0 || static_cast<uint64_t>(vertex) >= vertices)
        throw py::value_error(fmt::format(
            "triangle {} refers to vertex {}, but the mesh has {} vertices", i, vertex, vertices));
      out[i][c] = static_cast<uint32_t>(vertex);
    }
  return out;
}

mesh::Attribute attribute(const py::handle& name, const py::handle& given, size_t vertices) {
  if (!py::isinstance<py::str>(name)) throw py::type_error("names of attributes must be strings");
  mesh::Attribute out;
  out.name = name.cast<std::string>();
  const auto array = number_array(given, fmt::format("attribute '{}'", out.name), 0,
                                  static_cast<py::ssize_t>(vertices));
  out.arity = array.ndim() == 2 ? static_cast<int>(array.shape(1)) : 1;
  out.values.assign(array.data(), array.data() + array.size());
  return out;
}

Mesh from_arrays(const py::object& positions, const py::object& corners, const py::object& normals,
                 const py::dict& attributes) {
  mesh::Mesh out;
  out.positions = vectors(positions, "positions");
  out.triangles = triangles(corners, out.positions.size());
  const auto rows = static_cast<py::ssize_t>(out.positions.size());
  if (!normals.is_none()) out.normals = vectors(normals, "normals", rows);
  for (const auto& [name, values] : attributes)
    out.attributes.push_back(attribute(name, values, out.positions.size()));
  try {
    mesh::validate(out, "the mesh");
  } catch (const Error& error) {
    throw py::value_error(error.what());
  }
  return {std::make_shared<const mesh::Mesh>(std::move(out))};
}

py::dict mesh_attributes(const Mesh& self) {
  py::dict out;
  const py::capsule owner = capsule_of(self.mesh);
  for (const mesh::Attribute& each : self.mesh->attributes)
    out[py::str(each.name)] = view(each.values, each.arity, owner);
  return out;
}

py::array triangle_view(const Mesh& self) {
  return view(py::dtype::of<uint32_t>(), {static_cast<py::ssize_t>(self.mesh->triangles.size()), 3},
              {sizeof(mesh::Triangle), sizeof(uint32_t)}, self.mesh->triangles.data(),
              capsule_of(self.mesh));
}

py::dict measure_mesh(const Mesh& self) {
  std::string json;
  {
    const py::gil_scoped_release others;
    json = metrics::to_json(metrics::measure(*self.mesh));
  }
  return from_json(json);
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<Mesh>(module, "Mesh",
                   "Triangles in metres, right-handed, y up; anticlockwise seen from outside.\n\n"
                   "Its arrays are read-only views that share its memory and keep it alive.")
      .def(
          py::init(&from_arrays), "positions"_a, "triangles"_a, "normals"_a = py::none(),
          "attributes"_a = py::dict(),
          "Copies arrays: positions (n, 3) in metres, triangles (m, 3) as indices, normals (n, 3)\n"
          "of unit length, attributes {name: (n,) or (n, k)}; 'Cd' with three columns is linear\n"
          "colour. Raises ValueError or TypeError for unsuitable arrays.")
      .def_property_readonly(
          "positions", [](const Mesh& m) { return view(m.mesh->positions, capsule_of(m.mesh)); },
          "(n, 3) float32, metres.")
      .def_property_readonly(
          "normals",
          [](const Mesh& m) -> std::optional<py::array> {
            if (m.mesh->normals.empty()) return std::nullopt;
            return view(m.mesh->normals, capsule_of(m.mesh));
          },
          "(n, 3) float32, unit normals that point out of the solid; None without normals.")
      .def_property_readonly("triangles", &triangle_view, "(m, 3) uint32, indices of vertices.")
      .def_property_readonly("attributes", &mesh_attributes,
                             "Vertex attributes by name, (n,) or (n, k) float32; 'Cd' is linear\n"
                             "scene-referred colour.")
      .def_property_readonly(
          "bounds", [](const Mesh& m) { return corners(mesh::bounds(*m.mesh)); },
          "Lowest and highest corner, (2, 3) metres; None without vertices.")
      .def("measure", &measure_mesh,
           "Area, volume, genus and all other metrics of `vug measure --json` for a mesh file.")
      .def(
          "save",
          [](const Mesh& m, const std::filesystem::path& file) {
            const py::gil_scoped_release others;
            mesh::write_mesh(*m.mesh, file, m.notes);
          },
          "file"_a, "Writes a .ply, .obj or .stl; data that the format cannot store is omitted.")
      .def("__repr__", [](const Mesh& m) {
        return fmt::format("<vug.Mesh of {} vertices, {} triangles>", m.mesh->positions.size(),
                           m.mesh->triangles.size());
      });
  module.def(
      "read_mesh",
      [](const std::filesystem::path& file) {
        const py::gil_scoped_release others;
        Mesh out{std::make_shared<const mesh::Mesh>(mesh::read_mesh(file))};
        out.notes.texts = mesh::read_comments(read_text(file));
        return out;
      },
      "file"_a,
      "Reads a .ply, .obj or .stl, in metres. Files saved from the mesh keep its recipe.");
}

}  // namespace vug::python
