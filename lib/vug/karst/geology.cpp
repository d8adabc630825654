// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/karst/geology.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr double kLargest = 1e6;  ///< Metres.

void require(bool valid, const std::string& what, const char* expected) {
  if (!valid) throw Error(ErrorCode::bad_input, what, {}, expected);
}

void require_point(const Vec3d& p, const std::string& what) {
  const bool valid =
      std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest && std::abs(p.z) <= kLargest;
  require(valid, fmt::format("{} is at ({}, {}, {})", what, p.x, p.y, p.z),
          "coordinates must be finite and at most 1e6 metres");
}

std::string name_of(const std::string& name, const char* kind, size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : fmt::format("{} '{}'", kind, name);
}

void require_angle(double angle, const std::string& what) {
  require(std::abs(angle) <= 100, fmt::format("{} has an angle of {}", what, angle),
          "angles are in radians and must be finite");
}

void require_dip(double dip, double most, const std::string& what) {
  require(dip >= 0 && dip <= most, fmt::format("{} has a dip of {} radians", what, dip),
          "dips are between 0 (level) and pi/2 (vertical); layers must dip less than 1.5");
}

void require_layer(const Layer& layer, const std::string& what) {
  require_point(layer.point, what);
  require_dip(layer.dip, 1.5, what);
  require_angle(layer.dip_azimuth, what);
}

}  // namespace

double Layer::height_at(double x, double z) const {
  // North is -z, so the horizontal direction of an azimuth a is (sin a, -cos a) in x and z.
  const double along =
      (x - point.x) * maths::sin(dip_azimuth) - (z - point.z) * maths::cos(dip_azimuth);
  return point.y - (dip == 0 ? 0.0 : along * maths::tan(dip));
}

void require_valid(const Geology& g) {
  require_point(g.bounds.min, "the lower corner of the bounds");
  require_point(g.bounds.max, "the upper corner of the bounds");
  const Vec3d size = g.bounds.size();
  require(
      size.x > 0 && size.y > 0 && size.z > 0,
      fmt::format("the rock reaches from ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", g.bounds.min.x,
                  g.bounds.min.y, g.bounds.min.z, g.bounds.max.x, g.bounds.max.y, g.bounds.max.z),
      "each coordinate of 'from' must be below that of 'to'");
  for (size_t i = 0; i < g.beds.size(); ++i) require_layer(g.beds[i], fmt::format("bed {}", i + 1));
  for (size_t i = 0; i < g.water_tables.size(); ++i)
    require_layer(g.water_tables[i], fmt::format("water table {}", i + 1));
  const Vec3d middle = g.bounds.center();
  for (size_t i = 1; i < g.water_tables.size(); ++i)
    require(g.water_tables[i].height_at(middle.x, middle.z) >
                g.water_tables[i - 1].height_at(middle.x, middle.z),
            fmt::format("water table {} lies below water table {}", i + 1, i),
            "list the present water table first, and former ones by their height above it");
  for (size_t i = 0; i < g.fractures.size(); ++i) {
    const std::string what = fmt::format("fracture family {}", i + 1);
    require_angle(g.fractures[i].azimuth, what);
    require_dip(g.fractures[i].dip, kPi / 2 + 1e-9, what);
    require(g.fractures[i].spacing > 0.01 && g.fractures[i].spacing <= kLargest,
            fmt::format("{} has a spacing of {}", what, g.fractures[i].spacing),
            "use a spacing of more than 1 cm");
    require(g.fractures[i].spread > 0 && g.fractures[i].spread <= 10,
            fmt::format("{} has a spread of {}", what, g.fractures[i].spread),
            "the spread must be positive, in radians");
  }
  for (size_t i = 0; i < g.faults.size(); ++i) {
    const std::string what = fmt::format("fault {}", i + 1);
    require_point(g.faults[i].point, what);
    require_angle(g.faults[i].azimuth, what);
    require_dip(g.faults[i].dip, kPi / 2 + 1e-9, what);
    require(g.faults[i].width > 0 && g.faults[i].width <= kLargest,
            fmt::format("{} has a width of {}", what, g.faults[i].width),
            "the width must be positive");
  }
  for (size_t i = 0; i < g.permeable.size(); ++i) {
    const std::string what = fmt::format("permeable ball {}", i + 1);
    require_point(g.permeable[i].center, what);
    require(g.permeable[i].radius > 0 && g.permeable[i].radius <= kLargest,
            fmt::format("{} has a radius of {}", what, g.permeable[i].radius),
            "the radius must be positive");
    require(std::abs(g.permeable[i].strength) <= 1,
            fmt::format("{} has a strength of {}", what, g.permeable[i].strength),
            "the strength must be between -1 and 1");
  }
  const auto tiers = static_cast<int>(std::max<size_t>(1, g.water_tables.size()));
  for (size_t i = 0; i < g.springs.size(); ++i) {
    require_point(g.springs[i].position, name_of(g.springs[i].name, "spring", i));
    require(g.springs[i].tier >= 0 && g.springs[i].tier < tiers,
            fmt::format("{} belongs to tier {} of {}", name_of(g.springs[i].name, "spring", i),
                        g.springs[i].tier, tiers),
            "tiers count from 0, the present water table");
  }
  for (size_t i = 0; i < g.sinks.size(); ++i) {
    require_point(g.sinks[i].position, name_of(g.sinks[i].name, "sink", i));
    require(g.sinks[i].discharge > 0 && std::isfinite(g.sinks[i].discharge),
            fmt::format("{} has a discharge of {}", name_of(g.sinks[i].name, "sink", i),
                        g.sinks[i].discharge),
            "the discharge must be positive");
  }
  require(g.sinks.empty() || !g.springs.empty(), "the geology has sinks, but no spring",
          "add a spring at which the water leaves the rock");
  for (const Vec3d& p : g.entrances) require_point(p, "an entrance");
  for (const Vec3d& p : g.waypoints) require_point(p, "a waypoint");
}

}  // namespace vug::karst
