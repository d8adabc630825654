// SPDX-License-Identifier: Apache-2.0
// Divides a triangle at the new vertices on its edges.
#pragma once

#include <vug/mesh/mesh.h>

#include <algorithm>

namespace vug::mesh {

/// Marks an edge without a new vertex.
inline constexpr uint32_t kNotSplit = ~0u;

/// Appends the parts of a triangle, in its orientation. m[k] is the vertex on the edge from corner
/// k to the next, or kNotSplit. `length2(a, b)` is the squared distance of two vertices: a
/// remaining quadrilateral is divided along its shorter diagonal. The result depends only on the
/// triangle's own edges, so neighbours that split a common edge alike stay connected.
template <class Length2>
void split_triangle(const Triangle& t, const std::array<uint32_t, 3>& m, const Length2& length2,
                    std::vector<Triangle>& out) {
  const auto halved = std::count_if(m.begin(), m.end(), [](uint32_t v) { return v != kNotSplit; });
  if (halved == 0) return out.push_back(t);
  if (halved == 3) {
    out.insert(out.end(), {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}});
    return out.push_back({m[0], m[1], m[2]});
  }
  // Rotated such that the single unsplit edge, or the single split one, comes last.
  size_t last = 0;
  while ((m[last] == kNotSplit) != (halved == 2)) ++last;
  const size_t first = (last + 1) % 3, second = (last + 2) % 3;
  const uint32_t a = t[first], b = t[second], c = t[last];
  if (halved == 1) {
    out.push_back({a, b, m[last]});
    return out.push_back({m[last], b, c});
  }
  const uint32_t ab = m[first], bc = m[second];
  out.push_back({ab, b, bc});
  if (length2(a, bc) <= length2(ab, c))
    out.insert(out.end(), {{a, ab, bc}, {a, bc, c}});
  else
    out.insert(out.end(), {{a, ab, c}, {ab, bc, c}});
}

}  // namespace vug::mesh
