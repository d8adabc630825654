// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/export_set.h>
#include <vug/loading/dependencies.h>

#include <memory>

namespace vug::cli {
namespace {

struct ExportOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string folder;
  std::string program = "usd";
  std::string up, unit, usd_format;
  int levels = 0;
  bool variants = false;
};

/// A variant of the scene with its builder.
struct BuiltVariant {
  BuiltVariant(const ExportOptions& options, const std::string& name)
      : loaded(load(options, name)),
        shot(with_name(loaded, name)),
        builder(shot, options.work.build_options(loaded),
                terminal_progress(options.work.bar_mode())) {}

  loading::Loaded loaded;
  shot::Shot shot;
  building::Builder builder;

 private:
  static loading::Loaded load(const ExportOptions& options, const std::string& name) {
    SceneOptions scene = options.scene;
    scene.variant = name;
    return scene.load();
  }
  static shot::Shot with_name(const loading::Loaded& loaded, const std::string& name) {
    shot::Shot shot = delivery::with_meshes(loaded.shot);
    shot.name += "_" + name;
    return shot;
  }
};

/// All variants of the scene. Error(bad_input) if it has none or the program cannot have any.
std::vector<std::unique_ptr<BuiltVariant>> build_variants(const ExportOptions& options,
                                                          const loading::Loaded& loaded,
                                                          delivery::ExportOptions& what) {
  std::vector<std::unique_ptr<BuiltVariant>> all;
  if (!options.variants) return all;
  if (!delivery::has_variants(*what.program))
    throw Error(ErrorCode::bad_input,
                fmt::format("--variants: files for {} have no variants", options.program), {},
                "export one at a time with --variant NAME, or all of them with --for usd");
  if (loaded.variants.empty())
    throw Error(ErrorCode::bad_input, "--variants: the scene has no variants", {},
                "declare one, such as variant wet { WATER 2cm }");
  for (const loading::Variant& each : loaded.variants) {
    all.push_back(std::make_unique<BuiltVariant>(options, each.name));
    what.variants.push_back({each.name, &all.back()->builder});
  }
  return all;
}

int run_export(const ExportOptions& options) {
  delivery::ExportOptions what;
  exchange::Program program = exchange::program(options.program);
  if (!options.usd_format.empty())
    program = exchange::with_usd_format(std::move(program), options.usd_format);
  what.program = &program;
  if (!options.up.empty()) what.up = options.up == "z" ? exchange::UpAxis::z : exchange::UpAxis::y;
  if (!options.unit.empty()) what.metres_per_unit = options.unit == "cm" ? 0.01 : 1;
  what.levels = options.levels;
  const loading::Loaded loaded = options.scene.load();
  const shot::Shot shot = delivery::with_meshes(loaded.shot);
  const std::vector<std::unique_ptr<BuiltVariant>> variants = build_variants(options, loaded, what);
  require_outputs(delivery::export_paths(shot, options.folder, what),
                  loading::file_dependencies(loaded));
  building::Builder builder(shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  const delivery::ExportResult written = delivery::export_set(builder, options.folder, what);
  for (const auto& path : written.files) fmt::print("{}\n", path.string());
  clear_progress_bar();
  for (const std::string& each : written.unsupported) fmt::print(stderr, "omitted: {}\n", each);
  if (options.work.quiet) return kDone;
  for (const std::string& each : written.notes) fmt::print(stderr, "note: {}\n", each);
  for (const std::string& each : written.levels) fmt::print(stderr, "{}\n", each);
  options.work.summarise(builder);
  return kDone;
}

}  // namespace

Verb export_verb() {
  return {"export", "Exports meshes, volumes, cameras and lights for another program.",
          [](CLI::App& app) {
            auto options = std::make_shared<ExportOptions>();
            options->scene.add_to(app, &options->work);
            app.add_option("-o,--output", options->folder, "Output folder")->required();
            std::vector<std::string> programs;
            for (const exchange::Program* each : exchange::programs())
              programs.push_back(each->info.name);
            app.add_option(
                "--for", options->program,
                fmt::format("Target program: {}; default usd", fmt::join(programs, ", ")));
            app.add_option("--usd-format", options->usd_format,
                           "Format of USD files: usda (text, the default) or usdc (binary)")
                ->check(one_of({"usda", "usdc"}));
            app.add_option("--up", options->up, "Up axis, y or z; default: that of the program")
                ->check(one_of({"y", "z"}));
            app.add_option("--unit", options->unit,
                           "Unit of length, m or cm; default: that of the program")
                ->check(one_of({"m", "cm"}));
            app.add_option(
                   "--lod", options->levels,
                   "Number of additional levels of detail, each with a quarter of the triangles")
                ->check(integer_in(0, 8));
            app.add_flag("--variants", options->variants,
                         "All variants of the scene as variants of the root prim (USD)")
                ->excludes("--variant");
            options->work.add_to(app);
            return [options] {
              return with_threads(options->work.threads, [&] { return run_export(*options); });
            };
          }};
}

}  // namespace vug::cli
