// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/mesh/box_tree.h>
#include <vug/mesh/hausdorff.h>
#include <vug/mesh/triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vug::mesh {
namespace {

using Corners = std::array<Vec3d, 3>;

double larger(double a, double b) { return std::max(a, b); }

/// The surface from which distances are measured.
class Target {
 public:
  explicit Target(const Mesh& mesh) : mesh_(mesh) {
    std::vector<Box3d> boxes(mesh.triangles.size());
    for (size_t face = 0; face < boxes.size(); ++face)
      for (const Vec3d& p : corners(mesh, face)) boxes[face].extendBy(p);
    tree_ = BoxTree(boxes);
  }

  struct Nearest {
    uint32_t face = 0;
    double distance = 0;
  };
  /// `guess`: a triangle that may be near.
  Nearest nearest(const Vec3d& p, uint32_t guess) const {
    uint32_t face = guess;
    double best = squared_distance_of(p, guess);
    tree_.visit_nearest(p, best, [&](uint32_t candidate) {
      const double squared = squared_distance_of(p, candidate);
      if (squared < best || (squared == best && candidate < face)) {
        best = squared;
        face = candidate;
      }
      return best;
    });
    return {face, std::sqrt(best)};
  }
  /// The largest distance of a point of the triangle from a face, which is at a corner, and the
  /// number of that corner.
  std::pair<double, size_t> farthest_from_face(const Corners& triangle, uint32_t face) const {
    double most = -1;
    size_t corner = 0;
    for (size_t k = 0; k < 3; ++k) {
      const double squared = squared_distance_of(triangle[k], face);
      if (squared > most) corner = k;
      most = std::max(most, squared);
    }
    return {std::sqrt(most), corner};
  }

  /// A bound of the distances of the points of the triangle from two faces. The plane through the
  /// common edge divides the triangle, and each part is as far from its face as one of its corners.
  /// Infinite for faces without a common edge.
  double farthest_from_pair(const Corners& triangle, uint32_t face, uint32_t other) const {
    size_t opposite = 3;  // The corner of the face that is not on the edge.
    size_t common = 0;
    const Triangle &one = mesh_.triangles[face], &two = mesh_.triangles[other];
    for (size_t k = 0; k < 3; ++k)
      if (std::find(two.begin(), two.end(), one[k]) != two.end())
        ++common;
      else
        opposite = k;
    if (common != 2) return kInfinity;
    const Corners on = corners(mesh_, face);
    const Vec3d &a = on[(opposite + 1) % 3], &b = on[(opposite + 2) % 3];
    Vec3d across =
        (b - a).cross(double_area_vector(mesh_, face) + double_area_vector(mesh_, other));
    if (across.dot(on[opposite] - a) < 0) across = -across;
    std::array<double, 3> sides{};
    for (size_t k = 0; k < 3; ++k) sides[k] = across.dot(triangle[k] - a);
    double most = 0;
    const auto add = [&](const Vec3d& p, uint32_t to) {
      most = std::max(most, squared_distance_of(p, to));
    };
    for (size_t k = 0; k < 3; ++k) {
      add(triangle[k], sides[k] >= 0 ? face : other);
      const double here = sides[k], there = sides[(k + 1) % 3];
      if ((here >= 0) == (there >= 0)) continue;
      const Vec3d p = triangle[k] + (triangle[(k + 1) % 3] - triangle[k]) * (here / (here - there));
      add(p, face);
      add(p, other);
    }
    return std::sqrt(most);
  }

 private:
  double squared_distance_of(const Vec3d& p, uint32_t face) const {
    return (nearest_on_triangle(p, corners(mesh_, face)).point - p).length2();
  }

  const Mesh& mesh_;
  BoxTree tree_;
};

/// Bounds the distance of the points of one triangle from the target, by branch and bound.
class TriangleBound {
 public:
  /// Points nearer than `known` do not matter.
  TriangleBound(const Target& target, double known) : target_(target), least_(known) {}

  /// `nearest`: triangles of the target that are near to the corners.
  double of(const Corners& triangle, const std::array<uint32_t, 3>& nearest) {
    examine({triangle, nearest, kInfinity});
    constexpr int kMostPieces = 1 << 12;
    for (int split = 0; !open_.empty(); ++split) {
      std::pop_heap(open_.begin(), open_.end(), is_nearer);
      const Piece piece = open_.back();
      open_.pop_back();
      // No other piece is farther.
      if (piece.upper <= limit() || split == kMostPieces) return std::max(most_, piece.upper);
      divide(piece);
    }
    return most_;
  }

