// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/transform.h>
#include <vug/mesh/stones/stone_shape.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

constexpr int kDirections = 96;
constexpr double kNearCorners = 0.02;  // Of the radius; of nearer corners one is left out.
constexpr double kProbeSpacing = 0.2;  // Of the radius.

/// The directions of a spherical Fibonacci lattice, which cover the sphere evenly.
Vec3d direction(int i) {
  const double y = 1 - (2 * i + 1) / static_cast<double>(kDirections);
  const double across = std::sqrt(1 - y * y), turn = i * kPi * (3 - std::sqrt(5.0));
  return {across * maths::cos(turn), y, across * maths::sin(turn)};
}

/// Six times the volume and, weighted with it, four times the centre of the tetrahedra between the
/// faces and the origin.
std::pair<double, Vec3d> volume_and_moment(const Mesh& mesh) {
  double volume = 0;
  Vec3d moment(0.0);
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = corners(mesh, i);
    const double v = a.dot(b.cross(c));
    volume += v;
    moment += (a + b + c) * v;
  }
  return {volume, moment};
}

std::vector<Vec3d> outermost(const Mesh& mesh, const Vec3d& centre) {
  std::vector<Vec3d> found;
  double radius = 0;
  for (int i = 0; i < kDirections; ++i) {
    const Vec3d d = direction(i);
    Vec3d best(0.0);
    double most = -kInfinity;
    for (const Vec3f& p : mesh.positions) {
      const double reach = d.dot(Vec3d(p) - centre);
      if (reach <= most) continue;
      most = reach;
      best = Vec3d(p) - centre;
    }
    found.push_back(best);
    radius = std::max(radius, best.length());
  }
  std::vector<Vec3d> kept;
  for (const Vec3d& p : found)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Vec3d& q) { return (p - q).length() < kNearCorners * radius; }))
      kept.push_back(p);
  return kept;
}

/// The planes through three corners that have all corners on one side, each once.
std::vector<StoneShape::Face> hull_faces(const std::vector<Vec3d>& corners, double radius) {
  std::vector<StoneShape::Face> faces;
  const double slack = 1e-9 * radius;
  for (size_t i = 0; i < corners.size(); ++i)
    for (size_t j = i + 1; j < corners.size(); ++j)
      for (size_t k = j + 1; k < corners.size(); ++k) {
        Vec3d normal = (corners[j] - corners[i]).cross(corners[k] - corners[i]);
        if (normal.length() < 1e-6 * radius * radius) continue;
        normal.normalize();
        double offset = normal.dot(corners[i]);
        if (offset < 0) normal = -normal, offset = -offset;
        if (std::any_of(corners.begin(), corners.end(),
                        [&](const Vec3d& p) { return normal.dot(p) > offset + slack; }))
          continue;
        if (std::none_of(faces.begin(), faces.end(), [&](const StoneShape::Face& f) {
              return f.outward.dot(normal) > 1 - 1e-9;
            }))
          faces.push_back({normal, offset});
      }
  return faces;
}

/// The corners and, where they are far apart, points of the surface in even directions.
std::vector<Vec3d> probes_of(const StoneShape& shape) {
  std::vector<Vec3d> probes = shape.corners;
  for (int i = 0; i < kDirections; ++i) {
    double nearest = kInfinity;
    for (const StoneShape::Face& face : shape.faces)
      if (const double rate = face.outward.dot(direction(i)); rate > 0)
        nearest = std::min(nearest, face.offset / rate);
    const Vec3d p = direction(i) * nearest;
    if (std::none_of(probes.begin(), probes.end(), [&](const Vec3d& q) {
          return (p - q).length() < kProbeSpacing * shape.radius;
        }))
      probes.push_back(p);
  }
  return probes;
}

}  // namespace

StoneShape stone_shape(const Mesh& mesh) {
  const auto [volume, moment] = volume_and_moment(mesh);
  if (!(volume > 0))
    throw Error(ErrorCode::bad_input, "a stone must be a closed mesh that encloses a volume", {},
                "use the mesh of a level set, or check the file with 'vug measure'");
  StoneShape shape;
  shape.centre = moment / (4 * volume);
  shape.diameter = maths::pow(volume / kPi, 1.0 / 3);  // volume: six times that of the mesh
  shape.corners = outermost(mesh, shape.centre);
  for (const Vec3d& p : shape.corners) shape.radius = std::max(shape.radius, p.length());
  shape.faces = hull_faces(shape.corners, shape.radius);
  shape.probes = probes_of(shape);
  return shape;
}

StonePose StonePose::turned(const Vec3d& rotation) const {
  StonePose out = *this;
  const double angle = rotation.length();
  if (!(angle > 0)) return out;
  const Transform by = Transform::rotation(rotation, angle);
  out.x = by.vector(x).normalized();
  out.y = by.vector(y);
  out.z = out.x.cross(out.y).normalized();
  out.y = out.z.cross(out.x);
  return out;
}

std::optional<Heights> heights_at(const StoneShape& shape, const StonePose& pose, double x,
                                  double z) {
  const double reach = shape.radius * pose.scale;
  if ((x - pose.centre.x) * (x - pose.centre.x) + (z - pose.centre.z) * (z - pose.centre.z) >
      reach * reach)
    return std::nullopt;
  const Vec3d across((x - pose.centre.x) / pose.scale, 0, (z - pose.centre.z) / pose.scale);
  const Vec3d from(pose.x.dot(across), pose.y.dot(across), pose.z.dot(across));
  const Vec3d up(pose.x.y, pose.y.y, pose.z.y);
  double low = -kInfinity, high = kInfinity;
  for (const StoneShape::Face& face : shape.faces) {
    const double rate = face.outward.dot(up), room = face.offset - face.outward.dot(from);
    if (rate > 0)
      high = std::min(high, room / rate);
    else if (rate < 0)
      low = std::max(low, room / rate);
    else if (room < 0)
      return std::nullopt;
    if (low > high) return std::nullopt;
  }
  return Heights{pose.centre.y + pose.scale * low, pose.centre.y + pose.scale * high};
}

}  // namespace vug::mesh
