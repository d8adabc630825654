// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/scan/parallel_walls.h>
#include <vug/scan/plane.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

constexpr size_t kMaxVotes = 20000;  ///< Points that vote on a sample.
constexpr int kMaxSamples = 5000;
constexpr int kMaxRounds = 50;
constexpr double kBehind = 1.0;  ///< Metres; range of the tails that determine the front.

struct CandidatePlane {
  Vec3d point{0, 0, 0};
  Vec3d normal{0, 0, 0};  ///< Zero: no plane.

  bool exists() const { return normal.length2() > 0; }
  double distance(const Vec3d& p) const { return (p - point).dot(normal); }
};

double lean_of(const Vec3d& normal, const Vec3d& up) {
  return kPi / 2 - maths::acos(std::min(1.0, std::fabs(normal.dot(up))));
}

/// Moments of points for a least squares plane, about a nearby origin for precision.
struct Moments {
  /// `squares`: squared distances from the plane that selected the points.
  double count = 0, squares = 0;
  Vec3d sum{0, 0, 0};
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();

  Moments operator+(const Moments& o) const {
    return {count + o.count, squares + o.squares, sum + o.sum, products + o.products};
  }
};

class PlaneFitter {
 public:
  PlaneFitter(const PointCloud& cloud, const PlaneOptions& options)
      : points_(cloud.positions),
        options_(options),
        up_(options.up.normalized()),
        middle_(ordered_sum(points_.size(), Vec3d(0), [&](size_t i) { return points_[i]; }) /
                static_cast<double>(points_.size())),
        stride_((points_.size() + kMaxVotes - 1) / kMaxVotes) {}

  PlaneFit fit(RandomKey key) const {
    PlaneFit out;
    CandidatePlane best = sampled(RandomStream(key), out.samples);
    if (!best.exists())
      throw Error(ErrorCode::bad_input, "the points of the cloud are collinear", {},
                  "a plane needs points off the line");
    Moments chosen = moments(best);
    for (int round = 0; round < kMaxRounds; ++round) {
      const CandidatePlane next = least_squares(chosen, best);
      const Moments again = moments(next);
      const bool settled = again.count == chosen.count && again.sum == chosen.sum;
      best = next, chosen = again;
      if (settled) break;
    }
    out.inliers = static_cast<size_t>(chosen.count);
    out.rms = std::sqrt(chosen.squares / chosen.count);
    out.tolerance = options_.tolerance;
    out.lean = lean_of(best.normal, up_);
    out.frame.origin = best.point;
    out.frame.z = best.normal;
    return out;
  }

  const Vec3d& up() const { return up_; }

 private:
  CandidatePlane through(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    Vec3d normal = (b - a).cross(c - a);
    // Rounding makes a plane of any three points.
    if (normal.length() <= 1e-9 * (b - a).length() * (c - a).length()) return {};
    normal.normalize();
    return lean_of(normal, up_) > options_.max_lean ? upright(a, b - a) : CandidatePlane{a, normal};
  }

  CandidatePlane upright(const Vec3d& point, const Vec3d& along) const {
    const Vec3d normal = along.cross(up_);
    if (normal.length() <= 1e-9 * along.length()) return {};
    return {point, normal.normalized()};
  }

  size_t votes(const CandidatePlane& plane) const {
    return ordered_sum((points_.size() + stride_ - 1) / stride_, size_t{0}, [&](size_t i) {
      return size_t{std::fabs(plane.distance(points_[i * stride_])) <= options_.tolerance};
    });
  }

  CandidatePlane sampled(RandomStream stream, int& samples) const {
    const auto count = static_cast<uint32_t>(points_.size());
    const size_t voting = (points_.size() + stride_ - 1) / stride_;
    const auto voters = static_cast<double>(voting);
    CandidatePlane best;
    size_t most = 0;
    double needed = kMaxSamples;
    for (samples = 0; samples < kMaxSamples && samples < needed; ++samples) {
      const uint32_t a = stream.below(count), b = stream.below(count), c = stream.below(count);
      const CandidatePlane plane = through(points_[a], points_[b], points_[c]);
      if (!plane.exists()) continue;
      const size_t agreed = votes(plane);
      if (agreed <= most) continue;
      most = agreed, best = plane;
      const double share = static_cast<double>(most) / voters;
      const double all_good = share * share * share;
      // At least a hundred samples: planes through inliers still differ, depending on the distance
      // between the points.
      needed =
          all_good >= 1
              ? 100
              : std::max(100.0, maths::log(1 - options_.confidence) / maths::log(1 - all_good));
    }
    return best;
  }

