// SPDX-License-Identifier: Apache-2.0
#include "shoot_options.h"

#include "arguments.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/loading/dependencies.h>
#include <vug/passages/wall_scraps.h>
#include <vug/shot/queries.h>

#include <algorithm>
#include <map>

namespace vug::cli {
namespace {

/// The volume of that name, else the first level set.
shot::VolumePtr surveyed_volume(const shot::Shot& shot, const std::string& name) {
  if (name.empty())
    for (const shot::VolumePtr& volume : shot.volumes)
      if (!volume->fog && !volume->source_mesh) return volume;
  const shot::VolumePtr volume = shot::find_volume(shot, name);
  if (!volume->fog && !volume->source_mesh) return volume;
  throw Error(ErrorCode::bad_input,
              fmt::format("the volume '{}' is {}, which cannot be surveyed", volume->name,
                          volume->fog ? "a fog" : "made of a mesh"),
              volume->where, "--volume names a level set of a field");
}

/// Stations with cross-sections, and those of them without a single distance to a wall.
struct MeasuredStations {
  int all = 0;
  int without_walls = 0;
};

MeasuredStations count_measured(const survey::Survey& survey) {
  std::map<int, bool> has_wall;
  for (const survey::Tube& tube : survey.tubes)
    for (const survey::CrossSection& each : tube)
      has_wall[each.station] |= each.left || each.right || each.up || each.down;
  for (const survey::Leg& leg : survey.legs)
    if (leg.splay) has_wall[leg.from] = true;
  MeasuredStations out;
  out.all = static_cast<int>(has_wall.size());
  for (const auto& [station, found] : has_wall) out.without_walls += !found;
  return out;
}

/// Reports stations from which no wall was found: the volume is probably not around the network.
void require_walls(const survey::Survey& survey, const std::string& network,
                   const std::string& volume, double reach) {
  const MeasuredStations found = count_measured(survey);
  if (found.without_walls == 0) return;
  const std::string problem =
      fmt::format("no wall of '{}' is within {:.0f} m of {} of the {} stations of '{}'", volume,
                  reach, found.without_walls, found.all, network);
  if (found.without_walls == found.all)
    throw Error(ErrorCode::bad_input, problem, {},
                "name the volume whose passages follow the network with --volume, or the network "
                "with --along");
  fmt::print(stderr, "warning: {}\n", problem);
}

/// Whether a format that stores walls is among the outputs.
bool stores_walls(const std::vector<std::filesystem::path>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(),
                     [](const auto& file) { return extension_of(file.string()) == ".lox"; });
}

}  // namespace

void ShootOptions::add_to(CLI::App& app, CLI::Option* file) {
  CLI::Option* shoot = app.add_option("--shoot", scene.scene,
                                      "Scene, a .vug file, whose passages are surveyed instead of "
                                      "reading a survey: legs, distances to the walls and splays");
  shoot->excludes(file);
  const auto option = [&](CLI::Option* each) { return each->needs(shoot); };
  option(app.add_option("--along", network,
                        "Network of the scene on whose legs the stations lie; default the first"));
  option(app.add_option("--volume", volume, "Level set with the walls; default the first"));
  option(app.add_option("--longest-leg", simulation.longest_leg,
                        "Longer legs of the network are divided, e.g. 3m; default 5m"))
      ->transform(number_in(Dimension::length, 0.01, 1e6));
  option(app.add_option("--splays", simulation.splays, "Splays at each station; default 24"))
      ->check(integer_in(0, 1000));
  app.add_option("-D", scene.defines, "NAME=VALUE: value of a parameter of the scene")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  app.add_option("--seed", scene.seed,
                 "Seed that replaces the scene's own, with --shoot also for the splays")
      ->check(seed_number());
}

survey::Survey ShootOptions::survey(const std::vector<std::filesystem::path>& outputs) const {
  if (extension_of(scene.scene) != ".vug")
    throw Error(ErrorCode::bad_input,
                fmt::format("--shoot requires a scene, but '{}' is not a .vug file", scene.scene),
                {}, "vug survey --shoot cave.vug --along NETWORK -o cave.3d");
  const loading::Loaded loaded = scene.load();
  require_outputs(outputs, loading::file_dependencies(loaded));
  const shot::NetworkPlan& plan = shot::find_network(loaded.shot, network);
  const shot::VolumePtr walls = surveyed_volume(loaded.shot, volume);
  passages::SimulationOptions options = simulation;
  options.seed = loaded.shot.seed;
  passages::SimulatedSurvey simulated =
      passages::simulate_survey(walls->field, *plan.network, options);
  if (simulated.in_rock > 0)
    fmt::print(stderr,
               "warning: {} of the stations lie in the rock of '{}'; they have no distances to the "
               "walls and no splays\n",
               simulated.in_rock, walls->name);
  require_walls(simulated.survey, plan.name, walls->name, options.reach);
  simulated.survey.title = fmt::format("{} of {}", plan.name, loaded.shot.name);
  if (stores_walls(outputs)) {
    const WorkOptions work;
    building::Builder builder(loaded.shot, work.build_options(loaded),
                              terminal_progress(work.bar_mode()));
    const mesh::MeshPtr surface = builder.mesh(shot::plain_mesh(walls));
    simulated.survey.scraps =
        passages::wall_scraps(*surface, simulated.survey, plan.network->origin);
  }
  return std::move(simulated.survey);
}

}  // namespace vug::cli
