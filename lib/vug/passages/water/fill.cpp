// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/deferred.h>
#include <vug/field/noise.h>
#include <vug/passages/water/fill.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vug::passages {
namespace {

constexpr double kMostCells = 2e8;
constexpr double kOverlapInCells = 1.5;

using Cell = std::array<int, 3>;

/// The cells of the region below the level; those with y = 0 touch the surface from below.
class CellGrid {
 public:
  CellGrid(const field::Field& rock, const FillOptions& options) : options_(options) {
    const Box3d& region = options.region;
    const double cell = options.cell;
    const double depth = std::min(options.level, region.max.y) - region.min.y;
    if (!(depth > 0))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the level {:g} m of the water is below the region, which begins at "
                              "{:g} m",
                              options.level, region.min.y),
                  {}, "raise the level, or lower 'from'");
    const Vec3d counts(std::ceil((region.max.x - region.min.x) / cell), std::ceil(depth / cell),
                       std::ceil((region.max.z - region.min.z) / cell));
    if (!(counts.x * counts.y * counts.z <= kMostCells))
      throw Error(ErrorCode::too_large,
                  fmt::format("water in cells of {:g} m needs {:.3g} cells", cell,
                              counts.x * counts.y * counts.z),
                  {}, "use larger cells or a smaller region");
    for (size_t i = 0; i < 3; ++i) count_[i] = static_cast<int>(counts[static_cast<int>(i)]);
    is_air_.resize(index({count_[0] - 1, count_[1] - 1, count_[2] - 1}) + 1);
    std::vector<Vec3f> row(static_cast<size_t>(count_[0]) * static_cast<size_t>(count_[2]));
    for (int y = 0; y < count_[1]; ++y) {
      size_t at = 0;
      for (int z = 0; z < count_[2]; ++z)
        for (int x = 0; x < count_[0]; ++x) row[at++] = Vec3f(centre({x, y, z}));
      const std::vector<float> values = field::sample(rock, row);
      for (size_t i = 0; i < values.size(); ++i)
        is_air_[index({0, y, 0}) + i] = values[i] > 0 ? kAir : kRock;
    }
  }

  const Cell& count() const { return count_; }
  Vec3d centre(const Cell& c) const {
    return {options_.region.min.x + (c[0] + 0.5) * options_.cell,
            options_.level - (c[1] + 0.5) * options_.cell,
            options_.region.min.z + (c[2] + 0.5) * options_.cell};
  }
  bool contains(const Cell& c) const {
    return c[0] >= 0 && c[0] < count_[0] && c[1] >= 0 && c[1] < count_[1] && c[2] >= 0 &&
           c[2] < count_[2];
  }
  bool is_air(const Cell& c) const { return is_air_[index(c)] != kRock; }
  bool is_wet(const Cell& c) const { return is_air_[index(c)] == kWet; }
  void wet(const Cell& c) { is_air_[index(c)] = kWet; }

  /// The cell in which water from a point begins.
  Cell source(const Vec3d& p) const {
    const double below = std::max(0.0, options_.level - p.y);
    const Cell c = {static_cast<int>(std::floor((p.x - options_.region.min.x) / options_.cell)),
                    static_cast<int>(std::floor(below / options_.cell)),
                    static_cast<int>(std::floor((p.z - options_.region.min.z) / options_.cell))};
    if (!contains(c))
      throw Error(
          ErrorCode::bad_input,
          fmt::format("the point ({:.4g}, {:.4g}, {:.4g}) of the water is outside the region", p.x,
                      p.y, p.z),
          {}, "choose a point between 'from' and 'to'");
    if (!is_air(c))
      throw Error(ErrorCode::bad_input,
                  fmt::format("there is rock where the water would be filled in, at ({:.4g}, "
                              "{:.4g}, {:.4g})",
                              p.x, std::min(p.y, options_.level), p.z),
                  {}, "choose a point over the deepest part of the hollow, or raise the level");
    return c;
  }

 private:
  static constexpr uint8_t kRock = 0, kAir = 1, kWet = 2;
  size_t index(const Cell& c) const {
    return (static_cast<size_t>(c[1]) * static_cast<size_t>(count_[2]) +
            static_cast<size_t>(c[2])) *
               static_cast<size_t>(count_[0]) +
           static_cast<size_t>(c[0]);
  }

  const FillOptions& options_;
  Cell count_{};
  std::vector<uint8_t> is_air_;
};

