// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/stones/stone_ground.h>

#include <algorithm>
#include <optional>

namespace vug::mesh {
namespace {

/// The height of a triangle at a point of the plan; nothing outside it and if it is vertical.
std::optional<double> height_of(const GroundPatch::Face& face, double x, double z) {
  const auto& [a, b, c] = face.corners;
  const double whole = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  if (whole == 0) return std::nullopt;
  const double v = ((x - a.x) * (c.z - a.z) - (z - a.z) * (c.x - a.x)) / whole;
  const double w = ((b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x)) / whole;
  // A little wider, so that no point falls between two triangles.
  constexpr double kSlack = 1e-9;
  if (v < -kSlack || w < -kSlack || v + w > 1 + kSlack) return std::nullopt;
  return a.y + v * (b.y - a.y) + w * (c.y - a.y);
}

}  // namespace

double GroundPatch::floor(double x, double z) const {
  double highest = -kInfinity;
  for (const Face& face : faces_)
    if (face.across.y > 0)
      if (const std::optional<double> y = height_of(face, x, z)) highest = std::max(highest, *y);
  return highest;
}

double GroundPatch::roof(double x, double z, double from) const {
  double lowest = kInfinity;
  for (const Face& face : faces_)
    if (face.across.y < 0)
      if (const std::optional<double> y = height_of(face, x, z); y && *y > from)
        lowest = std::min(lowest, *y);
  return lowest;
}

Vec3d GroundPatch::mean_up() const {
  Vec3d sum(0.0);
  for (const Face& face : faces_)
    if (face.across.y > 0) sum += face.across;
  return sum.length() > 0 ? sum.normalized() : Vec3d(0, 1, 0);
}

StoneGround::StoneGround(const Mesh& mesh) : mesh_(mesh) {
  std::vector<Box3d> boxes(mesh.triangles.size());
  for (size_t i = 0; i < boxes.size(); ++i)
    for (const Vec3d& p : corners(mesh, i)) boxes[i].extendBy(p);
  tree_ = BoxTree(boxes);
}

GroundPatch StoneGround::patch(const Box3d& box) const {
  std::vector<GroundPatch::Face> faces;
  std::vector<uint32_t> vertices;
  tree_.visit_overlapping(box, [&](uint32_t i) {
    Box3d own;
    const std::array<Vec3d, 3> at = corners(mesh_, i);
    for (const Vec3d& p : at) own.extendBy(p);
    if (!own.intersects(box)) return;
    faces.push_back({at, double_area_vector(mesh_, i)});
    if (faces.back().across.y > 0)
      vertices.insert(vertices.end(), mesh_.triangles[i].begin(), mesh_.triangles[i].end());
  });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Vec3d> points;
  for (const uint32_t v : vertices) points.emplace_back(mesh_.positions[v]);
  return {std::move(faces), std::move(points)};
}

}  // namespace vug::mesh
