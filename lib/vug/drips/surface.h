// SPDX-License-Identifier: Apache-2.0
// Points on the surface of rock: along vertical lines, and near other points.
#pragma once

#include <vug/field/field.h>

#include <array>
#include <optional>
#include <span>

namespace vug::drips {

/// The unit normal into the air, (0, 0, 0) where the gradient vanishes.
Vec3d normal_at(const field::Field& rock, const Vec3d& p);

/// The point of the surface that Newton's method finds from `p`; nothing if it is farther than
/// `reach` metres or if it does not converge.
std::optional<Vec3d> onto_surface(const field::Field& rock, const Vec3d& p, double reach);

/// The vertical line through a point. Heights are sampled at fixed steps. The signs of samples come
/// from bounds of the field, else from values in single precision, and within the rounding errors
/// of those from values in double precision: they are the signs of the latter.
class VerticalLine {
 public:
  /// The rock must outlive the line.
  VerticalLine(const field::Field& rock, const Vec3d& at, double step)
      : rock_(rock), at_(at), step_(step) {}

  /// The height of the first change between rock and air on the way from one height to another,
  /// up or down.
  std::optional<double> crossing(double from, double to) const;
  bool solid(double y) const { return value(rock_, y) <= 0; }

 private:
  double value(const field::Field& rock, double y) const { return rock.value({at_.x, y, at_.z}); }
  /// More samples of a line are divided.
  static constexpr size_t kMostSamples = 32;
  using Samples = std::array<float, kMostSamples>;
  /// Values in single precision at these heights.
  Samples sample(const field::Field& rock, std::span<const double> heights) const;
  bool solid(const field::Field& rock, double y, float sampled, double unsure) const;
  double rounding(double from, double to) const;
  field::Ball ball(double a, double b) const;
  std::optional<double> first_change(const field::Field& rock, std::span<const double> heights,
                                     bool inside) const;
  double refined(const field::Field& rock, double near, double far, bool inside) const;

  const field::Field& rock_;
  Vec3d at_;
  double step_;
};

}  // namespace vug::drips