/// Fills the cells that the water reaches, the nearest first. Returns the first one from which it
/// leaves the region.
std::optional<Cell> spread(CellGrid& grid, const std::vector<Vec3d>& from) {
  std::vector<Cell> reached;
  const auto reach = [&](const Cell& c) {
    if (grid.is_wet(c) || !grid.is_air(c)) return;
    grid.wet(c);
    reached.push_back(c);
  };
  for (const Vec3d& p : from) reach(grid.source(p));
  std::optional<Cell> leak;
  for (size_t i = 0; i < reached.size(); ++i)
    for (const Cell& step : {Cell{1, 0, 0}, Cell{-1, 0, 0}, Cell{0, 1, 0}, Cell{0, -1, 0},
                             Cell{0, 0, 1}, Cell{0, 0, -1}}) {
      const Cell c = reached[i];
      const Cell next = {c[0] + step[0], c[1] + step[1], c[2] + step[2]};
      if (grid.contains(next))
        reach(next);
      else if (next[1] >= 0 && !leak)
        leak = c;
    }
  return leak;
}

/// Runs of wet cells of a column, first and last y.
std::vector<std::array<int, 2>> runs_of(const CellGrid& grid, int x, int z) {
  std::vector<std::array<int, 2>> runs;
  for (int y = 0; y < grid.count()[1]; ++y) {
    if (!grid.is_wet({x, y, z})) continue;
    if (runs.empty() || runs.back()[1] != y - 1) runs.push_back({y, y});
    runs.back()[1] = y;
  }
  return runs;
}

std::vector<Polytope> boxes_of(const CellGrid& grid, const FillOptions& options) {
  const double half = 0.5 * options.cell, overlap = kOverlapInCells * options.cell;
  std::vector<Polytope> boxes;
  const auto add = [&](int z, int first, int last, const std::array<int, 2>& run) {
    Box3d box(grid.centre({first, run[1], z}) - Vec3d(half),
              grid.centre({last, run[0], z}) + Vec3d(half));
    box = grown(box, overlap);
    box.max.y = std::min(box.max.y, options.level);
    boxes.push_back({{}, box});
  };
  for (int z = 0; z < grid.count()[2]; ++z) {
    std::vector<std::array<int, 2>> open;  // Equal runs since the column `first`.
    int first = 0;
    for (int x = 0; x <= grid.count()[0]; ++x) {
      std::vector<std::array<int, 2>> runs;
      if (x < grid.count()[0]) runs = runs_of(grid, x, z);
      if (x > 0 && runs == open) continue;
      for (const std::array<int, 2>& run : open) add(z, first, x - 1, run);
      open = runs;
      first = x;
    }
  }
  return boxes;
}

}  // namespace

std::vector<Polytope> filled_hollow(const field::Field& rock, const FillOptions& options) {
  CellGrid grid(rock, options);
  const std::optional<Cell> leak = spread(grid, options.at);
  if (leak && !options.cut) {
    const Vec3d p = grid.centre(*leak);
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the water leaks out of the region at ({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z),
        {},
        fmt::format("lower the level below {:g} m, close the rock there, enlarge the "
                    "region, or set 'cut' to end the water at its faces",
                    options.level));
  }
  return boxes_of(grid, options);
}

field::Field fill_body(const field::Field& rock, const FillOptions& options) {
  field::Traits traits;
  traits.exactness = field::Exactness::bound;
  traits.growth = 1 / std::sqrt(3.0);
  traits.bounds = grown(options.region, (kOverlapInCells + 1) * options.cell);
  traits.bounds.max.y = std::min(traits.bounds.max.y, options.level);
  return field::deferred(
      std::move(traits), {"filling in water"},
      [](const field::Field& solid, const FillOptions& how) {
        return polytopes("fill", filled_hollow(solid, how));
      },
      rock, options);
}

}  // namespace vug::passages
