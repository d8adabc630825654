// SPDX-License-Identifier: Apache-2.0
#include "arguments.h"
#include "network_stations.h"
#include "print.h"
#include "shoot_options.h"

#include <fmt/format.h>
#include <malloc.h>
#include <vug/base/atomic_file.h>
#include <vug/network/dat.h>
#include <vug/scene/report.h>
#include <vug/survey/drawing.h>
#include <vug/survey/report.h>
#include <vug/survey_files/read_survey.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

struct SurveyOptions {
  std::string file;
  bool json = false;
  bool stations = false;
  bool allow_outside = false;
  std::string plan, elevation, output;
  std::string network;
  ShootOptions shoot;
};

bool is_scene_file(const std::string& file) { return extension_of(file) == ".vug"; }

/// The scene whose network is surveyed without walls.
SceneOptions scene_of(const SurveyOptions& options) {
  SceneOptions scene = options.shoot.scene;
  scene.scene = options.file;
  return scene;
}

/// Refuses options of scenes for other files.
void require_scene_options(const SurveyOptions& options) {
  const SceneOptions& scene = options.shoot.scene;
  if (options.shoot.given() || is_scene_file(options.file)) return;
  const char* option = !options.network.empty() ? "--network"
                       : !scene.defines.empty() ? "-D"
                       : scene.seed             ? "--seed"
                                                : nullptr;
  if (option)
    throw Error(ErrorCode::bad_input, fmt::format("{} requires a scene, a .vug file", option), {},
                "omit it, or give a scene instead of the survey");
}

/// Keeps freed memory for the next large block. Reading a survey makes and frees tens of arrays,
/// and by default the C library returns each to the system, which clears its pages again.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 512 << 20);
#endif
}

/// Reads or shoots the survey, or takes it from the network of a scene, and refuses outputs that
/// would overwrite its files.
survey::Survey read_or_shoot(const SurveyOptions& options,
                             const std::vector<std::filesystem::path>& outputs) {
  if (options.shoot.given()) return options.shoot.survey(outputs);
  if (is_scene_file(options.file))
    return network_survey(scene_of(options), options.network, outputs);
  if (network::is_dat_name(options.file))
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is a network of karst research, not a survey", options.file), {},
                "vug measure FILE --score compares it with real caves; scenes read it with "
                "nodes_links(file: \"FILE\")");
  keep_freed_memory();
  Diagnostics warnings;
  survey::ReadOptions reading;
  reading.allow_outside = options.allow_outside;
  survey::Survey read = survey::read_survey(options.file, reading, warnings);
  fmt::print(stderr, "{}", scene::report(warnings, {}));
  require_outputs(outputs, read.files);
  return read;
}

void print_stations(const nlohmann::ordered_json& stations, bool json) {
  if (json) return print_report(stations, true);
  fmt::print("{:>12}{:>12}{:>10}  name\n", "east", "north", "up");
  for (const auto& each : stations) {
    fmt::print("{:12.2f}{:12.2f}{:10.2f}  {}", each["east"].get<double>(),
               each["north"].get<double>(), each["up"].get<double>(),
               each["name"].get<std::string>());
    for (const auto& flag : each["flags"]) fmt::print("  {}", flag.get<std::string>());
    fmt::print("\n");
  }
}

int run_survey(const SurveyOptions& options) {
  if (options.file.empty() && !options.shoot.given())
    throw Error(ErrorCode::bad_input, "the survey is missing", {},
                "write vug survey FILE, or vug survey --shoot SCENE --along NETWORK");
  require_scene_options(options);
  if (options.stations && is_scene_file(options.file)) {
    print_network_stations(scene_of(options), options.network, options.json);
    return kDone;
  }
  std::vector<std::filesystem::path> outputs;
  for (const std::string* each : {&options.plan, &options.elevation, &options.output})
    if (!each->empty()) outputs.emplace_back(*each);
  for (const std::string* each : {&options.plan, &options.elevation})
    if (!each->empty()) require_extension(*each, ".svg", "drawings are SVG files");
  if (!options.output.empty()) survey::writable_format_of(options.output);

  const survey::Survey read = read_or_shoot(options, outputs);
  // All texts exist before the first file is written, so that a conversion that fails leaves none.
  std::vector<std::pair<std::string, std::string>> files;
  if (!options.plan.empty()) files.emplace_back(options.plan, survey::plan_svg(read));
  if (!options.elevation.empty())
    files.emplace_back(options.elevation, survey::elevation_svg(read));
  if (!options.output.empty())
    files.emplace_back(options.output, survey::writable_format_of(options.output).write(read));
  for (const auto& [file, text] : files) write_text(file, text);
  if (options.stations)
    print_stations(survey::station_list(read), options.json);
  else
    print_report(survey::report(read), options.json);
  return kDone;
}

}  // namespace

Verb survey_verb() {
  return {
      "survey",
      "Reads a cave survey and closes its loops, or takes the network of a scene or surveys its "
      "passages, and reports, draws or converts it.",
      [](CLI::App& app) {
        auto options = std::make_shared<SurveyOptions>();
        CLI::Option* file = app.add_option(
            "file", options->file,
            "Survey in a format of Survex, Therion, Compass, Walls or PocketTopo, or "
            "a scene, a .vug file, whose network is taken as it is");
        options->shoot.add_to(app, file);
        app.add_flag("--json", options->json, "Machine-readable output");
        app.add_flag(
            "--stations", options->stations,
            "List the stations with their coordinates instead of the report; of a scene, those of "
            "a network in the space of the scene");
        app.add_option("--network", options->network,
                       "Network of a scene that is reported, drawn or listed; default the first");
        app.add_option("--plan", options->plan, "SVG file for a drawing of the plan");
        app.add_option("--elevation", options->elevation,
                       "SVG file for a drawing of the extended elevation");
        app.add_option("-o,--output", options->output,
                       "File for the survey in another format, e.g. cave.3d, cave.lox or cave.svx");
        app.add_flag("--allow-outside", options->allow_outside,
                     "Allow included files outside of the survey's folder");
        return [options] { return run_survey(*options); };
      }};
}

}  // namespace vug::cli
