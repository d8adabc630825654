// SPDX-License-Identifier: Apache-2.0
// The planes of joints and faults.
#pragma once

#include <vug/base/rng.h>
#include <vug/karst/geology.h>

#include <cstdint>

namespace vug::karst {

/// The unit normal of a plane with an azimuth of strike and a dip.
Vec3d plane_normal(double azimuth, double dip);

/// The horizontal unit vector of an azimuth.
Vec3d strike_vector(double azimuth);

/// The joints of a family: planes at irregular distances, the same for a seed.
class Joints {
 public:
  Joints(const FractureFamily& family, RandomKey key)
      : family_(family), normal_(plane_normal(family.azimuth, family.dip)), key_(key) {}

  const Vec3d& normal() const { return normal_; }
  const FractureFamily& family() const { return family_; }

  /// The distance of the joint with a number from the origin, along the normal in metres.
  double offset(int64_t joint) const;
  /// The number of a joint near the point: the one whose mean position is nearest.
  int64_t nearest(const Vec3d& point) const;
  /// The distance in metres of a point to the nearest joint.
  double distance(const Vec3d& point) const;

  void add_to(Digester& digester) const { digester(family_, key_.state()); }

 private:
  FractureFamily family_;
  Vec3d normal_;
  RandomKey key_;
};

}  // namespace vug::karst
