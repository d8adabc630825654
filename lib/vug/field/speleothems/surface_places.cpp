// SPDX-License-Identifier: Apache-2.0
// Each cell of a lattice has a random point, which moves onto the surface along the gradient. It is
// a place if it ends in its own cell, so that every part of the surface has the same chance, and if
// no place of a higher random rank is close.
#include <vug/base/cell.h>
#include <vug/base/frames.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/field/box_fault.h>
#include <vug/field/speleothems/surface_places.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kMostPlaces = 4e6;
constexpr double kApart = 0.7;      // The least distance between two places, in spacings.
constexpr double kCellSide = 0.58;  // In spacings: calibrated for one place per spacing^2.
constexpr int64_t kBlock = 32;      // Cells along the edge of a block, a power of two.
constexpr int kNewtonSteps = 12;

struct PlaceCandidate {
  SurfacePlace place;
  uint32_t rank = 0;
};

class PlaceSearch {
 public:
  explicit PlaceSearch(const SurfaceScatter& scatter)
      : scatter_(scatter),
        side_(kCellSide * scatter.spacing),
        key_(RandomKey(static_cast<uint64_t>(scatter.seed)).at("surface places")) {}

  double side() const { return side_; }

  /// Appends the candidates of a block of `edge` cells along each axis, in order.
  void descend(const Field& rock, const Cell& low, int64_t edge,
               std::vector<PlaceCandidate>& out) const {
    const Vec3d corner(static_cast<double>(low[0]), static_cast<double>(low[1]),
                       static_cast<double>(low[2]));
    const Box3d box(corner * side_, (corner + Vec3d(static_cast<double>(edge))) * side_);
    if (!box.intersects(Box3d(scatter_.from, scatter_.to))) return;
    const double radius = 0.5 * box.size().length();
    // The point of a cell can come from a surface in a neighbour, but it ends in its own.
    if (!(std::fabs(rock.value(box.center())) <= rock.lipschitz() * radius * (1 + 1e-9))) return;
    if (edge == 1) return add(rock, low, box, out);
    const int64_t half = edge / 2;
    const Field near = edge == kBlock ? rock.restricted({box.center(), 2 * radius}).field : rock;
    for (int64_t i = 0; i < 8; ++i)
      descend(near,
              {low[0] + half * (i & 1), low[1] + half * (i >> 1 & 1), low[2] + half * (i >> 2)},
              half, out);
  }

 private:
  void add(const Field& rock, const Cell& cell, const Box3d& box,
           std::vector<PlaceCandidate>& out) const {
    RandomStream random(key_.at(static_cast<uint64_t>(cell[0]))
                            .at(static_cast<uint64_t>(cell[1]))
                            .at(static_cast<uint64_t>(cell[2])));
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    Vec3d p = box.min + Vec3d(x, y, z) * side_;
    const Box3d near = grown(box, 2 * side_);
    Gradient g = rock.gradient(p);
    for (int i = 0; i < kNewtonSteps && std::fabs(g.value) > 1e-7 * side_; ++i) {
      const double square = g.gradient.length2();
      if (!(square > 1e-12)) return;
      p -= g.gradient * (g.value / square);
      if (!near.intersects(p)) return;
      g = rock.gradient(p);
    }
    if (!(std::fabs(g.value) <= 1e-4 * side_) || !(g.gradient.length2() > 1e-12)) return;
    const auto contains = [](const Box3d& b, const Vec3d& q) {  // Half-open.
      return q.x >= b.min.x && q.y >= b.min.y && q.z >= b.min.z && q.x < b.max.x && q.y < b.max.y &&
             q.z < b.max.z;
    };
    if (!contains(box, p) || !contains(Box3d(scatter_.from, scatter_.to), p)) return;
    const double chance = random.uniform();
    const uint32_t rank = random.bits();
    if (scatter_.where && !(chance < 0.5 + 0.5 * scatter_.where->field.value(p))) return;
    const RandomKey key(uint64_t{random.bits()} << 32 | random.bits());
    out.push_back({{p, g.gradient.normalized(), key}, rank});
  }

