// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/breakdown/box_grid.h>
#include <vug/passages/breakdown/broken_block.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kTouch = 1e-5;       // Metres; blocks that are nearer touch.
constexpr double kLeastCut = 0.01;    // Metres; shallower cuts would not be visible.
constexpr double kDeepestCut = 0.66;  // By half of the smaller sides.
constexpr double kTilt = 0.25;        // Radians; most faces deviate less from the joints.
constexpr double kBrokenEdges = 0.5;  // Share of the edges; the others are as the joints made them.
constexpr double kBrokenCorners = 0.6;
constexpr double kTiltedFaces = 0.5;

struct Segment {
  Vec3d from, to;
};

std::vector<Vec3d> corners_of(const OrientedBox& box) {
  std::vector<Vec3d> out;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) out.push_back(box.corner(x, y, z));
  return out;
}

std::vector<Segment> edges_of(const OrientedBox& box) {
  std::vector<Segment> out;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      out.push_back({box.corner(-1, a, b), box.corner(1, a, b)});
      out.push_back({box.corner(a, -1, b), box.corner(a, 1, b)});
      out.push_back({box.corner(a, b, -1), box.corner(a, b, 1)});
    }
  return out;
}

bool is_inside(const OrientedBox& box, const Vec3d& p) {
  for (int i = 0; i < 3; ++i)
    if (std::fabs(box.axes[static_cast<size_t>(i)].dot(p - box.centre)) > box.half[i] + kTouch)
      return false;
  return true;
}

/// Appends the crossing of two edges if they touch.
void append_crossing(const Segment& a, const Segment& b, std::vector<Vec3d>& out) {
  const Vec3d u = a.to - a.from, v = b.to - b.from, w = a.from - b.from;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), det = uu * vv - uv * uv;
  if (!(det > 1e-9 * uu * vv)) return;  // Parallel edges touch at their corners.
  const double s = (uv * v.dot(w) - vv * u.dot(w)) / det;
  const double t = (uu * v.dot(w) - uv * u.dot(w)) / det;
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return;
  const Vec3d p = a.from + u * s;
  if ((p - (b.from + v * t)).length() < kTouch) out.push_back(p);
}

/// Collects the cuts of one block.
class Breaker {
 public:
  Breaker(const OrientedBox& block, const std::vector<Vec3d>& contacts)
      : block_(block), contacts_(contacts), out_(block.polytope()) {}

  /// Cuts off the part beyond a plane that lies `depth` metres inside of the outermost point in
  /// this direction of the block's axes, or less if a contact would be cut off.
  void cut(const Vec3d& direction, double depth) {
    const Vec3d normal =
        (block_.axes[0] * direction.x + block_.axes[1] * direction.y + block_.axes[2] * direction.z)
            .normalized();
    const double outermost = normal.dot(block_.centre) + block_.extent(normal);
    for (const Vec3d& p : contacts_) depth = std::min(depth, outermost - normal.dot(p));
    if (depth >= kLeastCut) out_.faces.push_back({normal, outermost - depth});
  }

  Polytope finish() { return std::move(out_); }

 private:
  const OrientedBox& block_;
  const std::vector<Vec3d>& contacts_;
  Polytope out_;
};

}  // namespace

std::vector<std::vector<Vec3d>> contact_points(const std::vector<OrientedBox>& blocks,
                                               double floor) {
  std::vector<std::vector<Vec3d>> out(blocks.size());
  double largest = 0.01;
  for (const OrientedBox& block : blocks) largest = std::max(largest, 2 * block.half.length());
  BoxGrid grid(largest);
  for (size_t i = 0; i < blocks.size(); ++i) {
    const OrientedBox& block = blocks[i];
    for (const Vec3d& corner : corners_of(block))
      if (corner.y < floor + kTouch) out[i].push_back(corner);
    grid.for_each_near(block, [&](const OrientedBox& other, size_t k) {
      if (overlap_depth(block, other) < -kTouch) return;
      std::vector<Vec3d> shared;
      for (const Vec3d& corner : corners_of(block))
        if (is_inside(other, corner)) shared.push_back(corner);
      for (const Vec3d& corner : corners_of(other))
        if (is_inside(block, corner)) shared.push_back(corner);
      for (const Segment& a : edges_of(block))
        for (const Segment& b : edges_of(other)) append_crossing(a, b, shared);
      for (const size_t each : {i, k})
        out[each].insert(out[each].end(), shared.begin(), shared.end());
    });
    grid.add(block);
  }
  return out;
}

Polytope broken_block(const OrientedBox& block, const std::vector<Vec3d>& contacts, double amount,
                      RandomStream random) {
  Breaker breaker(block, contacts);
  const Vec3d& half = block.half;
  // Shallow cuts are more frequent than deep ones.
  const auto depth = [&](double size) {
    const double share = random.uniform();
    return amount * kDeepestCut * size * share * share;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      Vec3d direction(0.0);
      direction[axis] = side;
      direction[second] = kTilt * random.normal();
      direction[third] = kTilt * random.normal();
      // The deepest cut leads through the middle of the face.
      const double wedge = (std::fabs(direction[second]) * half[second] +
                            std::fabs(direction[third]) * half[third]) /
                           direction.length();
      const double part = amount * random.uniform();
      if (random.uniform() < kTiltedFaces) breaker.cut(direction, part * wedge);
    }
    for (const double a : {-1.0, 1.0})
      for (const double b : {-1.0, 1.0}) {
        const double angle = random.uniform(0.4, 1.2);
        Vec3d direction(0.0);
        direction[axis] = 0.1 * random.normal();
        direction[second] = a * maths::cos(angle);
        direction[third] = b * maths::sin(angle);
        const double cut = depth(std::min(half[second], half[third]));
        if (random.uniform() < kBrokenEdges) breaker.cut(direction, cut);
      }
  }
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Vec3d direction(x * random.uniform(0.3, 1), y * random.uniform(0.3, 1),
                              z * random.uniform(0.3, 1));
        const double cut = 2 * depth(std::min({half.x, half.y, half.z}));
        if (random.uniform() < kBrokenCorners) breaker.cut(direction, cut);
      }
  return breaker.finish();
}

}  // namespace vug::passages
