// SPDX-License-Identifier: Apache-2.0
// Adds a new vertex between two existing ones.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Adds a vertex to `out`, which has the same attributes in the same order as `from` and may be
/// `from` itself. Its position, normal and attributes are blend(value at a, value at b); the normal
/// is normalised (the normal of a if a == b or the two cancel out). Returns the vertex number.
template <class Blend>
uint32_t split_edge(const Mesh& from, uint32_t a, uint32_t b, const Blend& blend, Mesh& out) {
  out.positions.push_back(blend(from.positions[a], from.positions[b]));
  if (!from.normals.empty()) {
    const Vec3f n = blend(from.normals[a], from.normals[b]);
    out.normals.push_back(a == b || n.length2() == 0 ? Vec3f(from.normals[a]) : n.normalized());
  }
  for (size_t i = 0; i < from.attributes.size(); ++i) {
    const Attribute& attribute = from.attributes[i];
    const auto arity = static_cast<size_t>(attribute.arity);
    for (size_t c = 0; c < arity; ++c)
      out.attributes[i].values.push_back(
          blend(attribute.values[a * arity + c], attribute.values[b * arity + c]));
  }
  return static_cast<uint32_t>(out.positions.size() - 1);
}

}  // namespace vug::mesh
