// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/flora/profile.h>
#include <vug/flora/sweep_mesh.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

/// Attribute values of a row in the order of stem_attributes(); the last attribute varies within a
/// row and is not included.
using RowValues = std::array<double, 9>;

RowValues values_of(const Tube& tube, const ProfileRow& row, double age) {
  const std::vector<DisplacedNode>& nodes = tube.displacement().nodes();
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), row.along,
                                     [](double s, const DisplacedNode& n) { return s < n.along; });
  const auto number = static_cast<double>(next - nodes.begin());
  const double below = next == nodes.begin() ? tube.start() : (next - 1)->along;
  const double above = next == nodes.end() ? tube.end() : next->along;
  const double part = above > below ? (row.along - below) / (above - below) : 0;
  constexpr double kNone = 1000;  // There is no such node.
  return {row.along,
          row.along / tube.end(),
          next == nodes.begin() ? kNone : row.along - below,
          next == nodes.end() ? kNone : above - row.along,
          number + part,
          static_cast<double>(tube.order()),
          age,
          tube.radius(row.along),
          row.cut || row.inner ? 1.0 : 0.0};
}

int sides_of(const Tube& tube, const MeshOptions& options) {
  double most = 0;
  for (const Ring& ring : tube.rings()) most = std::max(most, ring.radius);
  const double part = std::min(1.0, options.tolerance / most);
  const double half = maths::acos(1 - part);
  // Resolves a groove's bed, rims and flanks.
  const int grooved = tube.displacement().deepest() > 0 ? 48 : 0;
  return std::clamp(std::max(static_cast<int>(std::ceil(kPi / half)), grooved), options.min_sides,
                    options.max_sides);
}

/// Builds the surface of one tube, profile by profile.
class SweepMesher {
 public:
  SweepMesher(const Tube& tube, const MeshOptions& options)
      : tube_(tube), sides_(sides_of(tube, options)) {
    for (int j = 0; j < sides_; ++j) {
      const double angle = 2 * kPi * j / sides_;
      around_.push_back({maths::cos(angle), maths::sin(angle), angle});
    }
    for (const AttributeInfo& info : stem_attributes())
      mesh_.attributes.push_back({info.name, 1, {}});
  }

  mesh::Mesh build() {
    for (const Profile& profile : profiles(tube_)) build(profile);
    mesh_.normals = normals();
    return std::move(mesh_);
  }

