// SPDX-License-Identifier: Apache-2.0
// The rock and the water in which a karst network forms, in scene space (metres, y up). Azimuths
// are radians clockwise from north (-z) seen from above, dips radians down from the horizontal.
#pragma once

#include <vug/field/field.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::karst {

/// A plane: the inception horizon of a bed, or a water table.
struct Layer {
  Vec3d point{0.0};        ///< A point of the plane.
  double dip = 0;          ///< In 0 to less than pi/2.
  double dip_azimuth = 0;  ///< The direction of steepest descent.

  double height_at(double x, double z) const;
};

/// Parallel joints.
struct FractureFamily {
  double azimuth = 0;    ///< Azimuth of the strike.
  double dip = kPi / 2;  ///< pi/2: vertical joints; they dip to the right of the strike.
  double spacing = 20;   ///< Mean distance between joints in metres.
  double spread = 0.15;  ///< Standard deviation of the directions in radians.
};

/// One plane that water follows like a joint, over its whole extent.
struct Fault {
  Vec3d point{0.0};
  double azimuth = 0;  ///< Azimuth of the strike.
  double dip = kPi / 2;
  double width = 5;  ///< Distance in metres over which it attracts water.
};

/// A ball of rock in which water flows easily, or poorly if the strength is negative.
struct PermeableBall {
  Vec3d center{0.0};
  double radius = 30;
  double strength = 1;  ///< In -1..1.
};

/// Where a stream enters the rock.
struct Sink {
  Vec3d position{0.0};
  double discharge = 1;  ///< Relative, positive.
  std::string name{};    ///< Empty: "sink.N".
};

/// Where water leaves the rock.
struct Spring {
  Vec3d position{0.0};
  int tier = 0;        ///< The index of the water table in whose time it was active.
  std::string name{};  ///< Empty: "spring.N".
};

struct Geology {
  Box3d bounds{Vec3d(-300, -80, -300), Vec3d(300, 40, 300)};
  std::optional<field::Field> solid{};  ///< The rock, negative inside; none: all of the bounds.
  std::vector<Layer> beds{};            ///< Inception horizons.
  std::vector<FractureFamily> fractures{};
  std::vector<Fault> faults{};
  std::vector<PermeableBall> permeable{};
  std::vector<field::Field> ghost_rock{};  ///< Weathered rock, negative inside.
  /// The present water table, then former ones from young to old, each above the one before.
  std::vector<Layer> water_tables{};
  std::vector<Sink> sinks{};
  std::vector<Spring> springs{};
  std::vector<Vec3d> entrances{};  ///< Joined to the network and flagged.
  std::vector<Vec3d> waypoints{};  ///< Points through which passages lead.
};

/// Throws Error(bad_input) for bounds, planes, points or numbers that are not finite or out of
/// range.
void require_valid(const Geology& geology);

}  // namespace vug::karst
