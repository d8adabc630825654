#include "print.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/delivery/describe_cells.h>
#include <vug/delivery/measure.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct Options {
  SceneOptions scene;
  WorkOptions work;
  std::string mesh;
  std::string cells;
  bool json = false;
};

/// A file is what it is: nothing of it can be chosen or set.
void refuse_scene_options(const Options& options) {
  const char* option = !options.scene.defines.empty() ? "-D"
                       : options.scene.seed           ? "--seed"
                       : options.scene.frame          ? "--frame"
                       : !options.mesh.empty()        ? "--mesh"
                       : !options.cells.empty()       ? "--cells"
                                                      : nullptr;
  if (option)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} is for scenes, and '{}' is none", option, options.scene.scene), {},
                "give a .vug file or leave out " + std::string(option));
}

metrics::Report report_of(const Options& options) {
  const ThreadLimit threads(options.work.threads);
  Progress& progress = terminal_progress(options.work.bar_mode());
  if (extension_of(options.scene.scene) != ".vug") {
    refuse_scene_options(options);
    return delivery::measure_file(options.scene.scene, progress);
  }
  const loading::Loaded loaded = options.scene.load();
  building::Builder builder(loaded.shot, options.work.build_options(loaded), progress);
  return delivery::measure(builder, options.mesh);
}

int run_cells(const Options& options) {
  if (extension_of(options.scene.scene) != ".vug") refuse_scene_options(options);
  const loading::Loaded loaded = options.scene.load();
  const ThreadLimit threads(options.work.threads);
  building::Builder builder(loaded.shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  print_report(delivery::describe_cells(builder, options.cells), options.json);
  return kDone;
}

int run(const Options& options) {
  if (!options.cells.empty()) return run_cells(options);
  const metrics::Report report = report_of(options);
  if (options.json)
    fmt::print("{}", metrics::to_json(report));
  else
    fmt::print("{}", metrics::to_table(report));
  return report.is_closed_solid() ? kDone : kAnswerNo;
}

}  // namespace

Verb measure_verb() {
  return {"measure",
          "Measures a scene's mesh, or a .vdb, .obj, .ply, .stl file; exit 1 when it is broken.",
          [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            options->scene.add_to(app, &options->work);
            app.add_option("--mesh", options->mesh, "which mesh of the scene; else the first");
            app.add_option("--cells", options->cells,
                           "the cells of that name instead: how even they are, how they are linked")
                ->excludes("--mesh");
            app.add_flag("--json", options->json, "for programs");
            options->work.add_to(app);
            return [options] { return run(*options); };
          }};
}

}  // namespace vug::cli
