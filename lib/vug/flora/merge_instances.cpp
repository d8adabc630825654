// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/flora/merge_instances.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::flora {
namespace {

constexpr size_t kMaxVertices = size_t{1} << 31;

/// Start of each instance's vertices and triangles.
struct Start {
  size_t vertex = 0, triangle = 0;
};

std::vector<Start> starts_of(const std::vector<mesh::Mesh>& meshes,
                             const std::vector<MeshInstance>& copies) {
  std::vector<Start> starts(copies.size() + 1);
  for (size_t i = 0; i < copies.size(); ++i) {
    const mesh::Mesh& mesh = meshes.at(copies[i].mesh);
    starts[i + 1] = {starts[i].vertex + mesh.positions.size(),
                     starts[i].triangle + mesh.triangles.size()};
  }
  if (std::max(starts.back().vertex, starts.back().triangle) > kMaxVertices)
    throw Error(ErrorCode::too_large,
                fmt::format("{} instances in one mesh have {} vertices and {} triangles",
                            copies.size(), starts.back().vertex, starts.back().triangle),
                {}, "keep them as instances, or use simpler meshes");
  return starts;
}

/// Names and arities of the attributes common to all meshes.
std::vector<mesh::Attribute> common(const std::vector<mesh::Mesh>& meshes) {
  std::vector<mesh::Attribute> out;
  if (meshes.empty()) return out;
  for (const mesh::Attribute& attribute : meshes.front().attributes) {
    const bool everywhere = std::all_of(meshes.begin(), meshes.end(), [&](const mesh::Mesh& mesh) {
      return mesh::find_attribute(mesh, attribute.name, attribute.arity);
    });
    if (everywhere) out.push_back({attribute.name, attribute.arity, {}});
  }
  return out;
}

}  // namespace

mesh::Mesh merge_instances(const std::vector<mesh::Mesh>& meshes,
                           const std::vector<MeshInstance>& copies) {
  const std::vector<Start> starts = starts_of(meshes, copies);
  mesh::Mesh out;
  out.positions.resize(starts.back().vertex);
  out.triangles.resize(starts.back().triangle);
  out.attributes = common(meshes);
  const bool smooth = std::all_of(meshes.begin(), meshes.end(),
                                  [](const mesh::Mesh& mesh) { return !mesh.normals.empty(); });
  if (smooth) out.normals.resize(starts.back().vertex);
  if (!mesh::find_attribute(out, kCopyAttribute)) out.attributes.push_back({kCopyAttribute, 1, {}});
  for (mesh::Attribute& attribute : out.attributes)
    attribute.values.resize(starts.back().vertex * static_cast<size_t>(attribute.arity));

  const auto put = [&](size_t i) {
    const MeshInstance& copy = copies[i];
    const mesh::Mesh& mesh = meshes[copy.mesh];
    const size_t first = starts[i].vertex;
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      out.positions[first + v] = Vec3f(copy.to.point(Vec3d(mesh.positions[v])));
      if (smooth)
        out.normals[first + v] = Vec3f(copy.to.normal(Vec3d(mesh.normals[v])).normalized());
    }
    const bool mirrored = copy.to.determinant() < 0;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      mesh::Triangle corners = mesh.triangles[t];
      if (mirrored) std::swap(corners[1], corners[2]);
      for (uint32_t& corner : corners) corner += static_cast<uint32_t>(first);
      out.triangles[starts[i].triangle + t] = corners;
    }
    const auto chance = static_cast<float>(RandomStream(copy.key.at(kCopyAttribute)).uniform());
    for (mesh::Attribute& attribute : out.attributes) {
      const auto arity = static_cast<size_t>(attribute.arity);
      const auto begin = attribute.values.begin() + static_cast<std::ptrdiff_t>(first * arity);
      if (const auto* own = mesh::find_attribute(mesh, attribute.name, attribute.arity))
        std::copy(own->values.begin(), own->values.end(), begin);
      else
        std::fill_n(begin, mesh.positions.size() * arity, chance);
    }
  };
  parallel_for(copies.size(), put, 64);
  return out;
}

}  // namespace vug::flora
