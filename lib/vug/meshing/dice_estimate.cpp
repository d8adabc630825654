// SPDX-License-Identifier: Apache-2.0
// The number of triangles of a diced mesh, before it is diced.
#include <vug/base/parallel.h>
#include <vug/mesh/split_triangle.h>
#include <vug/mesh/weld.h>
#include <vug/meshing/dice.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

constexpr double kSamples = 1500;  // Triangles that are diced for the correction,
constexpr double kFewest = 40;     // or fewer, if that gives more than
constexpr double kMostParts = 3e5;
constexpr double kCountable = 5e7;  // Above this number, triangles are estimated from areas.
constexpr double kPerArea = 4;      // Triangles per squared edge length; regular ones have 2.3.

struct Corner {
  Vec3d point;
  double longest = 0;
};

Corner between(const Corner& a, const Corner& b) {
  return {(a.point + b.point) * 0.5, 0.5 * (a.longest + b.longest)};
}

/// The parts of a triangle without displacement.
double count_parts(const std::array<Corner, 3>& own, int levels) {
  std::array<Corner, 6> all = {own[0], own[1], own[2], {}, {}, {}};
  std::array<uint32_t, 3> middles = {mesh::kNotSplit, mesh::kNotSplit, mesh::kNotSplit};
  const auto length2 = [&](uint32_t a, uint32_t b) {
    return (all[a].point - all[b].point).length2();
  };
  bool divided = false;
  for (uint32_t k = 0; k < 3 && levels > 0; ++k) {
    const uint32_t next = (k + 1) % 3;
    const double longest = std::min(all[k].longest, all[next].longest);
    if (!(length2(k, next) > longest * longest)) continue;
    all[3 + k] = between(all[k], all[next]);
    middles[k] = 3 + k;
    divided = true;
  }
  if (!divided) return 1;
  std::vector<mesh::Triangle> parts;
  parts.reserve(4);
  mesh::split_triangle({0, 1, 2}, middles, length2, parts);
  double sum = 0;
  for (const mesh::Triangle& t : parts)
    sum += count_parts({all[t[0]], all[t[1]], all[t[2]]}, levels - 1);
  return sum;
}

/// The number of triangles without displacement.
double count_flat(const mesh::Mesh& mesh, const DiceOptions& options) {
  std::vector<double> lengths(mesh.positions.size());
  parallel_for(
      lengths.size(), [&](size_t v) { lengths[v] = options.edge_length(Vec3d(mesh.positions[v])); },
      1024);
  const auto corners = [&](size_t face) {
    const mesh::Triangle& t = mesh.triangles[face];
    std::array<Corner, 3> all;
    for (size_t k = 0; k < 3; ++k) all[k] = {Vec3d(mesh.positions[t[k]]), lengths[t[k]]};
    return all;
  };
  const double most = std::ldexp(1.0, 2 * options.levels);
  const double by_area = ordered_sum(mesh.triangles.size(), 0.0, [&](size_t face) {
    const auto all = corners(face);
    const double longest = std::min({all[0].longest, all[1].longest, all[2].longest});
    const double area = 0.5 * mesh::double_area_vector(mesh, face).length();
    return std::clamp(kPerArea * area / (longest * longest), 1.0, most);
  });
  if (by_area > kCountable) return by_area;
  return ordered_sum(
      mesh.triangles.size(), 0.0,
      [&](size_t face) { return count_parts(corners(face), options.levels); }, 256);
}

}  // namespace

double estimate_diced_triangles(const mesh::Mesh& mesh, const field::Field& field,
                                const DiceOptions& options) {
  const double flat = count_flat(mesh, options);
  if (flat > kCountable) return flat;
  mesh::Mesh sample;
  sample.positions = mesh.positions, sample.normals = mesh.normals;
  const auto count = static_cast<double>(mesh.triangles.size());
  const double samples = std::clamp(count * kMostParts / flat, kFewest, kSamples);
  const auto stride = static_cast<size_t>(std::max(count / samples, 1.0));
  for (size_t face = stride / 2; face < mesh.triangles.size(); face += stride)
    sample.triangles.push_back(mesh.triangles[face]);
  sample = mesh::without_unused_vertices(sample);
  const double flat_sample = count_flat(sample, options);
  if (!(flat_sample > 0)) return flat;
  const auto diced = static_cast<double>(dice(sample, field, options).mesh.triangles.size());
  return flat * diced / flat_sample;
}

}  // namespace vug::meshing
