// SPDX-License-Identifier: Apache-2.0
// Projection of points near a field's surface onto it, in batches.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::meshing {

/// A point near or on the surface, with the field's normal and distance.
struct SurfacePoint {
  Vec3d point;
  Vec3d normal{0, 0, 0};        ///< Unit gradient; zero if the gradient vanishes.
  double residual = kInfinity;  ///< |f| / |grad f|: first-order distance from the surface.
  bool inside = false;          ///< Whether the field is negative.
};

struct ProjectOptions {
  double reach = 1;      ///< Maximum distance from the start, metres.
  double tolerance = 0;  ///< Sufficient residual, metres.
  int steps = 10;
};

/// Permitted deviation of single precision from the exact field, in voxels: a tenth of the promised
/// accuracy.
constexpr double kLargestError = 1e-3;

/// Evaluates one field at many points: eight at a time in single precision after a comparison with
/// double precision at some of the points. If the difference exceeds `error` metres (for example
/// far from the origin), all evaluations use double precision.
class SurfaceProjector {
 public:
  /// `near` are points of the region to be evaluated. The field must outlive this object.
  SurfaceProjector(const field::Field& field, const std::vector<Vec3d>& near, double error);

  /// Evaluates the field at the points.
  std::vector<SurfacePoint> sample(const std::vector<Vec3d>& points);

  /// Projects the starts onto the surface by Newton steps along the gradient, each at most half the
  /// reach, and returns the best points on the way. On creases the steps alternate between the
  /// branches and converge to both. Tolerances below the resolution of single precision are raised
  /// to it.
  std::vector<SurfacePoint> project(const std::vector<Vec3d>& starts,
                                    const ProjectOptions& options);

  bool in_double() const { return in_double_; }
  /// Rounding error of positions in the evaluation, metres.
  double resolution() const { return in_double_ ? 0 : noise_; }

 private:
  void evaluate(const std::vector<Vec3d>& points);
  void evaluate_packs(const std::vector<Vec3d>& points);

  const field::Field& field_;
  field::Scratch scratch_;
  bool in_double_ = false;
  double noise_ = 0;  ///< Rounding error of positions in single precision, metres.
  std::vector<field::Gradient> gradients_;
};

}  // namespace vug::meshing
