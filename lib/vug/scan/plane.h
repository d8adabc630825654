// The plane of a facade in a cloud, and the frame on it.
#pragma once

#include <vug/base/rng.h>
#include <vug/scan/point_cloud.h>

#include <optional>

namespace vug::scan {

/// A right-handed frame on a plane: seen from where the scanner stood, x goes to the right, y up
/// and z towards the viewer. All of unit length.
struct PlaneFrame {
  Vec3d origin{0, 0, 0};
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  /// World to plane: metres along x, y and z; and back.
  Vec3d local(const Vec3d& p) const {
    const Vec3d d = p - origin;
    return {d.dot(x), d.dot(y), d.dot(z)};
  }
  Vec3d world(const Vec3d& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

struct PlaneOptions {
  /// Largest distance of a plane's points from it, in metres.
  double tolerance = 0.1;
  Vec3d up{0, 0, 1};  ///< Surveyors' axes; of any length but 0.
  /// How far the plane may lean from the plumb, in radians: 0 is an upright plane, half of pi any.
  double max_lean = 0.35;
  std::optional<Vec3d> scanner =
      std::nullopt;            ///< Where it stood, in the cloud's axes; tells the front.
  bool flip = false;           ///< The other side is the front.
  double confidence = 0.9999;  ///< That some sample was of the plane's points alone.
};

struct PlaneFit {
  PlaneFrame frame;    ///< At the middle of the plane's points.
  size_t inliers = 0;  ///< Points within the tolerance.
  double rms = 0;      ///< Of their distances, in metres.
  double tolerance = 0.1;
  double lean = 0;  ///< From the plumb, in radians.
  int samples = 0;  ///< That were tried.
};

/// The plane with the most points within the tolerance among random samples [@fischler1981], then
/// that of their least squared distances, in turns until the points stay the same. A plane that
/// leans too much is replaced by the best upright one.
///
/// The front is where the scanner stood; if that is not told, where normals look; without normals,
/// the side away from the longer tail of points: what is seen behind a facade's plane, through
/// openings and on set back windows, lies farther from it than what is seen before it within a
/// metre (the sign of the sum of cubed distances).
///
/// Error(bad_input) for fewer than three points, for points on one line, or for options out of
/// range. The same for any number of threads.
PlaneFit fit_plane(const PointCloud& cloud, const PlaneOptions& options, RandomKey key);

}  // namespace vug::scan
