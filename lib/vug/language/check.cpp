// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/cell_points.h>
#include <vug/building/memory_estimate.h>
#include <vug/drips/lost_drips.h>
#include <vug/image/ocio_view.h>
#include <vug/language/check.h>
#include <vug/loading/placement/check.h>
#include <vug/loading/validate.h>
#include <vug/picture/picture_plan.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/lsystem_plan.h>
#include <vug/shot/queries.h>
#include <vug/volume/fitting_voxel.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::language {
namespace {

/// Memory limit in bytes for the word of an L-system while a text is being edited.
constexpr uint64_t kEditingMemory = uint64_t{512} << 20;

/// Memory that the level set takes at least if the surface of the field is as large as that of its
/// box: a cheap bound, because the estimate takes longer than all other checks.
double rough_bytes(const shot::VolumePlan& plan) {
  const Vec3d size = (plan.from ? Box3d(*plan.from, *plan.to) : plan.field.bounds()).size();
  const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return sizeof(float) * area * 2 * plan.half_width / (plan.voxel * plan.voxel);
}

/// Warns about volumes that `vug build` would refuse because they need too much memory.
void check_memory(loading::Loaded& loaded) {
  const uint64_t limit = available_memory() / 10 * 9;
  for (const shot::VolumePtr& plan : loaded.shot.volumes) {
    if (plan->source_mesh || plan->field.bounds().isEmpty() ||
        rough_bytes(*plan) <= static_cast<double>(limit))
      continue;
    const double bytes =
        volume::estimate(plan->field, building::voxelize_options(*plan, limit)).bytes;
    if (bytes > static_cast<double>(limit))
      loaded.diagnostics.warning(
          plan->where,
          fmt::format("the volume '{}' needs about {} of memory; {} are available", plan->name,
                      bytes_text(bytes), bytes_text(static_cast<double>(limit))),
          fmt::format("use voxels of at least {:.2g} m or a smaller region",
                      volume::fitting_voxel(plan->voxel, bytes, static_cast<double>(limit))));
  }
}

/// Adds the mistakes of placement in the parts of the scene that its pictures show, each once.
void check_placement(loading::Loaded& loaded) {
  const shot::Shot& shot = loaded.shot;
  std::vector<const shot::Shot*> parts;
  std::vector<picture::PicturePlan> plans;  // own the parts
  for (const shot::RenderPlan& each : shot.renders) {
    picture::PictureOptions options;
    options.render = each.name;
    plans.push_back(picture::plan_picture(shot, options));
    const shot::RenderSettings& settings = each.settings;
    parts.push_back(settings.lights || settings.objects ? plans.back().shown.get() : &shot);
  }
  const bool whole = parts.empty() || std::count(parts.begin(), parts.end(), &shot) > 0;
  if (whole) return loading::check_placement(loaded, {}, loaded.diagnostics);
  Diagnostics found;
  for (size_t i = 0; i < parts.size(); ++i)
    loading::check_placement(
        loaded, {picture::camera_name(shot, plans[i].render), loading::Accuracy::bounds, parts[i]},
        found);
  const auto is_known = [&](const Diagnostic& one) {
    return std::any_of(loaded.diagnostics.all().begin(), loaded.diagnostics.all().end(),
                       [&](const Diagnostic& other) {
                         return other.where == one.where && other.message == one.message;
                       });
  };
  for (const Diagnostic& one : found.all())
    if (!is_known(one)) loaded.diagnostics.add(one);
}

bool is_without_products(const shot::Shot& shot) {
  return shot.volumes.empty() && shot.meshes.empty() && shot.objects.empty() &&
         shot.instancers.empty() && shot.renders.empty() && shot::declared_cells(shot).empty();
}

/// Adds the faults that appear when points of cells and drawings of L-systems are computed.
void check_points_and_drawings(loading::Loaded& loaded) {
  for (const shot::CellsPtr& cells : shot::declared_cells(loaded.shot)) try {
      building::initial_points(*cells);
    } catch (const Error& error) {
      loaded.diagnostics.error(error.where(), error.what(), error.hint());
    }
  for (const shot::LSystemPtr& plan : loaded.shot.lsystems) try {
      plan->drawing();  // for systems that nothing in the scene draws
    } catch (const Error& error) {
      loaded.diagnostics.add(error, plan->system->where);
    }
}

/// Warns about drips that are added or moved by hand and do not drip, and reports edits of drips
/// that do not exist. Only the water of the edits is followed.
void check_drips(loading::Loaded& loaded, const std::string& file) {
  for (const shot::NamedDrips& each : loaded.shot.drips) {
    const shot::DripsPlan& plan = *each.drips;
    const drips::GraphOptions& options = plan.options().graph;
    const drips::DripEdits& edits = options.edits;
    if (edits.added.empty() && edits.moved.empty() && edits.removed.empty()) continue;
    try {
      const drips::Graph ways = drips::ways_of_edits(plan.rock(), options);
      for (const drips::LostDrip& lost : drips::lost_drips(ways, options))
        loaded.diagnostics.warning(lost.where, lost.message, lost.hint);
    } catch (const Error& error) {
      loaded.diagnostics.add(error, {file, 0, 0});
    }
  }
}

}  // namespace

void check_products(loading::Loaded& loaded, const std::string& file, const CheckOptions& options) {
  if (options.thorough) check_points_and_drawings(loaded), check_drips(loaded, file);
  for (const shot::RenderPlan& plan : loaded.shot.renders) try {
      if (loading::is_empty_scene(loaded.shot))
        loaded.diagnostics.warning(plan.where, "the scene has nothing to show");
      const shot::OutputSettings& output = plan.settings;
      image::view_options({output.view, output.display, image::environment_config()},
                          output.working_space);
    } catch (const Error& error) {  // valid with another --ocio perhaps
      loaded.diagnostics.warning(plan.where, error.what(), error.hint());
    }
  if (is_without_products(loaded.shot))
    loaded.diagnostics.warning(
        {file, 0, 0}, "the scene declares nothing to build or to render",
        "declare a volume or a mesh, such as volume rock = level_set(sphere(1m), voxel: 5cm)");
  if (options.thorough) check_memory(loaded);
  check_placement(loaded);
}

CheckResult check_scene(const Workspace& workspace, const std::filesystem::path& file,
                        const CheckOptions& options) {
  loading::LoadOptions load;
  load.include_folders = workspace.options().include_folders;
  load.max_memory = kEditingMemory;
  load.read = [&](const std::filesystem::path& path) { return workspace.read(path); };
  loading::Loaded loaded;
  try {
    const std::optional<std::string> text = workspace.read(file);
    if (!text) throw Error(ErrorCode::bad_input, fmt::format("cannot read '{}'", file.string()));
    loaded = loading::load_text(*text, file.generic_string(), load);
    if (loaded.usable()) check_products(loaded, file.generic_string(), options);
  } catch (const Error& error) {
    loaded.diagnostics.add(error, {file.generic_string(), 1, 1});
  }
  return {std::move(loaded.diagnostics), std::move(loaded.sources)};
}

}  // namespace vug::language