  const SurfaceScatter& scatter_;
  double side_;
  RandomKey key_;
};

/// Removes candidates that are close to one of a higher rank, from the highest rank down.
std::vector<SurfacePlace> thinned(const std::vector<PlaceCandidate>& all, double apart) {
  std::vector<size_t> order(all.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return all[a].rank != all[b].rank ? all[a].rank > all[b].rank : a < b;
  });
  CellMap<std::vector<size_t>> grid;
  std::vector<char> kept(all.size());
  for (const size_t i : order) {
    const Vec3d& p = all[i].place.at;
    const Cell cell = cell_at(p, apart);
    bool free = true;
    for_each_cell({cell[0] - 1, cell[1] - 1, cell[2] - 1}, {cell[0] + 1, cell[1] + 1, cell[2] + 1},
                  [&](const Cell& c) {
                    const auto found = grid.find(c);
                    if (found == grid.end()) return;
                    for (const size_t j : found->second)
                      free = free && (all[j].place.at - p).length2() >= apart * apart;
                  });
    if (!free) continue;
    kept[i] = 1;
    grid[cell].push_back(i);
  }
  std::vector<SurfacePlace> out;
  for (size_t i = 0; i < all.size(); ++i)
    if (kept[i]) out.push_back(all[i].place);
  return out;
}

}  // namespace

std::string SurfaceScatter::fault() const {
  if (const std::string fault = box_fault(from, to); !fault.empty()) return fault;
  if (!(most_places() <= kMostPlaces))
    return fmt::format(
        "a box of this size can have {:.0f} million places with this spacing, the limit is {:.0f} "
        "million; use a smaller box or a larger spacing",
        1e-6 * most_places(), 1e-6 * kMostPlaces);
  return "";
}

double SurfaceScatter::most_places() const {
  const Vec3d size = to - from;
  const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return area / (spacing * spacing);
}

std::vector<SurfacePlace> find_surface_places(const SurfaceScatter& scatter) {
  const PlaceSearch search(scatter);
  const double block = search.side() * static_cast<double>(kBlock);
  std::vector<Cell> blocks;
  for_each_cell(cell_at(scatter.from, block), cell_at(scatter.to, block),
                [&](const Cell& c) { blocks.push_back(c); });
  std::vector<std::vector<PlaceCandidate>> found(blocks.size());
  parallel_for(blocks.size(), [&](size_t i) {
    const Cell& c = blocks[i];
    search.descend(scatter.field, {c[0] * kBlock, c[1] * kBlock, c[2] * kBlock}, kBlock, found[i]);
  });
  std::vector<PlaceCandidate> all;
  for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
  return thinned(all, kApart * scatter.spacing);
}

double log_uniform(RandomStream& random, double deviation) {
  constexpr double kHalfWidth = 1.7320508075688772;  // Of a uniform distribution of deviation 1.
  return maths::exp(kHalfWidth * deviation * (2 * random.uniform() - 1));
}

std::array<Vec3d, 2> tangents(const Vec3d& normal) {
  const Frame frame = level_frame(normal);
  return {frame.normal, frame.binormal};
}

Vec3d tilted(const Vec3d& normal, double angle, double turn) {
  const auto [u, v] = tangents(normal);
  return normal * maths::cos(angle) +
         (u * maths::cos(turn) + v * maths::sin(turn)) * maths::sin(angle);
}

double exposure(const Field& rock, const SurfacePlace& place, double size) {
  constexpr double kSlant = 0.70710678118654752;
  double sum = 0;
  for (const Vec3d& t : tangents(place.normal))
    for (const double side : {-1.0, 1.0})
      sum += rock.value(place.at + (place.normal + t * side) * (kSlant * size));
  // A plane is kSlant * size away from all four points, a needle about `size`.
  const double mean = sum / (4 * kSlant * size) - 1;
  return std::clamp(mean / (mean > 0 ? 1 / kSlant - 1 : 1), -1.0, 1.0);
}

}  // namespace vug::field
