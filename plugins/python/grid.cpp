// SPDX-License-Identifier: Apache-2.0
// Grids: their properties, and their voxels as arrays.
#include "grid.h"

#include "arrays.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/volume/dense.h>
#include <vug/volume/io.h>

namespace vug::python {
namespace {

Vec3i index(const py::handle& given, const std::string& what) {
  const auto numbers = integer_array(given, what, 0);
  if (numbers.size() != 3) throw py::value_error(what + " must be three integers");
  Vec3i out;
  for (int i = 0; i < 3; ++i) {
    const int64_t n = numbers.data()[i];
    if (n < -(1 << 30) || n > (1 << 30))
      throw py::value_error(what + " is not a valid voxel index");
    out[i] = static_cast<int>(n);
  }
  return out;
}

py::tuple dense(const Grid& grid, const py::object& lower, const py::object& upper) {
  const volume::Statistics about = grid.grid.statistics();
  const Vec3i from = lower.is_none() ? about.index_min : index(lower, "lower");
  const Vec3i to = upper.is_none() ? about.index_max : index(upper, "upper");
  std::vector<py::ssize_t> shape;
  double bytes = sizeof(float);
  for (int i = 0; i < 3; ++i) {
    shape.push_back(std::max(0, to[i] - from[i] + 1));
    bytes *= static_cast<double>(shape.back());
  }
  require_memory(bytes, available_memory() / 10 * 9, "the array of voxels",
                 "request a smaller box");
  py::array_t<float> out(shape);
  float* const data = out.mutable_data();
  {
    const py::gil_scoped_release others;
    volume::copy_dense(grid.grid, from, to, data);
  }
  return py::make_tuple(out, py::make_tuple(from.x, from.y, from.z));
}

py::array_t<double> values(const LevelSet& set, const py::handle& given) {
  const auto points = number_array(given, "points", 3);
  const auto count = static_cast<size_t>(points.size() / 3);
  std::vector<Vec3d> at(count);
  for (size_t i = 0; i < count; ++i) {
    const double* p = points.data() + 3 * i;
    at[i] = {p[0], p[1], p[2]};
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::fabs(p[axis]) < 1e9))
        throw py::value_error(fmt::format("point {} is not finite or too far away", i));
  }
  std::vector<double> out;
  {
    const py::gil_scoped_release others;
    out = set.level_set().values(at);
  }
  return py::array_t<double>(static_cast<py::ssize_t>(out.size()), out.data());
}

void save_grid(const Grid& grid, const std::filesystem::path& file) {
  const py::gil_scoped_release others;
  if (extension_of(file) != ".vdb")
    throw Error(ErrorCode::bad_input,
                fmt::format("invalid file name '{}' for a grid", file.string()), {},
                "use the extension .vdb");
  volume::write(file, {grid.grid}, grid.write);
}

std::string represent(const char* type, const Grid& grid) {
  return fmt::format("<vug.{} '{}', {} active voxels of {:g} m>", type, grid.grid.name(),
                     grid.grid.statistics().active_voxels, grid.grid.voxel_size().x);
}

}  // namespace

void bind_grids(py::module_& module) {
  py::class_<Grid>(module, "Grid", "A sparse voxel grid: a level set or a fog volume.")
      .def_property_readonly("name", [](const Grid& g) { return g.grid.name(); })
      .def_property_readonly(
          "kind", [](const Grid& g) { return volume::to_string(g.grid.grid_class()); },
          "'level set' or 'fog volume'.")
      .def_property_readonly(
          "voxel", [](const Grid& g) { return g.grid.voxel_size().x; },
          "Edge length of a voxel, metres.")
      .def_property_readonly(
          "origin",
          [](const Grid& g) {
            const Vec3d o = volume::origin_of(g.grid);
            return py::make_tuple(o.x, o.y, o.z);
          },
          "World-space centre of voxel (0, 0, 0), metres.")
      .def_property_readonly("active_voxels",
                             [](const Grid& g) { return g.grid.statistics().active_voxels; })
      .def_property_readonly(
          "memory", [](const Grid& g) { return g.grid.statistics().memory_bytes; },
          "Memory use in bytes.")
      .def_property_readonly(
          "bounds", [](const Grid& g) { return corners(g.grid.statistics().bounds); },
          "Lowest and highest centre of the active voxels: (2, 3), metres in world space; None if\n"
          "no voxel is active.")
      .def("dense", &dense, "lower"_a = py::none(), "upper"_a = py::none(),
           "Returns (values, first): a float32 array [i, j, k] of the voxels with indices from\n"
           "lower to upper, both inclusive (default: the box of all active voxels), and the index\n"
           "of its first voxel. The centre of voxel (i, j, k) is origin + voxel * (i, j, k).\n"
           "Voxels outside the narrow band have plus or minus the background value.")
      .def("save", &save_grid, "file"_a, "Writes this grid to a .vdb.")
      .def("__repr__", [](const Grid& g) { return represent("Grid", g); });

  py::class_<LevelSet, Grid>(module, "LevelSet",
                             "Signed distances near a surface: metres, negative inside.")
      .def_property_readonly(
          "background", [](const LevelSet& s) { return s.level_set().background(); },
          "Half the width of the narrow band, metres, which is the value outside of it.")
      .def("values", &values, "points"_a,
           "Distances at points, (n, 3) metres in world space, as (n,) metres, by trilinear\n"
           "interpolation; plus or minus the background outside the narrow band.")
      .def("__repr__", [](const LevelSet& s) { return represent("LevelSet", s); });
}

}  // namespace vug::python
