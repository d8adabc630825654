// SPDX-License-Identifier: Apache-2.0
// Export for other programs.
#include "build.h"
#include "errors.h"

#include <vug/base/atomic_file.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/export_set.h>
#include <vug/loading/dependencies.h>

namespace vug::python {
namespace {

delivery::ExportOptions export_options(const std::string& program,
                                       const std::optional<std::string>& up,
                                       const std::optional<std::string>& unit, int lod) {
  delivery::ExportOptions options;
  options.program = &exchange::program(program);
  if (up && *up != "y" && *up != "z") throw py::value_error("up must be 'y' or 'z'");
  if (unit && *unit != "m" && *unit != "cm") throw py::value_error("unit must be 'm' or 'cm'");
  if (lod < 0 || lod > 8) throw py::value_error("lod must be from 0 to 8");
  options.levels = lod;
  if (up) options.up = *up == "z" ? exchange::UpAxis::z : exchange::UpAxis::y;
  if (unit) options.metres_per_unit = *unit == "cm" ? 0.01 : 1;
  return options;
}

std::vector<std::filesystem::path> export_scene(const std::shared_ptr<Scene>& scene,
                                                const std::filesystem::path& folder,
                                                const std::string& program,
                                                const std::optional<std::string>& up,
                                                const std::optional<std::string>& unit, int lod,
                                                const Memory& memory, int threads,
                                                const Callback& progress) {
  const delivery::ExportOptions options = export_options(program, up, unit, lod);
  const auto shot = std::make_shared<const shot::Shot>(delivery::with_meshes(scene->shot()));
  require_outputs(delivery::export_paths(*shot, folder, options),
                  loading::file_dependencies(scene->loaded()));
  Build build(scene, shot, {memory_limit_of(memory), checked_threads(threads), progress});
  delivery::ExportResult written;
  build.work([&](building::Builder& builder) {
    written = delivery::export_set(builder, folder, options);
  });
  for (std::string& each : written.unsupported) each = "omitted: " + each;
  warn(written.unsupported);
  return written.files;
}

}  // namespace

void bind_export(py::module_& module) {
  py::class_<Scene, std::shared_ptr<Scene>> scenes(module.attr("Scene"));
  scenes.def(
      "export", &export_scene, "folder"_a, "program"_a = "usd", "up"_a = py::none(),
      "unit"_a = py::none(), "lod"_a = 0, py::kw_only(), "max_memory"_a = py::none(),
      "threads"_a = 0, "progress"_a = py::none(),
      "Exports the scene for another program, as `vug export --for PROGRAM` does, and returns the\n"
      "paths; vug.catalogue.find('program') lists the programs. up: 'y' or 'z', unit: 'm' or "
      "'cm',\n"
      "by default those of the program. lod: number of additional levels of detail, each with a\n"
      "quarter of the triangles. Warns of omitted contents.");
}

}  // namespace vug::python
