// SPDX-License-Identifier: Apache-2.0
// Products of a scene: level sets, meshes, cells, pictures, files.
#include "build.h"

#include "cells.h"
#include "grid.h"
#include "mesh.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/building/level_set_for_files.h>
#include <vug/delivery/describe_cells.h>
#include <vug/delivery/measure.h>
#include <vug/delivery/write_products.h>
#include <vug/loading/dependencies.h>
#include <vug/metrics/report.h>
#include <vug/shot/queries.h>
#include <nlohmann/json.hpp>

namespace vug::python {
namespace {

Build make_build(const std::shared_ptr<Scene>& scene, const Memory& max_memory, int threads,
                 const Callback& progress, const std::optional<std::filesystem::path>& checkpoint) {
  if (checkpoint && extension_of(*checkpoint) != ".vdb")
    throw py::value_error("a checkpoint is a VDB file of points: its name must end in .vdb");
  return Build(scene, {memory_limit_of(max_memory), checked_threads(threads), progress,
                       checkpoint.value_or(std::filesystem::path())});
}

LevelSet level_set(Build& build, const std::string& name) {
  const shot::Shot& shot = build.scene()->shot();
  const shot::VolumePtr plan = shot::find_volume(shot, name);
  std::optional<volume::Grid> made;
  build.work([&](building::Builder& builder) {
    made = building::level_set_for_files(builder, plan, shot::DistanceValues::bound)
               .named(plan->name)
               .stored_as_half(plan->half);
  });
  return {{*made, delivery::write_options(shot)}};
}

std::variant<LevelSet, Grid> volume_of(Build& build, const std::string& name) {
  const shot::VolumePtr plan = shot::find_volume(build.scene()->shot(), name);
  if (!plan->fog) return level_set(build, name);
  std::optional<volume::Grid> made;
  build.work([&](building::Builder& builder) {
    made = delivery::volume_grid(*plan, builder.level_set(plan));
  });
  return Grid{*made, delivery::write_options(build.scene()->shot())};
}

Mesh mesh(Build& build, const std::string& name) {
  const shot::MeshPtr plan = shot::find_mesh(build.scene()->shot(), name);
  Mesh made;
  made.notes = delivery::mesh_comments(build.scene()->shot());
  build.work([&](building::Builder& builder) { made.mesh = builder.mesh(plan); });
  return made;
}

Cells cells_of(Build& build, const std::string& name) {
  const shot::Shot& shot = build.scene()->shot();
  Cells made;
  made.plan = shot::find_cells(shot, name);
  made.write = delivery::write_options(shot);
  build.work([&](building::Builder& builder) { made.layer = builder.cell_layer(made.plan); });
  return made;
}

py::dict measure_build(Build& build, const std::string& name) {
  std::string json;
  build.work([&](building::Builder& builder) {
    json = metrics::to_json(delivery::measure(builder, name));
  });
  return from_json(json);
}

py::dict measure_cells(Build& build, const std::string& name) {
  const shot::CellsPtr plan = shot::find_cells(build.scene()->shot(), name);
  std::string json;
  build.work([&](building::Builder& builder) {
    json = delivery::describe_cells(builder, plan->name).dump();
  });
  return from_json(json);
}

/// Writes all products to a folder, or the grids to one file. Never overwrites inputs of the scene.
std::vector<std::filesystem::path> save_build(Build& build, const std::filesystem::path& to) {
  const bool grids = extension_of(to) == ".vdb";
  const shot::Shot& shot = build.scene()->shot();
  const auto paths = grids ? std::vector{to} : delivery::product_paths(shot, to);
  if (paths.empty() || (grids && shot.volumes.empty()))
    throw Error(ErrorCode::bad_input, "the scene declares nothing to build", {},
                "add, for instance: volume rock = level_set(..., voxel: 5cm)");
  require_outputs(paths, loading::file_dependencies(build.scene()->loaded()));
  build.work([&](building::Builder& builder) {
    if (grids)
      delivery::write_volumes(builder, to);
    else
      delivery::write_products(builder, to);
    if (const auto& checkpoint = builder.options().checkpoint; checkpoint && !grids)
      checkpoint->remove();
  });
  return paths;
}

/// The method with an additional keyword argument `progress`.
template <class Result, class What>
auto with_progress(Result (*call)(Build&, const What&)) {
  return [call](Build& build, const What& what, const Callback& progress) {
    const Build::ProgressOverride listening(build, progress);
    return call(build, what);
  };
}

void bind_products(py::class_<Build>& type) {
  const auto progress = "progress"_a = py::none();
  const py::kw_only by_name;
  type.def("level_set", with_progress(&level_set), "name"_a = "", by_name, progress,
           "The level set of a volume, also of a fog volume; without a name, of the first.")
      .def("volume", with_progress(&volume_of), "name"_a = "", by_name, progress,
           "The grid of a volume in the .vdb: a level set, or the density of a fog volume.")
      .def("mesh", with_progress(&mesh), "name"_a = "", by_name, progress,
           "A mesh, or the weathered mesh of cells, by name; without a name, the first mesh.")
      .def("cells", with_progress(&cells_of), "name"_a = "", by_name, progress,
           "Cells on a mesh after the simulation of their rules.")
      .def("measure", with_progress(&measure_build), "mesh"_a = "", by_name, progress,
           "Area, volume, genus and all other metrics of `vug measure --json`, as a dict.")
      .def("measure_cells", with_progress(&measure_cells), "name"_a = "", by_name, progress,
           "Regularity and links of cells, as in `vug measure --cells`.")
      .def("save", with_progress(&save_build), "to"_a, by_name, progress,
           "Writes the products of `vug build` to a folder, or all grids to a file that ends in "
           ".vdb.\n"
           "Returns the paths.");
}

}  // namespace

void bind_build(py::module_& module) {
  py::class_<Build> type(module, "Build",
                         "The products of a scene, each built once, when first requested.\n\n"
                         "`progress(share, what)` is called on the calling thread; share goes\n"
                         "from 0 to 1 in each stage `what`. If it returns False, the work stops\n"
                         "with vug.Cancelled; exceptions of the callback are raised. Ctrl-C stops\n"
                         "the work, too. Every method takes a `progress` for its own call.\n"
                         "Finished products are kept after a stop, the others can be requested\n"
                         "again.");
  bind_products(type);
  type.def(
          "render",
          [](Build& build, const std::string& name, const Callback& progress,
             const py::kwargs& given) {
            const Build::ProgressOverride listening(build, progress);
            return render(build, render_arguments(*build.scene(), name, given));
          },
          "name"_a = "", "progress"_a = py::none(), render_doc().c_str())
      .def_property_readonly(
          "scene", [](const Build& b) { return std::const_pointer_cast<Scene>(b.scene()); })
      .def_property(
          "progress", [](Build& b) { return b.settings().progress; },
          [](Build& b, const Callback& progress) { b.settings().progress = progress; },
          "The callback, or None.")
      .def("__repr__", [](const Build& b) {
        return fmt::format("<vug.Build of '{}'>", b.scene()->shot().name);
      });
  const py::object scene = module.attr("Scene");
  py::class_<Scene, std::shared_ptr<Scene>> scenes(scene);
  scenes.def(
      "build", &make_build, "max_memory"_a = py::none(), "threads"_a = 0, "progress"_a = py::none(),
      "checkpoint"_a = py::none(),
      "Returns a vug.Build. max_memory: limit in bytes or as text such as '8G', by default nine\n"
      "tenths of the free memory; work that needs more is refused. threads: number of threads, 0\n"
      "for all cores; results do not depend on it. checkpoint: a .vdb with the state of cell\n"
      "simulations; if it exists, they continue from it. Build.save of a folder removes it.");
  scenes.def(
      "measure",
      [](const std::shared_ptr<Scene>& self, const std::string& name, const Memory& memory,
         int threads, const Callback& progress) {
        Build build = make_build(self, memory, threads, progress, {});
        return measure_build(build, name);
      },
      "mesh"_a = "", "max_memory"_a = py::none(), "threads"_a = 0, "progress"_a = py::none(),
      "Measures a mesh, like Build.measure, with a temporary build.");
  scenes.def(
      "render",
      [](const std::shared_ptr<Scene>& self, const std::string& name, const Memory& memory,
         int threads, const Callback& progress, const py::kwargs& given) {
        const RenderArguments arguments = render_arguments(*self, name, given);
        Build build = make_build(self, memory, threads, progress, {});
        return render(build, arguments);
      },
      "name"_a = "", "max_memory"_a = py::none(), "threads"_a = 0, "progress"_a = py::none(),
      render_doc().c_str());
}

}  // namespace vug::python