 private:
  void build(const Profile& profile) {
    std::vector<uint32_t> firsts;
    for (const ProfileRow& row : profile.rows) firsts.push_back(add(row));
    for (size_t i = 0; i + 1 < firsts.size(); ++i) join(firsts[i], firsts[i + 1]);
    if (profile.ring) return join(firsts.back(), firsts.front());
    fan(profile.rows.front(), firsts.front(), true);
    fan(profile.rows.back(), firsts.back(), false);
  }
  uint32_t add(const ProfileRow& row) {
    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    const Ring ring = tube_.at(row.along);
    for (const Direction& a : around_) {
      const double out = row.share * (row.inner ? tube_.inner_radius(row.along)
                                                : tube_.displaced(row.along, a.angle));
      const Vec3d direction = ring.frame.normal * a.cosine + ring.frame.binormal * a.sine;
      mesh_.positions.emplace_back(ring.center + direction * out);
      const double bed = row.inner ? 0 : tube_.displacement().beds(row.along, a.angle).height;
      mesh_.attributes.back().values.push_back(static_cast<float>(bed));
    }
    describe(row, ring.age, around_.size());
    return first;
  }
  void describe(const ProfileRow& row, double age, size_t count) {
    const RowValues values = values_of(tube_, row, age);
    for (size_t k = 0; k < values.size(); ++k)
      mesh_.attributes[k].values.insert(mesh_.attributes[k].values.end(), count,
                                        static_cast<float>(values[k]));
  }
  /// Area-weighted normals, so that at the narrow ring of an edge each side keeps the normal of its
  /// face.
  std::vector<Vec3f> normals() const {
    std::vector<Vec3d> sums(mesh_.positions.size(), Vec3d(0));
    for (size_t face = 0; face < mesh_.triangles.size(); ++face) {
      const Vec3d area = mesh::double_area_vector(mesh_, face);
      for (const uint32_t corner : mesh_.triangles[face]) sums[corner] += area;
    }
    std::vector<Vec3f> out;
    out.reserve(sums.size());
    for (const Vec3d& sum : sums) out.emplace_back(sum.normalized());
    return out;
  }
  void join(uint32_t a, uint32_t b) {
    const auto n = static_cast<uint32_t>(sides_);
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t k = (j + 1) % n;
      mesh_.triangles.push_back({a + j, a + k, b + k});
      mesh_.triangles.push_back({a + j, b + k, b + j});
    }
  }
  /// Closes the hole at an end of a profile with a vertex on the middle line.
  void fan(ProfileRow row, uint32_t ring, bool at_front) {
    const auto pole = static_cast<uint32_t>(mesh_.positions.size());
    const Ring middle = tube_.at(row.along);
    mesh_.positions.emplace_back(middle.center);
    mesh_.attributes.back().values.push_back(0);
    describe(row, middle.age, 1);
    const auto n = static_cast<uint32_t>(sides_);
    for (uint32_t j = 0; j < n; ++j) {
      const uint32_t k = (j + 1) % n;
      mesh_.triangles.push_back(at_front ? mesh::Triangle{pole, ring + k, ring + j}
                                         : mesh::Triangle{pole, ring + j, ring + k});
    }
  }

  struct Direction {
    double cosine, sine, angle;
  };
  const Tube& tube_;
  int sides_;
  std::vector<Direction> around_;
  mesh::Mesh mesh_;
};

}  // namespace

const std::vector<AttributeInfo>& stem_attributes() {
  static const std::vector<AttributeInfo> all = {
      {"along", "metres along the stem from its start"},
      {"height", "the same as a share of the stem's length"},
      {"above_node", "metres above the last node, 1000 without one"},
      {"below_node", "metres below the next node, 1000 without one"},
      {"internode", "number of nodes below plus the fraction of the internode"},
      {"order", "0 on culms, 1 on branches, ..."},
      {"age", "the turtle's age"},
      {"radius", "radius of the smooth stem, metres"},
      {"inside", "1 on cuts and inside the hollow, else 0"},
      {"groove", "1 in the bed of the groove above a branch, 0 outside of grooves"},
  };
  return all;
}

mesh::Mesh swept_mesh(const std::vector<Tube>& tubes, const MeshOptions& options) {
  std::vector<mesh::Mesh> parts(tubes.size());
  parallel_for(
      parts.size(), [&](size_t i) { parts[i] = SweepMesher(tubes[i], options).build(); }, 8);
  mesh::Mesh all;
  for (const AttributeInfo& info : stem_attributes()) all.attributes.push_back({info.name, 1, {}});
  size_t vertices = 0, triangles = 0;
  for (const mesh::Mesh& part : parts) {
    vertices += part.positions.size();
    triangles += part.triangles.size();
  }
  if (vertices > UINT32_MAX)
    throw Error(ErrorCode::too_large, "the stems have more vertices than a mesh can index", {},
                "use a larger tolerance");
  all.positions.reserve(vertices);
  all.normals.reserve(vertices);
  all.triangles.reserve(triangles);
  for (const mesh::Mesh& part : parts) {
    const auto first = static_cast<uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
    for (const mesh::Triangle& t : part.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    for (size_t k = 0; k < all.attributes.size(); ++k)
      all.attributes[k].values.insert(all.attributes[k].values.end(),
                                      part.attributes[k].values.begin(),
                                      part.attributes[k].values.end());
  }
  return all;
}

}  // namespace vug::flora
