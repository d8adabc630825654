// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/memory.h>
#include <vug/building/cell_points.h>
#include <vug/building/memory_estimate.h>
#include <vug/image/ocio_view.h>
#include <vug/loading/placement/check.h>
#include <vug/loading/validate.h>
#include <vug/picture/picture_plan.h>
#include <vug/shot/lsystem_plan.h>
#include <vug/shot/queries.h>
#include <vug/volume/fitting_voxel.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace vug::cli {
namespace {

struct CheckOptions {
  SceneOptions scene;
  bool quiet = false;
  bool json = false;
  bool provenance = false;
};

using Json = nlohmann::ordered_json;

Json to_json(const loading::Loaded& loaded, const std::string& file) {
  Json faults = Json::array();
  for (const Diagnostic& one : loaded.diagnostics.all())
    faults.push_back({{"severity", one.severity == Severity::error ? "error" : "warning"},
                      {"file", one.where.file},
                      {"line", one.where.line},
                      {"column", one.where.column},
                      {"end_line", one.where.end_line},
                      {"end_column", one.where.end_column},
                      {"message", one.message},
                      {"hint", one.hint}});
  return {{"file", file}, {"fine", loaded.usable()}, {"diagnostics", std::move(faults)}};
}

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

/// Loads the scene and checks what `vug render` with default options would check.
loading::Loaded load_and_check(const CheckOptions& options) {
  loading::Loaded loaded = loading::load(options.scene.scene, options.scene.load_options());
  if (!loaded.usable()) return loaded;
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
        {options.scene.scene, 0, 0}, "the scene declares nothing to build or to render",
        "declare a volume or a mesh, such as volume rock = level_set(sphere(1m), voxel: 5cm)");
  check_memory(loaded);
  check_placement(loaded);
  return loaded;
}

loading::Loaded examine(const CheckOptions& options) {
  loading::Loaded loaded = load_and_check(options);
  options.scene.apply_strictness(loaded.diagnostics);
  return loaded;
}

/// Prints the faults as JSON, even if the scene file cannot be read.
int run_json(const CheckOptions& options) {
  loading::Loaded loaded;
  try {
    loaded = examine(options);
  } catch (const Error& error) {
    loaded.diagnostics.error(error.where(), error.what(), error.hint());
  }
  fmt::print(
      "{}\n",
      to_json(loaded, options.scene.scene).dump(2, ' ', false, Json::error_handler_t::replace));
  return loaded.usable() ? kDone : kUnusable;
}

std::string pluralize(size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Prints each declaration, function and rule with the range of its text.
void print_provenance(const loading::Loaded& loaded) {
  for (const auto& each : loaded.provenance.declared())
    fmt::print("{} {}: {}\n", each.kind, each.name,
               loaded.provenance.describe({each.where, nullptr}));
}

int run_check(const CheckOptions& options) {
  if (options.json) return run_json(options);
  const loading::Loaded loaded = examine(options);
  fmt::print(stderr, "{}", loaded.report());
  if (!loaded.usable()) return kUnusable;
  const shot::Shot& shot = loaded.shot;
  if (!options.quiet)
    fmt::print("{}: fine; {}, {}, {}, {}, {}, {}, {}\n", options.scene.scene,
               pluralize(shot.volumes.size(), "volume", "volumes"),
               pluralize(shot.meshes.size(), "mesh", "meshes"),
               pluralize(shot.objects.size(), "object", "objects"),
               pluralize(shot.instancers.size(), "place", "places"),
               pluralize(shot.lights.size(), "light", "lights"),
               pluralize(shot.cameras.size(), "camera", "cameras"),
               pluralize(shot.renders.size(), "render", "renders"));
  if (options.provenance) print_provenance(loaded);
  return kDone;
}

}  // namespace

Verb check_verb() {
  return {"check", "Reports all faults of a scene without building it.", [](CLI::App& app) {
            auto options = std::make_shared<CheckOptions>();
            options->scene.add_to(app);
            app.add_flag("--quiet,-q", options->quiet, "No output if the scene has no faults");
            app.add_flag("--json", options->json, "Machine-readable output");
            app.add_flag("--provenance", options->provenance,
                         "Also prints the text range of each declaration, function and rule");
            return [options] { return run_check(*options); };
          }};
}

}  // namespace vug::cli
