// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/base/parallel.h>
#include <vug/mesh/topology.h>

#include <algorithm>
#include <utility>

namespace vug::mesh {
namespace {

struct HalfEdgeEnds {
  uint32_t from, to;
};

HalfEdgeEnds ends(const Mesh& mesh, uint32_t h) {
  const Triangle& t = mesh.triangles[h / 3];
  return {t[h % 3], t[(h + 1) % 3]};
}

/// Joins corners (numbered like the half-edges that leave them) that share a vertex and an edge.
DisjointSets<> find_fans(const Mesh& mesh, const Edges& edges) {
  DisjointSets<> fans(3 * mesh.triangles.size());
  for (const Edge& edge : edges.edges)
    for (uint32_t i = 1; i < edge.count; ++i) {
      uint32_t a = edges.half_edges[edge.begin];
      uint32_t b = edges.half_edges[edge.begin + i];
      const bool same_way = ends(mesh, a).from == ends(mesh, b).from;
      fans.join(a, same_way ? b : next_half_edge(b));
      fans.join(next_half_edge(a), same_way ? next_half_edge(b) : b);
    }
  return fans;
}

size_t count_boundary_loops(const Edges& edges, DisjointSets<>& fans) {
  DisjointSets<> loops(fans.size());
  size_t count = 0;
  std::vector<char> seen(fans.size(), 0);
  for (const Edge& edge : edges.edges) {
    if (edge.count != 1) continue;
    const uint32_t h = edges.half_edges[edge.begin];
    for (const uint32_t fan : {fans.root(h), fans.root(next_half_edge(h))})
      if (!std::exchange(seen[fan], 1)) ++count;
    if (loops.join(fans.root(h), fans.root(next_half_edge(h)))) --count;
  }
  return count;
}

}  // namespace

Edges find_edges(const Mesh& mesh) {
  const auto halves = static_cast<uint32_t>(3 * mesh.triangles.size());
  const size_t vertices = mesh.positions.size();
  // Counting sort by the lower end, then a short sort of each vertex's own edges.
  std::vector<uint32_t> start(vertices + 1, 0);
  for (uint32_t h = 0; h < halves; ++h) {
    const HalfEdgeEnds e = ends(mesh, h);
    if (e.from != e.to) ++start[std::min(e.from, e.to) + 1];
  }
  for (size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
  Edges found;
  found.half_edges.resize(start[vertices]);
  std::vector<uint32_t> next(start.begin(), start.end() - 1);
  for (uint32_t h = 0; h < halves; ++h) {
    const HalfEdgeEnds e = ends(mesh, h);
    if (e.from != e.to) found.half_edges[next[std::min(e.from, e.to)]++] = h;
  }
  const auto high = [&](uint32_t h) {
    const HalfEdgeEnds e = ends(mesh, h);
    return std::max(e.from, e.to);
  };
  uint32_t* list = found.half_edges.data();
  parallel_for(
      vertices,
      [&](size_t v) {
        std::sort(list + start[v], list + start[v + 1], [&](uint32_t a, uint32_t b) {
          return std::pair(high(a), a) < std::pair(high(b), b);
        });
      },
      4096);
  found.edges.reserve(halves / 2);
  for (uint32_t v = 0; v < vertices; ++v)
    for (uint32_t i = start[v]; i < start[v + 1]; ++i) {
      const uint32_t to = high(list[i]);
      if (i > start[v] && found.edges.back().high == to)
        ++found.edges.back().count;
      else
        found.edges.push_back({v, to, i, 1});
    }
  return found;
}

std::vector<uint32_t> face_components(const Mesh& mesh, const Edges& edges) {
  DisjointSets<> pieces(mesh.triangles.size());
  for (const Edge& edge : edges.edges)
    for (uint32_t i = 1; i < edge.count; ++i)
      pieces.join(edges.half_edges[edge.begin] / 3, edges.half_edges[edge.begin + i] / 3);
  std::vector<uint32_t> label(mesh.triangles.size());
  uint32_t count = 0;
  for (uint32_t face = 0; face < label.size(); ++face) {
    const uint32_t root = pieces.root(face);  // The smallest face of the component.
    label[face] = root == face ? count++ : label[root];
  }
  return label;
}

Topology inspect(const Mesh& mesh, const Edges& edges) {
  Topology topology;
  topology.edges = edges.edges.size();
  for (const Edge& edge : edges.edges) {
    if (edge.count == 1) ++topology.boundary_edges;
    if (edge.count > 2) ++topology.nonmanifold_edges;
    if (edge.count == 2 && ends(mesh, edges.half_edges[edge.begin]).from ==
                               ends(mesh, edges.half_edges[edge.begin + 1]).from)
      ++topology.misoriented_edges;
  }
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    if (double_area_vector(mesh, face) == Vec3d(0)) ++topology.degenerate_triangles;

  for (const uint32_t label : face_components(mesh, edges))
    topology.components = std::max<size_t>(topology.components, label + size_t{1});

  DisjointSets<> fans = find_fans(mesh, edges);
  std::vector<uint32_t> fans_of(mesh.positions.size(), 0);
  size_t fan_count = 0;
  for (uint32_t corner = 0; corner < fans.size(); ++corner)
    if (fans.root(corner) == corner) {
      ++fan_count;
      ++fans_of[mesh.triangles[corner / 3][corner % 3]];
    }
  for (const uint32_t count : fans_of) {
    if (count == 0) ++topology.unused_vertices;
    if (count > 1) ++topology.nonmanifold_vertices;
  }
  topology.boundary_loops = count_boundary_loops(edges, fans);

  if (topology.nonmanifold_edges == 0 && topology.misoriented_edges == 0) {
    // Euler: fans - edges + faces = 2 components - 2 handles - holes.
    const auto euler = static_cast<int64_t>(fan_count + mesh.triangles.size()) -
                       static_cast<int64_t>(topology.edges);
    const int64_t twice = 2 * static_cast<int64_t>(topology.components) -
                          static_cast<int64_t>(topology.boundary_loops) - euler;
    if (twice >= 0) topology.genus = static_cast<size_t>(twice / 2);
  }
  return topology;
}

Topology inspect(const Mesh& mesh) { return inspect(mesh, find_edges(mesh)); }

}  // namespace vug::mesh
