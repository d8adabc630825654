// SPDX-License-Identifier: Apache-2.0
// The plan of a cave: a graph of stations joined by legs, in scene space (metres, y up). It comes
// from a survey, a karst generator, a graph in the scene text or _nodes.dat/_links.dat files.
#pragma once

#include <vug/base/vec.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::network {

/// The distances from a station to the walls in metres, seen along the passage, with the walls that
/// were not measured left out.
struct CrossSection {
  std::optional<double> left{};
  std::optional<double> right{};
  std::optional<double> up{};
  std::optional<double> down{};
};

/// What a station is to the water; several may hold.
struct StationFlags {
  bool entrance = false;
  bool sink = false;
  bool spring = false;
  bool surface = false;
};

/// Names have at least one character and no blanks.
inline bool is_station_name(const std::string& name) {
  return !name.empty() && name.find_first_of(" \t\n") == name.npos;
}

struct Station {
  std::string name{};                  ///< E.g. "dow.choke2.14"; unique, or empty.
  std::vector<std::string> equated{};  ///< Further names of the station, unique as well.
  Vec3d position{0.0};
  StationFlags flags{};
  std::optional<CrossSection> section{};
  /// Ends of splays: points on the walls, in scene space.
  std::vector<Vec3d> splays{};
};

/// The zone in which a passage formed.
enum class Stage { unknown, vadose, phreatic };

/// A leg between two stations, given by their indices. Water runs from `from` to `to`.
struct Leg {
  int from = 0;
  int to = 0;
  Stage stage = Stage::unknown;
  std::string survey{};  ///< The name of the survey or conduit to which the leg belongs.
  double discharge = 0;  ///< Relative flow, 1 at each sink; 0 if unknown.
  int tier = 0;  ///< The index of the water table that formed the leg; 0 is the present one.
  bool surface = false;    ///< The leg runs over the surface.
  bool duplicate = false;  ///< The leg repeats a passage that other legs survey.
};

struct Network {
  std::vector<Station> stations;
  std::vector<Leg> legs;
  /// The point of survey space (metres, x east, y north, z up) that is the origin of scene space.
  Vec3d origin{0.0};
  std::string coordinate_system;             ///< E.g. "EPSG:27700"; empty: local metres.
  std::vector<std::filesystem::path> files;  ///< The files that it was read from.
};

/// Legs at each station, in the order of Network::legs: the indices of the legs. A leg from a
/// station to itself is listed twice.
std::vector<std::vector<int>> legs_at_stations(const Network& network);

/// The vector of a leg in metres.
Vec3d leg_vector(const Network& network, const Leg& leg);

/// Throws Error(bad_input) if a leg refers to a missing station, a position or a splay is not
/// finite, or a distance of a cross-section is negative or not finite.
void require_valid(const Network& network);

}  // namespace vug::network
