// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/path.h>
#include <vug/field/speleothems/drapery_sheet.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// Rows of corners below the path, at least where corners are coarse, and points of the path for
/// each fold.
constexpr int kRows = 8, kFewestRows = 3, kPointsPerFold = 7;
/// Steps along the path if the sheet has no folds, and limits of their number.
constexpr double kPlainSteps = 24;
constexpr int kMostSteps = 110;
/// The sheet reaches 63 % of its width at this fraction of the path; it closes over the last one.
constexpr double kRise = 0.2, kClose = 0.12;
/// Folds swing by this fraction of their distance at the edge, and grow with the height below the
/// root to the given power.
constexpr double kSwing = 0.24, kSwingPower = 1.3;
/// Folds are closer here and wider there by a wave of the phase, in radians and folds.
constexpr double kDrift = 0.7, kDriftLength = 3.3;
/// Layers vary in thickness by this fraction: the bands of bacon.
constexpr double kBands = 0.12;
/// The sheet is as thin as its edge from this fraction of its width on.
constexpr double kThinned = 0.6;

/// Horizontal and at a right angle to the path, as it runs over some points to both sides.
Vec3d side_at(const std::vector<Vec3d>& path, size_t i, const Vec3d& last) {
  constexpr size_t kReach = 4;
  Vec3d way = path[std::min(i + kReach, path.size() - 1)] - path[i > kReach ? i - kReach : 0];
  way.y = 0;
  if (!(way.length2() > 1e-12)) return last;
  const Vec3d side = Vec3d(way.z, 0, -way.x).normalized();
  return side.dot(last) < 0 ? -side : side;
}

}  // namespace

double drapery_profile(double t) {
  t = std::clamp(t, 0.0, 1.0);
  const double risen = (1 - maths::exp(-t / kRise)) / (1 - maths::exp(-1 / kRise));
  const double past = std::max(0.0, (t - (1 - kClose)) / kClose);
  return risen * std::sqrt(std::max(0.0, 1 - past * past));
}

std::vector<Vec3d> resampled(const std::vector<Vec3d>& path, double step) {
  const double length = path_length(path);
  const int count = std::max(1, static_cast<int>(std::ceil(length / step)));
  std::vector<Vec3d> out;
  size_t k = 0;
  double passed = 0;  // The length up to point k.
  for (int i = 0; i <= count; ++i) {
    const double wanted = length * i / count;
    while (k + 2 < path.size() && passed + (path[k + 1] - path[k]).length() < wanted) {
      passed += (path[k + 1] - path[k]).length();
      ++k;
    }
    const Vec3d way = path[k + 1] - path[k];
    const double share = way.length() > 0 ? (wanted - passed) / way.length() : 0;
    out.push_back(path[k] + way * std::clamp(share, 0.0, 1.0));
  }
  return out;
}

Sheet drapery_sheet(const Drapery& d, RandomKey key) {
  RandomStream random(key);
  const double first = random.uniform(0, 2 * kPi), drift = random.uniform(0, 2 * kPi);
  std::vector<double> bands;
  const int rows = d.finest > 0
                       ? std::clamp(static_cast<int>(d.width / (2 * d.finest)), kFewestRows, kRows)
                       : kRows;
  for (int row = 0; row <= rows; ++row) bands.push_back(kBands * random.uniform(-1, 1));
  const double length = path_length(d.path);
  const double step = d.fold > 0 ? d.fold / kPointsPerFold : length / kPlainSteps;
  const std::vector<Vec3d> path =
      resampled(d.path, std::max({step, length / kMostSteps, d.finest}));
  Sheet sheet;
  sheet.across = rows + 2;
  Vec3d side(0, 0, 1);
  for (size_t i = 0; i < path.size(); ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(path.size() - 1);
    const double width = d.width * drapery_profile(along), s = length * along;
    side = side_at(path, i, side);
    double swing = 0;
    if (d.fold > 0) {
      const double turn = 2 * kPi * s / d.fold;
      swing = kSwing * d.fold *
              maths::sin(turn + first + kDrift * maths::sin(turn / kDriftLength + drift));
    }
    sheet.corners.push_back(path[i] + Vec3d(0, d.root, 0));
    sheet.radii.push_back(0.5 * d.root_thickness);
    for (int row = 0; row <= rows; ++row) {
      const double part = static_cast<double>(row) / rows;
      const double below = width * part;
      // Folds need the height of a fold to grow to their full swing.
      const double grown =
          std::min(1.0, width / std::max(d.fold, 1e-9)) * maths::pow(part + 1e-12, kSwingPower);
      sheet.corners.push_back(path[i] - Vec3d(0, below, 0) + side * (swing * grown));
      const double thick = d.root_thickness + std::min(1.0, below / (kThinned * d.width)) *
                                                  (d.edge - d.root_thickness);
      const double band = row == 0 || row == rows ? 0 : bands[static_cast<size_t>(row)];
      sheet.radii.push_back(0.5 * thick * (1 + band * width / d.width));
    }
  }
  return sheet;
}

}  // namespace vug::field
