// SPDX-License-Identifier: Apache-2.0
#include "network_stations.h"

#include "print.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vug/base/atomic_file.h>
#include <vug/loading/dependencies.h>
#include <vug/network/from_survey.h>
#include <vug/shot/queries.h>
#include <nlohmann/json.hpp>

namespace vug::cli {
namespace {

std::vector<std::string> flag_names(const network::StationFlags& flags) {
  std::vector<std::string> out;
  for (const auto& [name, set] : {std::pair("entrance", flags.entrance),
                                  {"sink", flags.sink},
                                  {"spring", flags.spring},
                                  {"surface", flags.surface}})
    if (set) out.emplace_back(name);
  return out;
}

nlohmann::ordered_json stations_json(const network::Network& network) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const network::Station& station : network.stations)
    out.push_back({{"name", station.name},
                   {"equated", station.equated},
                   {"position", {station.position.x, station.position.y, station.position.z}},
                   {"flags", flag_names(station.flags)}});
  return out;
}

}  // namespace

survey::Survey network_survey(const SceneOptions& scene, const std::string& network,
                              const std::vector<std::filesystem::path>& outputs) {
  const loading::Loaded loaded = scene.load();
  require_outputs(outputs, loading::file_dependencies(loaded));
  const shot::NetworkPlan& plan = shot::find_network(loaded.shot, network);
  survey::Survey survey = network::to_survey(*plan.network);
  survey.title = fmt::format("{} of {}", plan.name, loaded.shot.name);
  return survey;
}

void print_network_stations(const SceneOptions& scene, const std::string& network, bool json) {
  const loading::Loaded loaded = scene.load();
  const network::Network& found = *shot::find_network(loaded.shot, network).network;
  if (json) return print_report(stations_json(found), true);
  fmt::print("{:>10}{:>10}{:>10}  name\n", "x", "y", "z");
  for (const network::Station& station : found.stations) {
    const Vec3d& p = station.position;
    fmt::print("{:10.2f}{:10.2f}{:10.2f}  {}", p.x, p.y, p.z, station.name);
    if (!station.equated.empty()) fmt::print(" = {}", fmt::join(station.equated, " = "));
    for (const std::string& flag : flag_names(station.flags)) fmt::print("  {}", flag);
    fmt::print("\n");
  }
}

}  // namespace vug::cli
