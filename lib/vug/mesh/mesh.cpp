// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::mesh {
namespace {

bool finite(const Vec3f& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

const Attribute* find_attribute(const Mesh& mesh, std::string_view name, int arity) {
  for (const Attribute& attribute : mesh.attributes)
    if (attribute.name == name && (arity == 0 || attribute.arity == arity)) return &attribute;
  return nullptr;
}

std::array<Vec3d, 3> corners(const Mesh& mesh, size_t face) {
  const Triangle& t = mesh.triangles[face];
  return {Vec3d(mesh.positions[t[0]]), Vec3d(mesh.positions[t[1]]), Vec3d(mesh.positions[t[2]])};
}

Vec3d double_area_vector(const Mesh& mesh, size_t face) {
  const std::array<Vec3d, 3> p = corners(mesh, face);
  return (p[1] - p[0]).cross(p[2] - p[0]);
}

Box3d bounds(const Mesh& mesh) {
  Box3f box;
  for (const Vec3f& p : mesh.positions) box.extendBy(p);
  return box.isEmpty() ? Box3d() : Box3d(Vec3d(box.min), Vec3d(box.max));
}

Digest digest(const Mesh& mesh) {
  Hasher hasher;
  const auto add = [&](const auto& list) {
    hasher.add_value(static_cast<uint64_t>(list.size()));
    hasher.add(list.data(), list.size() * sizeof list[0]);
  };
  add(mesh.positions);
  add(mesh.triangles);
  add(mesh.normals);
  hasher.add_value(static_cast<uint64_t>(mesh.attributes.size()));
  for (const Attribute& attribute : mesh.attributes) {
    add(attribute.name);
    hasher.add_value(static_cast<int32_t>(attribute.arity));
    add(attribute.values);
  }
  return hasher.finish();
}

void validate(const Mesh& mesh, const std::string& what) {
  const auto fail = [&](const std::string& message) {
    throw Error(ErrorCode::bad_input, fmt::format("{}: {}", what, message));
  };
  const size_t vertices = mesh.positions.size();
  if (vertices > UINT32_MAX) fail("more than 4294967295 vertices");
  for (size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const uint32_t corner : mesh.triangles[i])
      if (corner >= vertices)
        fail(fmt::format("triangle {} uses vertex {} of {}", i, corner, vertices));
  for (size_t i = 0; i < vertices; ++i)
    if (!finite(mesh.positions[i])) fail(fmt::format("vertex {} is not a finite point", i));
  if (!mesh.normals.empty() && mesh.normals.size() != vertices)
    fail(fmt::format("{} normals for {} vertices", mesh.normals.size(), vertices));
  if (!std::all_of(mesh.normals.begin(), mesh.normals.end(), finite))
    fail("a normal is not finite");
  for (const Attribute& attribute : mesh.attributes) {
    if (attribute.arity < 1 ||
        attribute.values.size() != vertices * static_cast<size_t>(attribute.arity))
      fail(fmt::format("attribute '{}' has {} values for {} vertices", attribute.name,
                       attribute.values.size(), vertices));
    for (const float value : attribute.values)
      if (!std::isfinite(value))
        fail(fmt::format("attribute '{}' contains a number that is not finite", attribute.name));
  }
}

}  // namespace vug::mesh
