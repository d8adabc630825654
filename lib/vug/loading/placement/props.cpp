// SPDX-License-Identifier: Apache-2.0
// Props in mid-air: they touch nothing, but there is ground below them.
#include <vug/loading/placement/checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

/// Vertices of a mesh that are checked at most; they are spread over all.
constexpr size_t kMostVertices = 400;
/// Gaps below this are not visible.
constexpr double kGap = 0.02;
/// The ground is searched down to this distance, in steps of at least this length.
constexpr double kDeepest = 100, kGroundStep = 0.01;
/// A piece is a prop if the ground is larger than it by this factor.
constexpr double kLarger = 2;

Box3d bounds_of(const SetPiece& piece) {
  Box3d box;
  for (const Solid& solid : piece.solids) box = united(box, solid.box);
  return box;
}

/// Points at the surface: vertices of meshes, points of the boxes of fields.
std::vector<Vec3d> surface_points(const SetPiece& piece) {
  std::vector<Vec3d> points;
  for (const Solid& solid : piece.solids) {
    if (solid.mesh) {
      const auto& vertices = solid.mesh->positions;
      const size_t step = vertices.size() / kMostVertices + 1;
      for (size_t i = 0; i < vertices.size(); i += step)
        points.push_back(solid.to_scene.point(Vec3d(vertices[i])));
      if (const auto lowest = std::min_element(vertices.begin(), vertices.end(),
                                               [&](const Vec3f& a, const Vec3f& b) {
                                                 return solid.to_scene.point(Vec3d(a)).y <
                                                        solid.to_scene.point(Vec3d(b)).y;
                                               });
          lowest != vertices.end())
        points.push_back(solid.to_scene.point(Vec3d(*lowest)));
      continue;
    }
    constexpr int kEdge = 5;
    const Box3d box = solid.field.bounds();
    for (int i = 0; i < kEdge * kEdge * kEdge; ++i) {
      const int x = i % kEdge, y = i / kEdge % kEdge, z = i / kEdge / kEdge, last = kEdge - 1;
      const bool inner = x > 0 && x < last && y > 0 && y < last && z > 0 && z < last;
      if (!inner)
        points.push_back(
            solid.to_scene.point(box.min + box.size() * Vec3d(x, y, z) * (1.0 / last)));
    }
  }
  return points;
}

/// The piece and its box, and the points at which it may touch others.
struct Prop {
  const SetPiece* piece;
  Box3d box;
  std::vector<Vec3d> points;
};

bool touches(const Prop& prop, const Solid& solid, Accuracy accuracy) {
  return solid.box.intersects(grown(prop.box, kGap)) &&
         std::any_of(prop.points.begin(), prop.points.end(),
                     [&](const Vec3d& p) { return !solid.is_farther(p, kGap, accuracy); });
}

/// The height of the highest surface of the solid below `p`; nothing if there is none.
std::optional<double> ground_below(const Solid& solid, const Vec3d& p, Accuracy accuracy) {
  if (solid.mesh) {
    std::optional<double> highest;
    for (size_t face = 0; face < solid.mesh->triangles.size(); ++face) {
      auto [a, b, c] = mesh::corners(*solid.mesh, face);
      a = solid.to_scene.point(a), b = solid.to_scene.point(b), c = solid.to_scene.point(c);
      const auto side = [&](const Vec3d& u, const Vec3d& v) {
        return (u.x - p.x) * (v.z - p.z) - (u.z - p.z) * (v.x - p.x);
      };
      const double wa = side(b, c), wb = side(c, a), wc = side(a, b), sum = wa + wb + wc;
      const bool hit = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
      if (!hit || sum == 0) continue;
      const double y = (wa * a.y + wb * b.y + wc * c.y) / sum;
      if (y < p.y && (!highest || y > *highest)) highest = y;
    }
    return highest;
  }
  const double low = std::max(solid.box.min.y, p.y - kDeepest);
  for (double y = p.y; y > low; y -= kGroundStep)
    if (solid.depth({p.x, y, p.z}, accuracy) > 0) return y;
  return std::nullopt;
}

/// The foot of a prop: the middle of the bottom of its box.
Vec3d foot_of(const Box3d& box) { return {box.center().x, box.min.y, box.center().z}; }

/// Whether the solid is large and low enough to be the ground below a piece with this box.
bool may_be_ground(const Solid& solid, const Box3d& piece) {
  const Vec3d foot = foot_of(piece);
  const Box3d& box = solid.box;
  return box.min.x <= foot.x && foot.x <= box.max.x && box.min.z <= foot.z && foot.z <= box.max.z &&
         box.min.y < foot.y && box.size().length() > kLarger * piece.size().length();
}

struct Ground {
  std::string name;
  double height;
};

/// Calls `visit` for the solids of all other pieces.
template <class Visit>
void visit_others(const Set& set, const SetPiece& piece, const Visit& visit) {
  for (const SetPiece& other : set.pieces)
    if (&other != &piece)
      for (const Solid& solid : other.solids) visit(solid);
}

std::optional<Ground> ground_of(const Prop& prop, const Set& set, Accuracy accuracy) {
  std::optional<Ground> ground;
  visit_others(set, *prop.piece, [&](const Solid& solid) {
    if (!may_be_ground(solid, prop.box)) return;
    const auto height = ground_below(solid, foot_of(prop.box), accuracy);
    if (height && (!ground || *height > ground->height)) ground = Ground{solid.name, *height};
  });
  return ground;
}

/// Whether the piece may be a prop: its box is known, it neither shines nor has lights,
/// and there may be ground below it. The cords of lamps are rarely modelled.
bool may_be_prop(const SetPiece& piece, const Box3d& box, const Set& set) {
  if (piece.floating || !is_finite(box) ||
      std::any_of(piece.solids.begin(), piece.solids.end(),
                  [](const Solid& solid) { return solid.shines; }))
    return false;
  bool found = false;
  visit_others(set, piece, [&](const Solid& solid) { found = found || may_be_ground(solid, box); });
  return found;
}

/// The ground below a prop that touches nothing; nothing for other pieces.
std::optional<Ground> ground_far_below(const Prop& prop, const Set& set, Accuracy accuracy) {
  bool held = false;
  visit_others(set, *prop.piece,
               [&](const Solid& solid) { held = held || touches(prop, solid, accuracy); });
  return held ? std::nullopt : ground_of(prop, set, accuracy);
}

}  // namespace

void check_props(const Set& set, Accuracy accuracy, Diagnostics& diagnostics) {
  for (const SetPiece& piece : set.pieces) {
    const Box3d box = bounds_of(piece);
    if (!may_be_prop(piece, box, set)) continue;
    const Prop prop{&piece, box, surface_points(piece)};
    std::optional<Ground> ground = ground_far_below(prop, set, accuracy);
    if (ground && accuracy == Accuracy::bounds)  // it may stand on a stalagmite
      ground = ground_far_below(prop, set, Accuracy::exact);
    if (!ground) continue;
    const double gap = box.min.y - ground->height;
    const std::string what =
        fmt::format("{} floats {:.2f} m above '{}': its foot is at {}", piece.name, gap,
                    ground->name, position_text(foot_of(box)));
    const std::string hint = fmt::format(
        "move it down by {:.2f} m, or write 'floating true' if it hangs there on purpose", gap);
    piece.modelled ? diagnostics.warning(piece.where, what, hint)
                   : diagnostics.error(piece.where, what, hint);
  }
}

}  // namespace vug::loading
