// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/transform.h>
#include <vug/flora/leaf.h>
#include <vug/flora/merge_instances.h>
#include <vug/mesh/normals.h>

#include <cmath>

namespace vug::flora {
namespace {

constexpr double kPetiole = 0.07;  // Minimum half width relative to the blade's, at the base.

struct BladeRow {
  Vec3d middle, right, up;
  double half = 0;  ///< Half width in metres.
  double along = 0;
};

/// Rows from base to tip. The bend increases towards the tip, where leaves are thinner.
std::vector<BladeRow> rows_of(const LeafOptions& o) {
  std::vector<BladeRow> rows;
  Vec3d at(0, 0, 0);
  const double step = o.length / o.rows;
  for (int i = 0; i <= o.rows; ++i) {
    const double t = static_cast<double>(i) / o.rows;
    const auto heading = [&](double along) {
      const double turned = o.bend * along * std::sqrt(along);
      return Vec3d(0, maths::cos(turned), -maths::sin(turned));
    };
    if (i > 0) at += heading(t - 0.5 / o.rows) * step;
    const Vec3d ahead = heading(t), flat(1, 0, 0), above = flat.cross(ahead);
    const double turn = o.twist * t, c = maths::cos(turn), s = maths::sin(turn);
    const bool in_base = t < o.outline.widest;
    double half = o.outline.half_width(t);
    if (in_base) half = std::max(half, kPetiole);
    if (o.card) half = 1;
    rows.push_back({at, flat * c + above * s, above * c - flat * s, half * o.width / 2, t});
  }
  return rows;
}

}  // namespace

std::string LeafOptions::fault() const {
  if (!(length > 0 && width > 0)) return "the length and width of a leaf must be above 0";
  if (!(outline.widest > 0 && outline.widest < 1 && outline.tip > 0))
    return "a leaf must be widest between its ends, and 'tip' must be above 0";
  return rows < 2 ? "a leaf needs at least 2 rows" : "";
}

mesh::Mesh leaf(const LeafOptions& options) {
  if (const std::string fault = options.fault(); !fault.empty())
    throw Error(ErrorCode::bad_input, fault);
  mesh::Mesh blade;
  mesh::Attribute across{paint::kLeafAcross, 1, {}}, along{paint::kLeafAlong, 1, {}};
  const auto add = [&](const Vec3d& p, double side, double t) {
    blade.positions.emplace_back(p);
    across.values.push_back(static_cast<float>(side));
    along.values.push_back(static_cast<float>(t));
  };
  const double c = maths::cos(options.fold), s = maths::sin(options.fold);
  for (const BladeRow& row : rows_of(options)) {
    const auto first = static_cast<uint32_t>(blade.positions.size());
    const bool is_tip = row.half == 0;
    const double side = row.half / (options.width / 2);
    if (!is_tip) add(row.middle + (row.up * s - row.right * c) * row.half, -side, row.along);
    add(row.middle, 0, row.along);
    if (!is_tip) add(row.middle + (row.up * s + row.right * c) * row.half, side, row.along);
    if (first == 0) continue;
    const uint32_t left = first - 3, middle = first - 2, right = first - 1;
    if (is_tip) {
      blade.triangles.push_back({left, middle, first});
      blade.triangles.push_back({middle, right, first});
      continue;
    }
    blade.triangles.push_back({left, middle, first + 1});
    blade.triangles.push_back({left, first + 1, first});
    blade.triangles.push_back({middle, right, first + 2});
    blade.triangles.push_back({middle, first + 2, first + 1});
  }
  blade.normals = mesh::vertex_normals(blade);
  blade.attributes = {across, along};
  return blade;
}

mesh::Mesh spray(const SprayOptions& options) {
  if (options.leaves < 1) throw Error(ErrorCode::bad_input, "a spray needs at least 1 leaf");
  std::vector<mesh::Mesh> blades;
  std::vector<MeshInstance> copies;
  for (int i = 0; i < options.leaves; ++i) {
    const RandomKey key = options.key.at(static_cast<uint64_t>(i));
    RandomStream random(key);
    const auto varied = [&](double x) { return x * (1 + options.vary * random.uniform(-1, 1)); };
    LeafOptions one = options.leaf;
    one.length = varied(one.length);
    one.bend = varied(one.bend);
    const bool last = i + 1 == options.leaves;
    const double aside = varied(options.angle), roll = options.vary * random.uniform(-1, 1);
    const double turn = last ? options.vary * random.uniform(-1, 1) : i % 2 ? aside : -aside;
    const Transform to = Transform::translation({0, i * options.spacing, 0}) *
                         Transform::rotation({0, 0, 1}, turn) *
                         Transform::rotation({0, 1, 0}, roll);
    copies.push_back({blades.size(), to, key});
    blades.push_back(leaf(one));
  }
  return merge_instances(blades, copies);
}

}  // namespace vug::flora
