// SPDX-License-Identifier: Apache-2.0
// The lattice is dense, so that a step of the fill is an addition. Regions are filled from the
// given points only.
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/volume/clearance.h>
#include <vug/volume/wider_band.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::volume {
namespace {

constexpr double kStepsInDiameter = 4;
constexpr int32_t kBlocked = -2, kUnvisited = -1;

void require_valid(const UprightCapsule& body) {
  if (std::isfinite(body.height) && body.diameter > 0 && body.height >= body.diameter) return;
  throw Error(
      ErrorCode::bad_input,
      fmt::format("a body of {:g} x {:g} m is not an upright capsule", body.diameter, body.height),
      {}, "its diameter must be positive, and its height at least the diameter");
}

std::array<double, 3> components(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// A place is the lattice point of the centre of the capsule's lower end.
class Lattice {
 public:
  Lattice(const LevelSet& rock, const ClearanceOptions& options, Progress& progress)
      : body_(options.body), step_(body_.diameter / kStepsInDiameter) {
    const Box3d box = rock.statistics().bounds;
    low_ = box.min;
    const std::array<double, 3> extent = components(box.max - box.min);
    for (size_t k = 0; k < 3; ++k)
      size_[k] = 1 + static_cast<int64_t>(std::max(0.0, extent[k]) / step_);
    const double places = static_cast<double>(size_[0]) * static_cast<double>(size_[1]) *
                          static_cast<double>(size_[2]);
    if (options.max_memory > 0)
      require_memory(places * sizeof(int32_t), options.max_memory, "the search for free places",
                     "use a larger body, a smaller region");
    regions_.resize(static_cast<size_t>(places), kBlocked);
    const LevelSet near = with_half_width(rock, 0.5 * body_.diameter + rock.voxel());
    progress.begin("looking for free places", static_cast<uint64_t>(size_[0]));
    for (int64_t x = 0; x < size_[0]; ++x) {
      mark_slab(near, x);
      progress.advance();
      progress.check();
    }
    progress.end();
  }

  /// The place within reach whose capsule has its centre nearest to the point, or -1.
  int64_t nearest_place(const Vec3d& point, double reach) const {
    const Vec3d lower = point - Vec3d(0, 0.5 * (body_.height - body_.diameter), 0);
    std::array<int64_t, 3> from{}, to{};
    const std::array<double, 3> at = components((lower - low_) / step_);
    for (size_t k = 0; k < 3; ++k) {
      from[k] = std::max<int64_t>(0, static_cast<int64_t>(std::floor(at[k] - reach / step_)));
      to[k] = std::min(size_[k] - 1, static_cast<int64_t>(std::ceil(at[k] + reach / step_)));
    }
    int64_t best = -1;
    double least = reach * reach;
    for (int64_t x = from[0]; x <= to[0]; ++x)
      for (int64_t z = from[2]; z <= to[2]; ++z)
        for (int64_t y = from[1]; y <= to[1]; ++y) {
          const int64_t place = index(x, y, z);
          const double distance = (position(x, y, z) - lower).length2();
          if (region(place) == kBlocked || distance > least) continue;
          if (distance == least && best >= 0) continue;
          least = distance;
          best = place;
        }
    return best;
  }

  int32_t region(int64_t place) const { return regions_[static_cast<size_t>(place)]; }

  void fill(int64_t place, int32_t region) {
    const std::array<int64_t, 3> strides = {size_[1] * size_[2], 1, size_[1]};
    std::vector<int64_t> open{place};
    regions_[static_cast<size_t>(place)] = region;
    while (!open.empty()) {
      const int64_t at = open.back();
      open.pop_back();
      const std::array<int64_t, 3> where = {at / strides[0], at % size_[1],
                                            at / size_[1] % size_[2]};
      for (size_t k = 0; k < 3; ++k)
        for (const int side : {-1, 1}) {
          if (where[k] + side < 0 || where[k] + side >= size_[k]) continue;
          int32_t& next = regions_[static_cast<size_t>(at + side * strides[k])];
          if (next != kUnvisited) continue;
          next = region;
          open.push_back(at + side * strides[k]);
        }
    }
  }

 private:
  int64_t index(int64_t x, int64_t y, int64_t z) const { return (x * size_[2] + z) * size_[1] + y; }
  Vec3d position(int64_t x, int64_t y, int64_t z) const {
    return low_ +
           step_ * Vec3d(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }

  /// The distance to the rock must be a radius all along the axis of the capsule.
  void mark_slab(const LevelSet& near, int64_t x) {
    const double radius = 0.5 * body_.diameter;
    const auto axis =
        1 + static_cast<int64_t>(std::ceil((body_.height - body_.diameter) / step_ - 1e-9));
    std::vector<Vec3d> points;
    points.reserve(static_cast<size_t>(size_[1] * size_[2]));
    for (int64_t z = 0; z < size_[2]; ++z)
      for (int64_t y = 0; y < size_[1]; ++y) points.push_back(position(x, y, z));
    const std::vector<double> distances = near.values(points);
    parallel_for(static_cast<size_t>(size_[2]), [&](size_t row) {
      const auto z = static_cast<int64_t>(row);
      int64_t clear = 0;  // Points above each other, from the top down.
      for (int64_t y = size_[1] - 1; y >= 0; --y) {
        const double distance = distances[static_cast<size_t>(z * size_[1] + y)];
        clear = distance >= radius ? clear + 1 : 0;
        if (clear >= axis) regions_[static_cast<size_t>(index(x, y, z))] = kUnvisited;
      }
    });
  }

  UprightCapsule body_;
  double step_;
  Vec3d low_{0.0};
  std::array<int64_t, 3> size_{};
  std::vector<int32_t> regions_;
};

}  // namespace

std::vector<int> free_regions(const LevelSet& rock, const std::vector<Vec3d>& points,
                              const ClearanceOptions& options, Progress& progress) {
  require_valid(options.body);
  std::vector<int> out(points.size(), -1);
  if (rock.empty()) return out;
  Lattice lattice(rock, options, progress);
  int32_t count = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const int64_t place = lattice.nearest_place(points[i], options.reach);
    if (place < 0) continue;
    if (lattice.region(place) == kUnvisited) lattice.fill(place, count++);
    out[i] = lattice.region(place);
  }
  return out;
}

}  // namespace vug::volume
