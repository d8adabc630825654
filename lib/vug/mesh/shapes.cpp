// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/mesh/shapes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vug::mesh {

Mesh box_mesh(const Box3d& box) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(Vec3d(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                                      i & 4 ? box.max.z : box.min.z));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh sphere_mesh(const Vec3d& centre, double radius, int levels) {
  const double g = 0.5 * (1 + std::sqrt(5.0));
  std::vector<Vec3d> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                               {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                               {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  Mesh mesh;
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Vec3d& p : points) p.normalize();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto [place, fresh] = middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                      static_cast<uint32_t>(points.size()));
      if (fresh) points.push_back((points[a] + points[b]).normalized());
      return place->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const uint32_t ab = middle(t[0], t[1]);
      const uint32_t bc = middle(t[1], t[2]);
      const uint32_t ca = middle(t[2], t[0]);
      for (const Triangle& part :
           {Triangle{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}})
        finer.push_back(part);
    }
    mesh.triangles = std::move(finer);
  }
  for (const Vec3d& p : points) mesh.positions.emplace_back(centre + p * radius);
  return mesh;
}

Mesh torus_mesh(double radius, double tube, int around, int across) {
  Mesh mesh;
  const auto index = [&](int i, int j) {
    return static_cast<uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * kPi * i / around;
      const double v = 2 * kPi * j / across;
      const double reach = radius + tube * maths::cos(v);
      mesh.positions.emplace_back(
          Vec3d(reach * maths::cos(u), tube * maths::sin(v), reach * maths::sin(u)));
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  return mesh;
}

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh both = a;
  if (a.attributes.size() != b.attributes.size() || a.normals.empty() != b.normals.empty())
    throw Error(ErrorCode::bad_input, "meshes with different attributes cannot be joined");
  const auto append = [](auto& list, const auto& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  append(both.positions, b.positions);
  append(both.normals, b.normals);
  const auto offset = static_cast<uint32_t>(a.positions.size());
  for (const Triangle& t : b.triangles)
    both.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  for (size_t i = 0; i < a.attributes.size(); ++i) {
    if (a.attributes[i].name != b.attributes[i].name ||
        a.attributes[i].arity != b.attributes[i].arity)
      throw Error(ErrorCode::bad_input, "meshes with different attributes cannot be joined");
    append(both.attributes[i].values, b.attributes[i].values);
  }
  return both;
}

}  // namespace vug::mesh
