// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "print.h"
#include "progress_bar.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/delivery/clearance.h>
#include <vug/delivery/describe_cells.h>
#include <vug/delivery/measure.h>
#include <vug/loading/dependencies.h>
#include <vug/network/read_network.h>
#include <vug/network/score_plot.h>
#include <vug/scene/report.h>
#include <vug/shot/queries.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct MeasureOptions {
  SceneOptions scene;
  WorkOptions work;
  std::string mesh;
  std::string cells;
  bool json = false;
  double max_invalid = 0;
  bool score = false;
  std::string network;
  std::string plot;
  bool clearance = false;
  delivery::ClearanceRequest way;
};

bool is_scene(const MeasureOptions& options) { return extension_of(options.scene.scene) == ".vug"; }

/// Error(bad_input) for scene options, which do not apply to a file of geometry or to a survey.
void refuse_scene_options(const MeasureOptions& options) {
  const char* option = !options.scene.defines.empty()   ? "-D"
                       : options.scene.seed             ? "--seed"
                       : options.scene.frame            ? "--frame"
                       : !options.mesh.empty()          ? "--mesh"
                       : !options.cells.empty()         ? "--cells"
                       : !options.network.empty()       ? "--network"
                       : !options.scene.variant.empty() ? "--variant"
                       : options.scene.strict           ? "--strict"
                                                        : nullptr;
  if (option)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} requires a scene, but '{}' is not a .vug file", option,
                            options.scene.scene),
                {}, "pass a .vug file or remove " + std::string(option));
}

metrics::Report report_of(const MeasureOptions& options) {
  Progress& progress = terminal_progress(options.work.bar_mode());
  if (!is_scene(options)) {
    refuse_scene_options(options);
    if (network::is_network_file(options.scene.scene))
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' is a network, not a mesh", options.scene.scene), {},
                  "add --score to compare it with real caves");
    return delivery::measure_file(options.scene.scene, progress);
  }
  const loading::Loaded loaded = options.scene.load();
  building::Builder builder(loaded.shot, options.work.build_options(loaded), progress);
  return delivery::measure(builder, options.mesh);
}

