// SPDX-License-Identifier: Apache-2.0
// Fitting of a facade's plane to a point cloud, and the frame on the plane.
#pragma once

#include <vug/base/rng.h>
#include <vug/scan/point_cloud.h>

#include <optional>

namespace vug::scan {

/// A right-handed orthonormal frame on a plane: seen from the scanner, x points right, y up and z
/// towards the viewer.
struct PlaneFrame {
  Vec3d origin{0, 0, 0};
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  /// World to plane coordinates in metres, and back.
  Vec3d local(const Vec3d& p) const {
    const Vec3d d = p - origin;
    return {d.dot(x), d.dot(y), d.dot(z)};
  }
  Vec3d world(const Vec3d& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

struct PlaneOptions {
  /// Maximum distance of the plane's points from it, in metres.
  double tolerance = 0.1;
  /// Up direction in the cloud's axes (surveying convention); any length but 0.
  Vec3d up{0, 0, 1};
  /// Maximum inclination from the vertical in radians: 0 only accepts upright planes, pi / 2 any
  /// plane.
  double max_lean = 0.35;
  std::optional<Vec3d> scanner =
      std::nullopt;   ///< Scanner position in the cloud's axes; determines the front.
  bool flip = false;  ///< Use the other side as the front.
  /// Probability that at least one sample contains only points of the plane.
  double confidence = 0.9999;
};

struct PlaneFit {
  PlaneFrame frame;    ///< The origin is the mean of the plane's points.
  size_t inliers = 0;  ///< Points within the tolerance.
  double rms = 0;      ///< Root mean square of their distances, metres.
  double tolerance = 0.1;
  double lean = 0;  ///< Inclination from the vertical, radians.
  int samples = 0;  ///< Number of samples tried.
  /// Distances of the facade's walls in front of the plane, metres, from back to front: 0 for the
  /// plane itself, and those of parallel walls such as gables. See parallel_walls.
  std::vector<double> walls = {0};
};

/// RANSAC [@fischler1981]: the plane with the most points within the tolerance among random
/// samples, refined by alternating least squares and point selection until the selection is stable.
/// A plane inclined by more than the limit is replaced by the best upright one.
///
/// The front is the side of the scanner; without its position, the side that the normals face;
/// without normals, the side opposite to the longer tail of points. Surfaces seen behind a facade's
/// plane, through openings and on set back windows, are further away from it than surfaces in front
/// of it within a metre (sign of the sum of cubed distances).
///
/// Error(bad_input) for fewer than three points, for collinear points, or for options out of range.
/// The result does not depend on the number of threads.
PlaneFit fit_plane(const PointCloud& cloud, const PlaneOptions& options, RandomKey key);

}  // namespace vug::scan
