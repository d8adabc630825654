// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/delivery/cutout_mesh.h>
#include <vug/delivery/material_probe.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/refine.h>
#include <vug/mesh/split_edge.h>
#include <vug/mesh/weld.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace vug::delivery {
namespace {

/// Approximate number of triangles before cutting; for a leaf, 12 across and 90 along.
constexpr double kTriangles = 4000;
/// Opacities this close to 0 or 1 count as binary; a fraction of kSoftShare of others is attributed
/// to soft edges.
constexpr double kHard = 0.02;
constexpr double kSoftShare = 0.05;
/// Bisection steps for the crossing of an outline with an edge: a thousandth of its length.
constexpr int kHalvings = 10;

mesh::Mesh refined_mesh(const mesh::Mesh& mesh) {
  mesh::Mesh out = mesh;
  if (out.normals.empty()) out.normals = mesh::vertex_normals(out);
  if (static_cast<double>(out.triangles.size()) >= kTriangles) return out;
  double area = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto p = mesh::corners(mesh, i);
    area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).length();
  }
  // Bisected edges are between one and two times shorter than requested.
  const double longest = 2 * std::sqrt(area / kTriangles);
  return longest > 0 ? mesh::refined(std::move(out), longest) : out;
}

/// Opacities at the corners and the centroids of all triangles.
using Opacities = std::vector<std::array<double, 4>>;

Opacities sampled(const MaterialProbe& probe, size_t triangles) {
  Opacities out(triangles);
  parallel_for(
      triangles,
      [&](size_t i) {
        out[i] = {probe.opacity(i, 0, 0), probe.opacity(i, 1, 0), probe.opacity(i, 0, 1),
                  probe.opacity(i, 1.0f / 3, 1.0f / 3)};
      },
      64);
  return out;
}

/// Whether there are holes and the opacity is nearly binary.
bool is_binary_cutout(const Opacities& opacities) {
  size_t soft = 0, holes = 0;
  for (const auto& places : opacities)
    for (const double o : places) {
      if (o < 1 - kHard) ++holes;
      if (o > kHard && o < 1 - kHard) ++soft;
    }
  return holes > 0 &&
         static_cast<double>(soft) <= kSoftShare * 4 * static_cast<double>(opacities.size());
}

class Cutter {
 public:
  Cutter(const mesh::Mesh& mesh, const MaterialProbe& probe, const Opacities& opacities)
      : mesh_(mesh), probe_(probe), out_(mesh) {
    out_.triangles.clear();
    for (size_t i = 0; i < mesh.triangles.size(); ++i) cut(i, opacities[i]);
  }
  mesh::Mesh take() { return mesh::without_unused_vertices(out_); }

 private:
  void cut(size_t i, const std::array<double, 4>& opacity) {
    const mesh::Triangle& t = mesh_.triangles[i];
    std::array<uint32_t, 4> ring{};
    size_t corners = 0;
    for (size_t k = 0; k < 3; ++k) {
      const size_t next = (k + 1) % 3;
      const bool here = opacity[k] >= 0.5, there = opacity[next] >= 0.5;
      if (here) ring[corners++] = t[k];
      if (here != there) ring[corners++] = crossing(i, k, here);
    }
    if (corners >= 3) out_.triangles.push_back({ring[0], ring[1], ring[2]});
    if (corners == 4) out_.triangles.push_back({ring[0], ring[2], ring[3]});
  }

  /// The vertex at which the outline crosses the edge from corner k; shared by both triangles.
  uint32_t crossing(size_t triangle, size_t k, bool first_is_inside) {
    const uint32_t a = mesh_.triangles[triangle][k], b = mesh_.triangles[triangle][(k + 1) % 3];
    const uint64_t key = uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, fresh] = crossings_.try_emplace(key, 0u);
    if (!fresh) return at->second;
    float low = 0, high = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const float middle = 0.5f * (low + high);
      ((opacity_on(triangle, k, middle) >= 0.5) == first_is_inside ? low : high) = middle;
    }
    const float share = 0.5f * (low + high);
    const auto blend = [&](const auto& x, const auto& y) { return x * (1 - share) + y * share; };
    return at->second = mesh::split_edge(mesh_, a, b, blend, out_);
  }
  double opacity_on(size_t triangle, size_t k, float share) const {
    std::array<float, 3> corner{};
    corner[k] = 1 - share, corner[(k + 1) % 3] = share;
    return probe_.opacity(triangle, corner[1], corner[2]);
  }

  const mesh::Mesh& mesh_;
  const MaterialProbe& probe_;
  mesh::Mesh out_;
  std::unordered_map<uint64_t, uint32_t> crossings_;
};

}  // namespace

std::optional<mesh::Mesh> cutout_mesh(const render::Object& object) {
  if (!object.material || !object.material->cut_out() || object.mesh->triangles.empty()) return {};
  render::Object finer = object;
  finer.mesh = std::make_shared<const mesh::Mesh>(refined_mesh(*object.mesh));
  const MaterialProbe probe(finer);
  const Opacities opacities = sampled(probe, finer.mesh->triangles.size());
  if (!is_binary_cutout(opacities)) return {};
  return Cutter(*finer.mesh, probe, opacities).take();
}

}  // namespace vug::delivery