int run_cells(const MeasureOptions& options) {
  if (!is_scene(options)) refuse_scene_options(options);
  const loading::Loaded loaded = options.scene.load();
  building::Builder builder(loaded.shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  print_report(delivery::describe_cells(builder, options.cells), options.json);
  return kDone;
}

/// Compares the network with real caves, and refuses a plot that would overwrite its files.
network::ScoredNetwork scored(const MeasureOptions& options) {
  std::vector<std::filesystem::path> outputs;
  if (!options.plot.empty()) outputs.emplace_back(options.plot);
  const std::filesystem::path file = options.scene.scene;
  if (!is_scene(options)) {
    refuse_scene_options(options);
    Diagnostics warnings;
    const network::Network read = network::read_network(file, warnings);
    fmt::print(stderr, "{}", scene::report(warnings, {}));
    require_outputs(outputs, read.files);
    return network::scored(read, file.filename().string());
  }
  const loading::Loaded loaded = options.scene.load();
  require_outputs(outputs, loading::file_dependencies(loaded));
  const shot::NetworkPlan& plan = shot::find_network(loaded.shot, options.network);
  return network::scored(*plan.network, plan.name);
}

int run_score(const MeasureOptions& options) {
  if (!options.plot.empty()) require_extension(options.plot, ".svg", "plots are SVG files");
  const network::ScoredNetwork cave = scored(options);
  if (!options.plot.empty()) write_text(options.plot, network::score_svg(cave));
  if (options.json)
    fmt::print("{}\n", network::score_json(cave).dump(2));
  else
    fmt::print("{}", network::score_table(cave));
  return kDone;
}

int run_clearance(const MeasureOptions& options) {
  if (!is_scene(options))
    throw Error(ErrorCode::bad_input, "--clearance requires a scene with a mesh and a network");
  const loading::Loaded loaded = options.scene.load();
  building::Builder builder(loaded.shot, options.work.build_options(loaded),
                            terminal_progress(options.work.bar_mode()));
  delivery::ClearanceRequest request = options.way;
  request.mesh = options.mesh;
  request.network = options.network;
  const delivery::ClearanceReport report = delivery::measure_clearance(builder, request);
  if (options.json)
    fmt::print("{}\n", delivery::to_json(report).dump(2));
  else
    fmt::print("{}", delivery::to_table(report));
  return report.passes ? kDone : kAnswerNo;
}

void add_clearance_to(CLI::App& app, MeasureOptions& options) {
  CLI::Option* clearance = app.add_flag(
      "--clearance", options.clearance,
      "Instead: whether a person, an upright capsule, passes through the mesh from one station of "
      "a network to another; exit code 1 if not");
  clearance->excludes("--cells")->excludes("--max-invalid")->excludes("--score");
  delivery::ClearanceRequest& way = options.way;
  app.add_option("--from", way.from,
                 "Station at which the way begins; default the first entrance or station")
      ->needs(clearance);
  app.add_option("--to", way.to, "Station at which it ends; default the farthest along the legs")
      ->needs(clearance);
  app.add_option("--body-width", way.body.diameter,
                 "Diameter of the capsule, e.g. 60cm; default 40cm")
      ->needs(clearance)
      ->transform(number_in(Dimension::length, 0.05, 100));
  app.add_option("--body-height", way.body.height,
                 "Height of the capsule, at least its diameter; default 1.8m")
      ->needs(clearance)
      ->transform(number_in(Dimension::length, 0.05, 100));
}

int run_measure(const MeasureOptions& options) {
  if (options.score) return run_score(options);
  if (options.clearance) return run_clearance(options);
  if (!options.cells.empty()) return run_cells(options);
  const metrics::Report report = report_of(options);
  if (options.json)
    fmt::print("{}", metrics::to_json(report));
  else
    fmt::print("{}", metrics::to_table(report));
  return report.is_closed_solid() && report.invalid_share() <= options.max_invalid ? kDone
                                                                                   : kAnswerNo;
}

}  // namespace

Verb measure_verb() {
  return {
      "measure",
      "Measures a mesh of a scene, or a .vdb, .obj, .ply or .stl file; exit code 1 if it is not a "
      "closed solid, intersects itself or is folded. With --score, compares the plan of a cave "
      "with real caves; with --clearance, reports whether a person passes through it.",
      [](CLI::App& app) {
        auto options = std::make_shared<MeasureOptions>();
        options->scene.add_to(app, &options->work);
        app.add_option("--mesh", options->mesh, "Mesh of the scene; default the first");
        app.add_option("--cells", options->cells,
                       "Measure the cells of this name instead: their regularity and links")
            ->excludes("--mesh");
        app.add_option("--max-invalid", options->max_invalid,
                       "Share of triangles, e.g. 0.001, that may intersect others, be folded or "
                       "have no area before the exit code is 1; default 0")
            ->transform(number_in(Dimension::none, 0, 1));
        CLI::Option* score = app.add_flag(
            "--score", options->score,
            "Compare a network with real caves instead: a network of the scene, a survey, or "
            "NAME_nodes.dat");
        score->excludes("--mesh")->excludes("--cells")->excludes("--max-invalid");
        app.add_option("--network", options->network,
                       "Network of the scene for --score and --clearance; default the first");
        app.add_option("--plot", options->plot, "SVG file for a drawing of the score")
            ->needs(score);
        add_clearance_to(app, *options);
        app.add_flag("--json", options->json, "Machine-readable output");
        options->work.add_to(app);
        return [options] {
          return with_threads(options->work.threads, [&] { return run_measure(*options); });
        };
      }};
}

}  // namespace vug::cli
