// SPDX-License-Identifier: Apache-2.0
// A cave survey with coordinates: stations, legs and cross-sections, as .3d and .lox files store it
// and as `adjust` computes it from measurements. The terms are those of Survex and Therion.
// Survey space is in metres with x east, y north and z up; only network/ converts it to scene
// space.
#pragma once

#include <vug/base/error.h>
#include <vug/base/vec.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vug::survey {

/// A survey station. Anonymous stations, e.g. the ends of splays, have an empty name.
struct Station {
  std::string name;  ///< The full name, levels separated by '.', e.g. "dow.choke2.14".
  Vec3d position{0.0};
  bool surface = false;
  bool underground = false;
  bool entrance = false;
  bool exported = false;
  bool fixed = false;
  bool wall = false;  ///< An anonymous station on the passage wall.
  std::string comment;
  SourceLocation where;  ///< The first mention in the source text.

  bool anonymous() const { return name.empty(); }
};

/// How a leg was measured (the data styles of Survex).
enum class Style { unknown, normal, diving, cartesian, cylpolar, nosurvey };

/// Days since 1900-01-01, both inclusive.
struct DateRange {
  int first = 0;
  int last = 0;
  bool operator==(const DateRange&) const = default;
};

/// A leg between two stations, given by their indices in Survey::stations.
struct Leg {
  int from = 0;
  int to = 0;
  Style style = Style::unknown;
  bool surface = false;
  bool duplicate = false;
  bool splay = false;
  /// As measured, in metres: the length, its horizontal and its vertical part. All are 0 if the
  /// file contains coordinates only.
  double length = 0, plan_length = 0, vertical_length = 0;
  std::string survey;  ///< The survey to which the leg belongs, e.g. "dow.choke2".
  std::optional<DateRange> date;
  SourceLocation where;
};

/// The distances from a station to the walls, in metres; no value where none was measured. A
/// station at the wall has 0.
struct CrossSection {
  int station = 0;
  std::optional<double> left;
  std::optional<double> right;
  std::optional<double> up;
  std::optional<double> down;
};

/// The cross-sections along one passage, in order (a "tube" in Survex).
using Tube = std::vector<CrossSection>;

/// A closed mesh of the passage walls as Therion computes it for a scrap.
struct Scrap {
  std::string survey;
  std::vector<Vec3d> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Two stations that are the same point under different names.
struct Equate {
  int a = 0;
  int b = 0;
  SourceLocation where;
  size_t legs_before = 0;  ///< The number of legs before it in the text.
};

/// The misclosure of one traverse, a chain of legs between two junctions or fixed stations.
struct Misclosure {
  std::vector<int> stations;  ///< In order, both ends included.
  int legs = 0;
  double length = 0;  ///< Metres along the legs.
  Vec3d error{0.0};   ///< The measured minus the adjusted vector, metres.
  /// The root of the squared misclosure divided by its variance: total, horizontal, vertical.
  double e = 0, h = 0, v = 0;
};

/// A reading that is probably wrong: without it, its traverse would close much better.
struct Blunder {
  int leg = 0;          ///< Index in Survey::legs.
  std::string reading;  ///< "tape", "compass", "clino", or "vector" of a leg without angles.
  double sigmas = 0;    ///< The normalised residual, positive.
  double error = 0;     ///< Estimated error of the reading, in metres or radians, signed.
};

struct Survey {
  std::string title;
  /// As written in the source, e.g. "EPSG:27700"; empty: local metres.
  std::string coordinate_system;
  std::vector<Station> stations;
  std::vector<Leg> legs;
  std::vector<Equate> equates;
  std::vector<Tube> tubes;
  std::vector<Scrap> scraps;
  std::vector<Misclosure> misclosures;
  std::vector<Blunder> blunders;  ///< By traverse, the most likely first.
  /// The components that Survex's cavern counts; no number for coordinates without measurements.
  std::optional<int> survex_components;
  /// The files that the survey was read from, the file that the user named first.
  std::vector<std::filesystem::path> files;
};

}  // namespace vug::survey
