// The way from points near a field's surface onto it, many points in step with each other.
#pragma once

#include <vug/field/field.h>

#include <vector>

namespace vug::meshing {

/// A point near or on the surface and what the field says there.
struct SurfacePoint {
  Vec3d point;
  Vec3d normal{0, 0, 0};        ///< Unit gradient; zero where the field has none.
  double residual = kInfinity;  ///< |f| / |grad f|: distance from the surface to first order.
};

struct ProjectOptions {
  double reach = 1;      ///< Furthest from the start, metres.
  double tolerance = 0;  ///< Residual that is good enough, metres.
  int steps = 10;
};

/// What single precision may be off the exact field, voxels: a tenth of what is promised.
constexpr double kLargestError = 1e-3;

/// Asks one field about many points at once: eight at a time in single precision, whose values
/// were held against double precision at some of the points. If they differ by more than
/// `error` metres there (far from the origin, say), all that follows is in double precision.
class SurfaceProjector {
 public:
  /// `near` are points of the region that will be asked about. The field must outlive this.
  SurfaceProjector(const field::Field& field, const std::vector<Vec3d>& near, double error);

  /// What the field says at the points.
  std::vector<SurfacePoint> sample(const std::vector<Vec3d>& points);

  /// The surface near the starts, by Newton steps along the gradient, each at most half the
  /// reach: the best points met on the way. On creases the steps alternate between the branches
  /// and close in on both. Tolerances below what single precision can tell are raised to that.
  std::vector<SurfacePoint> project(const std::vector<Vec3d>& starts,
                                    const ProjectOptions& options);

  bool in_double() const { return in_double_; }

 private:
  void evaluate(const std::vector<Vec3d>& points);
  void evaluate_packs(const std::vector<Vec3d>& points);

  const field::Field& field_;
  field::Scratch scratch_;
  bool in_double_ = false;
  double noise_ = 0;  ///< Of positions in single precision, metres.
  std::vector<field::Gradient> gradients_;
};

}  // namespace vug::meshing