  Moments moments(const CandidatePlane& plane) const {
    return ordered_sum(points_.size(), Moments{}, [&](size_t i) {
      const double distance = plane.distance(points_[i]);
      if (std::fabs(distance) > options_.tolerance) return Moments{};
      const Vec3d p = points_[i] - middle_;
      const Eigen::Vector3d e(p.x, p.y, p.z);
      return Moments{1, distance * distance, p, e * e.transpose()};
    });
  }

  CandidatePlane least_squares(const Moments& m, const CandidatePlane& before) const {
    const Vec3d mean = m.sum / m.count;
    const Eigen::Vector3d e(mean.x, mean.y, mean.z);
    Eigen::Matrix3d spread = m.products / m.count - e * e.transpose();
    const auto smallest_eigenvector = [](const Eigen::Matrix3d& of) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(of);
      const Eigen::Vector3d v = solver.eigenvectors().col(0);
      return Vec3d(v.x(), v.y(), v.z());
    };
    Vec3d normal = smallest_eigenvector(spread);
    if (lean_of(normal, up_) > options_.max_lean) {
      // Covariance of the points in plan, with the vertical direction made the largest.
      const Eigen::Vector3d u(up_.x, up_.y, up_.z);
      const Eigen::Matrix3d level = Eigen::Matrix3d::Identity() - u * u.transpose();
      normal =
          smallest_eigenvector(level * spread * level + 2 * spread.trace() * u * u.transpose());
      normal = (normal - up_ * normal.dot(up_)).normalized();
    }
    if (normal.dot(before.normal) < 0) normal = -normal;
    return {middle_ + mean, normal};
  }

  const std::vector<Vec3d>& points_;
  const PlaneOptions& options_;
  Vec3d up_;
  Vec3d middle_;
  size_t stride_;
};

void require_plane_options(const PointCloud& cloud, const PlaneOptions& options) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::bad_input, message); };
  if (cloud.size() < 3) refuse("a plane needs at least three points");
  if (cloud.size() > UINT32_MAX) refuse("a cloud has at most 4294967295 points");
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance)))
    refuse("the tolerance of a plane must be above 0");
  if (!(options.up.length() > 0 && std::isfinite(options.up.length())))
    refuse("the up direction must not be zero");
  if (!(options.max_lean >= 0)) refuse("the maximum lean must not be negative");
  if (!(options.confidence > 0 && options.confidence < 1))
    refuse("the confidence must lie between 0 and 1");
}

/// Positive if the front is on the side of the frame's z.
double front(const PointCloud& cloud, const PlaneFrame& frame, const PlaneOptions& options) {
  if (options.scanner) return (*options.scanner - frame.origin).dot(frame.z);
  const Vec3f z(frame.z);
  if (!cloud.normals.empty())
    return ordered_sum(cloud.size(), 0.0, [&](size_t i) {
      const double along = cloud.normals[i].dot(z);
      return std::isfinite(along) ? along : 0;
    });
  return -ordered_sum(cloud.size(), 0.0, [&](size_t i) {
    const double d = (cloud.positions[i] - frame.origin).dot(frame.z);
    return std::fabs(d) <= kBehind ? d * d * d : 0;
  });
}

}  // namespace

PlaneFit fit_plane(const PointCloud& cloud, const PlaneOptions& options, RandomKey key) {
  require_plane_options(cloud, options);
  const PlaneFitter fitter(cloud, options);
  PlaneFit out = fitter.fit(key);
  PlaneFrame& frame = out.frame;
  if ((front(cloud, frame, options) < 0) != options.flip) frame.z = -frame.z;
  Vec3d x = fitter.up().cross(frame.z);
  // For a horizontal plane the right is arbitrary: use the cloud's first axis.
  if (x.length() < 1e-6) x = Vec3d(1, 0, 0) - frame.z * frame.z.x;
  if (x.length() < 1e-6) x = Vec3d(0, 1, 0) - frame.z * frame.z.y;
  frame.x = x.normalized();
  frame.y = frame.z.cross(frame.x);
  out.walls = parallel_walls(cloud, out);
  return out;
}

}  // namespace vug::scan
