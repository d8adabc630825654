// SPDX-License-Identifier: Apache-2.0
// Internal to simulate_survey: the line of a survey through the air of passages, as cavers who see
// from each station to the next one would choose it.
#pragma once

#include <vug/field/field.h>

#include <optional>
#include <vector>

namespace vug::passages {

/// One side of the surface of a field.
class Air {
 public:
  /// `negative`: whether the air is where the field is below 0. The field must outlive the object.
  Air(const field::Field& field, bool negative) : field_(field), negative_(negative) {}

  bool contains(const Vec3d& point) const { return (field_.value(point) < 0) == negative_; }

  /// The point itself if it is at least 0.1 m inside the air by the value of the field, else one
  /// that is, or the deepest in the air, found along the gradient at most `reach` metres away.
  /// Nothing if all of them are in the rock.
  std::optional<Vec3d> nearest(const Vec3d& point, double reach) const;

  /// Whether no rock is between two points in the air.
  bool sees(const Vec3d& from, const Vec3d& to) const;

  /// Points between two in the air, in order, so that each sees the next one, as far as points at
  /// most `reach` metres from the straight line of their neighbours allow it. Empty if the two see
  /// each other or no such point helps.
  std::vector<Vec3d> bends(const Vec3d& from, const Vec3d& to, double reach) const;

 private:
  bool add_bends(const Vec3d& from, const Vec3d& to, double reach, int levels,
                 std::vector<Vec3d>& points) const;

  const field::Field& field_;
  bool negative_;
};

}  // namespace vug::passages
