// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/frames.h>

#include <cmath>

namespace vug::cells {
namespace {

constexpr Vec3f kUp(0, 1, 0);
/// Squared sine of the slope above which a cell's own level direction counts.
constexpr float kSlope = 0.1f;
constexpr int kEvening = 24;

Vec3f tangent(const Vec3f& v, const Vec3f& normal) { return v - normal * normal.dot(v); }

bool is_slope(const Vec3f& normal) { return kUp.cross(normal).length2() > kSlope; }

/// The x axis, or z if that is perpendicular to the plane.
Vec3f first_right(const Vec3f& normal) {
  const Vec3f x = tangent({1, 0, 0}, normal);
  return (x.length2() > 0.1f ? x : tangent({0, 0, 1}, normal)).normalized();
}

/// Slopes first, then ring by ring from there.
void spread(Network& n) {
  std::vector<uint32_t> queue;
  queue.reserve(n.size());
  std::vector<uint8_t> done(n.size(), 0);
  for (uint32_t i = 0; i < n.size(); ++i)
    if (is_slope(n.normal[i])) {
      n.right[i] = kUp.cross(n.normal[i]).normalized();
      done[i] = 1;
      queue.push_back(i);
    }
  size_t at = 0;
  for (uint32_t seed = 0; seed <= n.size(); ++seed) {
    for (; at < queue.size(); ++at) {
      const uint32_t from = queue[at];
      for (const uint32_t to : n.links.of(from)) {
        if (done[to]) continue;
        const Vec3f right = parallel_transport(n.right[from], n.normal[from], n.normal[to]);
        n.right[to] = tangent(right, n.normal[to]).normalized();
        done[to] = 1;
        queue.push_back(to);
      }
    }
    if (seed == n.size() || done[seed]) continue;
    n.right[seed] = first_right(n.normal[seed]);
    done[seed] = 1;
    queue.push_back(seed);
  }
}

}  // namespace

void orient(Network& n) {
  n.right.assign(n.size(), Vec3f(0));
  spread(n);
  std::vector<Vec3f> next = n.right;
  for (int round = 0; round < kEvening; ++round) {
    parallel_for(
        n.size(),
        [&](size_t i) {
          const auto cell = static_cast<uint32_t>(i);
          if (is_slope(n.normal[i])) return;
          Vec3f sum = n.right[i];
          for (const uint32_t to : n.links.of(cell))
            sum += parallel_transport(n.right[to], n.normal[to], n.normal[i]);
          const Vec3f flat = tangent(sum, n.normal[i]);
          if (flat.length2() > 1e-4f) next[i] = flat.normalized();
        },
        kCellGrain);
    n.right = next;
  }
}

std::optional<uint32_t> neighbour_toward(const Network& n, uint32_t cell, const Vec3f& direction) {
  const Vec3f flat = tangent(direction, n.normal[cell]);
  if (flat.length2() < 1e-6f * direction.length2()) return std::nullopt;
  const Vec3f wanted = flat.normalized();
  std::optional<uint32_t> best;
  float most = 0.5f;
  for (const uint32_t to : n.links.of(cell)) {
    const Vec3f d = tangent(n.position[to] - n.position[cell], n.normal[cell]).normalized();
    if (d.dot(wanted) > most) most = d.dot(wanted), best = to;
  }
  return best;
}

std::optional<uint32_t> neighbour_at(const Network& n, uint32_t cell, Side side) {
  const Vec3f up = ahead(n, cell);
  switch (side) {
    case Side::right:
      return neighbour_toward(n, cell, n.right[cell]);
    case Side::up:
      return neighbour_toward(n, cell, up);
    case Side::left:
      return neighbour_toward(n, cell, -n.right[cell]);
    default:
      return neighbour_toward(n, cell, -up);
  }
}

}  // namespace vug::cells
