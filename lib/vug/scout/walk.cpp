// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/trace_view.h>
#include <vug/scout/walk.h>

#include <array>
#include <cmath>
#include <deque>
#include <set>

namespace vug::scout {
namespace {

constexpr double kCrouched = 0.6, kChest = 1.3;  // metres above the floor
constexpr double kOver = 0.1;                    // metres from the chest to the ceiling
constexpr double kBody = 0.25;                   // metres from the chest to a wall
constexpr double kStorey = 1.5;  // places of one column that are closer are the same
constexpr double kDeepest = 30;  // metres below a start

double headroom_above(const render::PreparedScene& world, const Vec3d& floor) {
  constexpr double kLift = 0.05;
  const Seen above = look_along(world, floor + Vec3d(0, kLift, 0), {0, 1, 0});
  return static_cast<double>(above.distance) + kLift;
}

class Walk {
 public:
  Walk(const render::PreparedScene& world, const WalkOptions& options)
      : world_(world), options_(options) {}

  void start(const Vec3d& from) {
    // The column of the grid next to the start, if nothing is in between.
    const double step = options_.step;
    const Vec3d column(std::round(from.x / step) * step, from.y, std::round(from.z / step) * step);
    for (const Vec3d& p : {column, from}) {
      const Vec3d way = p - from;
      if (way.length() > 0 &&
          static_cast<double>(look_along(world_, from, way).distance) < way.length())
        continue;
      if (const auto floor = floor_below(world_, p, kDeepest)) return reach(*floor);
    }
  }

  std::vector<Stand> run() {
    for (size_t i = 0; i < found_.size() && found_.size() < options_.most; ++i)
      for (int dx = -1; dx <= 1; ++dx)
        for (int dz = -1; dz <= 1; ++dz)
          if (dx != 0 || dz != 0) step(Stand(found_[i]), dx, dz);
    return std::move(found_);
  }

 private:
  void reach(const Vec3d& floor) {
    const std::array<long, 3> cell = {std::lround(floor.x / options_.step),
                                      std::lround(floor.y / kStorey),
                                      std::lround(floor.z / options_.step)};
    if (known_.count(cell)) return;
    const double headroom = headroom_above(world_, floor);
    if (headroom < options_.headroom) return;
    known_.insert(cell);
    found_.push_back({floor, headroom});
  }

  /// Goes to a neighbour upright or crouching.
  void step(const Stand& stand, int dx, int dz) {
    const double size = options_.step;
    const Vec3d& from = stand.floor;
    for (const double chest : {kChest, kCrouched}) {
      if (chest > stand.headroom - kOver) continue;
      const Vec3d eye = from + Vec3d(0, chest, 0);
      const Vec3d to((std::round(from.x / size) + dx) * size, eye.y,
                     (std::round(from.z / size) + dz) * size);
      const Vec3d way = to - eye;
      if (static_cast<double>(look_along(world_, eye, way).distance) < way.length() + kBody)
        continue;
      const auto floor = floor_below(world_, to, chest + options_.drop);
      if (floor && floor->y - from.y <= options_.climb) return reach(*floor);
    }
  }

  const render::PreparedScene& world_;
  const WalkOptions& options_;
  std::vector<Stand> found_;
  std::set<std::array<long, 3>> known_;
};

}  // namespace

std::vector<Stand> walkable_floor(const render::PreparedScene& world,
                                  const std::vector<Vec3d>& starts, const WalkOptions& options) {
  Walk walk(world, options);
  for (const Vec3d& start : starts) walk.start(start);
  return walk.run();
}

std::vector<Vec3d> points_in_air(const render::PreparedScene& world) {
  constexpr int kColumns = 24, kRows = 8;
  constexpr double kFree = 0.5;
  const Box3d box(Vec3d(world.bounds().min), Vec3d(world.bounds().max));
  std::vector<Vec3d> points;
  for (int x = 0; x < kColumns; ++x)
    for (int z = 0; z < kColumns; ++z)
      for (int y = 0; y < kRows; ++y) {
        const Vec3d share((x + 0.5) / kColumns, (y + 0.5) / kRows, (z + 0.5) / kColumns);
        const Vec3d p = box.min + box.size() * share;
        if (clearance(world, p) > kFree) points.push_back(p);
      }
  return points;
}

}  // namespace vug::scout