 private:
  struct Piece {
    Corners corners;
    std::array<uint32_t, 3> candidates;  ///< Triangles of the target that may be near.
    double upper;                        ///< No point of the piece is farther from the target.
  };
  static bool is_nearer(const Piece& a, const Piece& b) { return a.upper < b.upper; }

  void examine(Piece piece) {
    const Corners& p = piece.corners;
    const auto is_near = [&](double upper) {
      piece.upper = std::min(piece.upper, upper);
      if (piece.upper > limit()) return false;
      most_ = std::max(most_, piece.upper);
      return true;
    };
    for (const uint32_t face : piece.candidates)
      if (is_near(target_.farthest_from_face(p, face).first)) return;
    const Vec3d centre = (p[0] + p[1] + p[2]) / 3;
    const Target::Nearest here = target_.nearest(centre, piece.candidates[0]);
    least_ = std::max(least_, here.distance);
    double radius = 0;
    for (const Vec3d& corner : p) radius = std::max(radius, (corner - centre).length2());
    if (is_near(here.distance + std::sqrt(radius))) return;
    const auto [upper, corner] = target_.farthest_from_face(p, here.face);
    if (is_near(upper)) return;
    const Target::Nearest beyond = target_.nearest(p[corner], here.face);
    least_ = std::max(least_, beyond.distance);
    if (is_near(target_.farthest_from_pair(p, here.face, beyond.face))) return;
    piece.candidates = {here.face, beyond.face, piece.candidates[0]};
    open_.push_back(piece);
    std::push_heap(open_.begin(), open_.end(), is_nearer);
  }

  void divide(const Piece& piece) {
    const Corners& p = piece.corners;
    Corners middles;
    for (size_t k = 0; k < 3; ++k) middles[k] = (p[k] + p[(k + 1) % 3]) * 0.5;
    examine({middles, piece.candidates, piece.upper});
    for (size_t k = 0; k < 3; ++k)
      examine({{p[k], middles[k], middles[(k + 2) % 3]}, piece.candidates, piece.upper});
  }

  double limit() const { return least_ * (1 + kTolerance); }

  static constexpr double kTolerance = 1.0 / 64;
  const Target& target_;
  double least_;     ///< Points nearer than this do not matter.
  double most_ = 0;  ///< No point of the accepted pieces is farther.
  std::vector<Piece> open_;
};

/// The triangles of the target that are nearest to the vertices of a mesh.
std::vector<Target::Nearest> nearest_to_vertices(const Mesh& from, const Target& to) {
  std::vector<Target::Nearest> out(from.positions.size());
  parallel_for(
      out.size(), [&](size_t v) { out[v] = to.nearest(Vec3d(from.positions[v]), 0); }, 256);
  return out;
}

/// The largest distance of a vertex of a triangle.
double farthest_vertex(const Mesh& from, const std::vector<Target::Nearest>& at) {
  double out = 0;
  for (const Triangle& face : from.triangles)
    for (const uint32_t v : face) out = std::max(out, at[v].distance);
  return out;
}

/// At least the largest distance of a point of the mesh from the target, or little more than
/// `known`.
double one_sided_bound(const Mesh& from, const Target& to, const std::vector<Target::Nearest>& at,
                       double known) {
  return ordered_reduce(
      from.triangles.size(), known,
      [&](size_t face) {
        const Triangle& t = from.triangles[face];
        return TriangleBound(to, known).of(corners(from, face),
                                           {at[t[0]].face, at[t[1]].face, at[t[2]].face});
      },
      larger, 256);
}

double mean_edge(const Mesh& mesh) {
  const double sum = ordered_sum(mesh.triangles.size(), 0.0, [&](size_t face) {
    const auto [a, b, c] = corners(mesh, face);
    return (b - a).length() + (c - b).length() + (a - c).length();
  });
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

double hausdorff_bound(const Mesh& a, const Mesh& b) {
  if (a.triangles.empty() || b.triangles.empty()) return 0;
  constexpr double kNegligible = 1.0 / 64, kRounding = 1e-14;
  const double resolution = kNegligible * std::min(mean_edge(a), mean_edge(b));
  Box3d box = bounds(a);
  box.extendBy(bounds(b));
  double farthest = 0;  // From the origin, along an axis.
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::fabs(box.min[axis]), std::fabs(box.max[axis])});
  const Target to_a(a), to_b(b);
  const auto from_a = nearest_to_vertices(a, to_b), from_b = nearest_to_vertices(b, to_a);
  const double known =
      std::max({resolution, farthest_vertex(a, from_a), farthest_vertex(b, from_b)});
  const double bound =
      std::max(one_sided_bound(a, to_b, from_a, known), one_sided_bound(b, to_a, from_b, known));
  return bound * (1 + kRounding) + farthest * kRounding;
}

}  // namespace vug::mesh
