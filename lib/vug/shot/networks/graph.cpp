// SPDX-License-Identifier: Apache-2.0
// A network that is written in the scene text.
#include <vug/shot/networks.h>
#include <vug/survey_files/plausible.h>

#include <fmt/format.h>

#include <map>
#include <sstream>

namespace vug::shot {
namespace {

struct Graph {
  std::vector<std::string> names;
  std::vector<Vec3d> at;
  std::vector<std::string> paths;
  std::vector<double> widths;
  std::vector<double> heights;

  static void describe(Schema<Graph>& s) {
    s.doc(
         "A network with stations and legs from the text. Each path lists the names of stations, "
         "separated by spaces, in the direction of the water; a leg joins each to the next.")
        .param("names", &Graph::names,
               {.doc = "the stations' names, without spaces", .required = true})
        .param("at", &Graph::at,
               {.doc = "their positions", .dimension = Dimension::length, .required = true})
        .param("paths", &Graph::paths, {.doc = "chains of stations", .required = true})
        .param("widths", &Graph::widths,
               {.doc = "width of the passage at each station, if given",
                .dimension = Dimension::length,
                .min = 0,
                .max = kLargestPassage})
        .param("heights", &Graph::heights,
               {.doc = "height of the passage at each station, if given",
                .dimension = Dimension::length,
                .min = 0,
                .max = kLargestPassage});
  }

  std::string fault() const {
    const auto differs = [&](const char* list, size_t size) {
      return fmt::format("'names' has {} elements, but '{}' has {}; they need one each",
                         names.size(), list, size);
    };
    if (at.size() != names.size()) return differs("at", at.size());
    if (!widths.empty() && widths.size() != names.size()) return differs("widths", widths.size());
    if (!heights.empty() && heights.size() != names.size())
      return differs("heights", heights.size());
    return {};
  }
};

using Indices = std::map<std::string, int>;

network::Station station_of(const Graph& graph, size_t i) {
  const Vec3d& at = graph.at[i];
  for (int axis = 0; axis < 3; ++axis)
    if (!survey::is_plausible_coordinate(at[axis]))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the station '{}' is at ({:g}, {:g}, {:g})", graph.names[i], at[0],
                              at[1], at[2]),
                  {}, fmt::format("coordinates are at most {:g} m", survey::kLargestCoordinate));
  network::Station station;
  station.name = graph.names[i];
  station.position = graph.at[i];
  if (graph.widths.empty() && graph.heights.empty()) return station;
  network::CrossSection section;
  if (!graph.widths.empty()) section.left = section.right = 0.5 * graph.widths[i];
  if (!graph.heights.empty()) section.up = section.down = 0.5 * graph.heights[i];
  station.section = section;
  return station;
}

Indices indices_of(const std::vector<std::string>& names) {
  Indices indices;
  for (const std::string& name : names) {
    if (!network::is_station_name(name))
      throw Error(ErrorCode::bad_input,
                  fmt::format("invalid station name '{}': a name has at least one character and no "
                              "spaces",
                              name),
                  {}, "separate the levels of a name with full stops, e.g. \"stream.3\"");
    if (!indices.emplace(name, static_cast<int>(indices.size())).second)
      throw Error(ErrorCode::bad_input, fmt::format("two stations are named '{}'", name), {},
                  "give each station another name");
  }
  return indices;
}

[[noreturn]] void refuse_unknown(const std::string& path, const std::string& name,
                                 const Indices& indices) {
  std::vector<std::string> known;
  for (const auto& [station, index] : indices) known.push_back(station);
  throw Error(ErrorCode::bad_input,
              fmt::format("the path '{}' contains the unknown station '{}'", path, name), {},
              suggestion(name, known));
}

void add_leg(const std::string& path, int from, int to, network::Network& network) {
  network.legs.push_back({.from = from, .to = to});
  if (network::leg_vector(network, network.legs.back()) != Vec3d(0)) return;
  const auto name = [&](int station) {
    return network.stations[static_cast<size_t>(station)].name;
  };
  throw Error(ErrorCode::bad_input,
              fmt::format("the path '{}' joins the stations '{}' and '{}', which are at the same "
                          "place",
                          path, name(from), name(to)),
              {}, "move one of them, or remove it");
}

/// Appends the legs of one path.
void add_path(const std::string& path, const Indices& indices, network::Network& network) {
  std::istringstream words(path);
  int previous = -1, count = 0;
  for (std::string name; words >> name; ++count) {
    const auto found = indices.find(name);
    if (found == indices.end()) refuse_unknown(path, name, indices);
    if (previous == found->second)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the path '{}' joins the station '{}' to itself", path, name), {},
                  "remove one of the two names");
    if (previous >= 0) add_leg(path, previous, found->second, network);
    previous = found->second;
  }
  if (count < 2)
    throw Error(ErrorCode::bad_input,
                fmt::format("the path '{}' needs at least two stations", path), {},
                "separate the names by spaces");
}

NetworkPtr make(const Graph& graph) {
  auto network = std::make_shared<network::Network>();
  const Indices indices = indices_of(graph.names);
  for (size_t i = 0; i < graph.names.size(); ++i) network->stations.push_back(station_of(graph, i));
  for (const std::string& path : graph.paths) add_path(path, indices, *network);
  return network;
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(graph) { return make_kind<NetworkPtr, Graph>("graph", "network", make); }
