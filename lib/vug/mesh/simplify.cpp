// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/simplify.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace vug::mesh {

struct Simplifier::Impl {
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  /// The sum of the squared distances from planes, weighted by area.
  struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, constant = 0;
    double area = 0;

    void add_plane(const Vec3d& n, double offset, double weight) {
      xx += weight * n.x * n.x;
      xy += weight * n.x * n.y;
      xz += weight * n.x * n.z;
      yy += weight * n.y * n.y;
      yz += weight * n.y * n.z;
      zz += weight * n.z * n.z;
      x += weight * n.x * offset;
      y += weight * n.y * offset;
      z += weight * n.z * offset;
      constant += weight * offset * offset;
      area += weight;
    }
    void add(const Quadric& other) {
      xx += other.xx;
      xy += other.xy;
      xz += other.xz;
      yy += other.yy;
      yz += other.yz;
      zz += other.zz;
      x += other.x;
      y += other.y;
      z += other.z;
      constant += other.constant;
      area += other.area;
    }
    double at(const Vec3d& p) const {
      return p.x * (xx * p.x + 2 * (xy * p.y + xz * p.z + x)) +
             p.y * (yy * p.y + 2 * (yz * p.z + y)) + p.z * (zz * p.z + 2 * z) + constant;
    }
  };

  /// The best collapse of `from` when it was last examined.
  struct Collapse {
    double cost;
    uint32_t from;
  };

  /// The cheapest collapse first; the order is total, so that it depends only on the mesh.
  struct IsLater {
    bool operator()(const Collapse& a, const Collapse& b) const {
      return a.cost != b.cost ? a.cost > b.cost : a.from > b.from;
    }
  };

  enum class Kind : uint8_t { interior, locked, border };

  explicit Impl(const Mesh& given);

  Vec3d position(uint32_t v) const { return Vec3d(source.positions[v]) - origin; }

  /// Calls `visit(corner)` for the corners of the remaining triangles at v.
  template <class Visit>
  void each_corner(uint32_t v, const Visit& visit) const {
    for (uint32_t corner = first[v]; corner != kNone; corner = next[corner])
      if (faces[corner / 3][0] != kNone) visit(corner);
  }
  uint32_t after(uint32_t corner) const { return faces[corner / 3][(corner % 3 + 1) % 3]; }
  uint32_t before(uint32_t corner) const { return faces[corner / 3][(corner % 3 + 2) % 3]; }

  void find_kinds();
  bool has_one_fan(uint32_t v) const;
  void add_quadrics();
  void gather_link(uint32_t v);
  bool keeps_topology(uint32_t from, uint32_t to);
  bool keeps_orientation(uint32_t from, uint32_t to) const;
  double cost(uint32_t from, uint32_t to) const;
  /// The vertex to which `from` is best collapsed; kNone if there is none.
  std::pair<uint32_t, double> best_target(uint32_t from);
  void push(uint32_t from);
  void collapse(uint32_t from, uint32_t to);
  void reduce_to(size_t wanted);

  const Mesh& source;
  Vec3d origin;
  std::vector<Triangle> faces;        ///< The first corner of a removed one is kNone.
  std::vector<uint32_t> first, next;  ///< Lists of the corners at each vertex.
  std::vector<Kind> kinds;
  std::vector<Quadric> quadrics;
  std::vector<char> queued;  ///< Whether the vertex is in the queue, which has it once at most.
  std::priority_queue<Collapse, std::vector<Collapse>, IsLater> queue;
  size_t remaining = 0, borders = 0;

  /// Marks of vertices, which are valid if they have the number of the current query.
  std::vector<uint32_t> marks;
  uint32_t query = 0;
  std::vector<uint32_t> link;  ///< The neighbours of the vertex that is examined.
};

Simplifier::Impl::Impl(const Mesh& given)
    : source(given),
      origin(given.positions.empty() ? Vec3d(0.0) : bounds(given).center()),
      faces(given.triangles),
      first(given.positions.size(), kNone),
      next(3 * given.triangles.size(), kNone),
      kinds(given.positions.size(), Kind::interior),
      quadrics(given.positions.size()),
      queued(given.positions.size(), 0),
      remaining(given.triangles.size()),
      marks(given.positions.size(), 0) {
  for (size_t corner = next.size(); corner-- > 0;) {
    const uint32_t v = faces[corner / 3][corner % 3];
    next[corner] = first[v];
    first[v] = static_cast<uint32_t>(corner);
  }
  find_kinds();
  add_quadrics();
  for (uint32_t v = 0; v < first.size(); ++v)
    if (kinds[v] == Kind::interior) push(v);
}

void Simplifier::Impl::find_kinds() {
  const Edges edges = find_edges(source);
  for (const Edge& edge : edges.edges) {
    if (edge.count == 2) continue;
    borders += edge.count == 1 ? 1 : 0;
    for (const uint32_t v : {edge.low, edge.high})
      if (edge.count == 1)
        kinds[v] = Kind::border;
      else if (kinds[v] == Kind::interior)
        kinds[v] = Kind::locked;
  }
  for (uint32_t v = 0; v < first.size(); ++v)
    if (kinds[v] == Kind::interior && !has_one_fan(v)) kinds[v] = Kind::locked;
}

/// Whether the triangles at v form one closed fan with a common orientation.
bool Simplifier::Impl::has_one_fan(uint32_t v) const {
  size_t corners = 0;
  each_corner(v, [&](uint32_t) { ++corners; });
  if (corners < 3) return false;
  const uint32_t begin = after(first[v]);
  uint32_t at = begin;
  for (size_t steps = 1; steps <= corners; ++steps) {
    uint32_t following = kNone;
    size_t found = 0;
    each_corner(v, [&](uint32_t corner) {
      if (after(corner) != at) return;
      following = before(corner);
      ++found;
    });
    if (found != 1 || following == v) return false;
    at = following;
    if (at == begin) return steps == corners;
  }
  return false;
}

void Simplifier::Impl::add_quadrics() {
  for (size_t face = 0; face < faces.size(); ++face) {
    Vec3d normal = double_area_vector(source, face);
    const double doubled = normal.length();
    if (!(doubled > 0)) continue;
    normal /= doubled;
    const double offset = -normal.dot(position(faces[face][0]));
    for (const uint32_t v : faces[face]) quadrics[v].add_plane(normal, offset, doubled);
  }
}

/// Stores the neighbours of an interior vertex, each once, in `link`.
void Simplifier::Impl::gather_link(uint32_t v) {
  link.clear();
  each_corner(v, [&](uint32_t corner) { link.push_back(after(corner)); });
}

/// Whether the links of both vertices have only the link of their edge in common, and no two
/// vertices of the border become neighbours. `link` contains the neighbours of `from`.
bool Simplifier::Impl::keeps_topology(uint32_t from, uint32_t to) {
  ++query;
  for (const uint32_t v : link) marks[v] = query;
  // The opposite corners of the two triangles at the edge.
  uint32_t left = kNone, right = kNone;
  each_corner(from, [&](uint32_t corner) {
    if (after(corner) == to) left = before(corner);
    if (before(corner) == to) right = after(corner);
  });
  if (left == kNone || right == kNone || left == right) return false;
  bool valid = true;
  each_corner(to, [&](uint32_t corner) {
    const uint32_t a = after(corner), b = before(corner);
    for (const uint32_t v : {a, b})
      if (v != left && v != right && marks[v] == query) valid = false;
    // The edge from left to right is in both links, as in a tetrahedron.
    if (link.size() == 3 && a != from && b != from &&
        ((a == left && b == right) || (a == right && b == left)))
      valid = false;
  });
  if (!valid || kinds[to] != Kind::border) return valid;
  return std::none_of(link.begin(), link.end(), [&](uint32_t v) {
    return v != to && v != left && v != right && kinds[v] == Kind::border;
  });
}

/// Whether no triangle turns by more than about 75 degrees or loses its area.
bool Simplifier::Impl::keeps_orientation(uint32_t from, uint32_t to) const {
  constexpr double kLeastCosine = 0.25;
  const Vec3d old = position(from), moved = position(to);
  bool valid = true;
  each_corner(from, [&](uint32_t corner) {
    const uint32_t a = after(corner), b = before(corner);
    if (!valid || a == to || b == to) return;
    const Vec3d p = position(a), q = position(b);
    const Vec3d was = (p - old).cross(q - old), is = (p - moved).cross(q - moved);
    const double lengths = std::sqrt(was.length2() * is.length2());
    if (was.length2() > 0 && !(was.dot(is) > kLeastCosine * lengths)) valid = false;
  });
  return valid;
}

/// The mean squared distance of the target from the planes of both vertices, and a share of the
/// squared length of the edge, which decides in flat regions and avoids long triangles there.
double Simplifier::Impl::cost(uint32_t from, uint32_t to) const {
  constexpr double kShareOfLength = 1e-4;
  const Vec3d target = position(to);
  const Quadric &a = quadrics[from], &b = quadrics[to];
  const double area = a.area + b.area;
  const double squares = area > 0 ? std::max(0.0, a.at(target) + b.at(target)) / area : 0;
  return squares + kShareOfLength * (target - position(from)).length2();
}

std::pair<uint32_t, double> Simplifier::Impl::best_target(uint32_t from) {
  std::pair<uint32_t, double> best = {kNone, kInfinity};
  gather_link(from);
  for (const uint32_t to : link) {
    const double price = cost(from, to);
    if (price > best.second || (price == best.second && to > best.first)) continue;
    if (keeps_topology(from, to) && keeps_orientation(from, to)) best = {to, price};
  }
  return best;
}

void Simplifier::Impl::push(uint32_t from) {
  const auto [to, price] = best_target(from);
  queued[from] = to != kNone;
  if (to != kNone) queue.push({price, from});
}

void Simplifier::Impl::collapse(uint32_t from, uint32_t to) {
  uint32_t last = kNone;
  for (uint32_t corner = first[from]; corner != kNone; corner = next[corner]) {
    last = corner;
    Triangle& face = faces[corner / 3];
    if (face[0] == kNone) continue;
    if (face[0] == to || face[1] == to || face[2] == to) {
      face = {kNone, kNone, kNone};
      --remaining;
    } else {
      face[corner % 3] = to;
    }
  }
  next[last] = first[to];
  first[to] = first[from];
  first[from] = kNone;
  // Removed triangles leave the list.
  uint32_t* place = &first[to];
  while (*place != kNone)
    if (faces[*place / 3][0] == kNone)
      *place = next[*place];
    else
      place = &next[*place];
  quadrics[to].add(quadrics[from]);
  // Vertices that had no valid collapse may have one now. `link` has the neighbours of the removed
  // vertex, `to` among them.
  const std::vector<uint32_t> changed = link;
  for (const uint32_t v : changed)
    if (kinds[v] == Kind::interior && !queued[v]) push(v);
}

void Simplifier::Impl::reduce_to(size_t wanted) {
  while (remaining > wanted && !queue.empty()) {
    const Collapse top = queue.top();
    queue.pop();
    queued[top.from] = 0;
    // The neighbourhood may have changed, which mostly increases the cost.
    const auto [to, price] = best_target(top.from);
    if (to == kNone) continue;
    if (price > top.cost) {
      queued[top.from] = 1;
      queue.push({price, top.from});
      continue;
    }
    collapse(top.from, to);
  }
}

Simplifier::Simplifier(const Mesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
Simplifier::~Simplifier() = default;

void Simplifier::reduce_to(size_t wanted) { impl_->reduce_to(wanted); }
size_t Simplifier::triangles() const { return impl_->remaining; }
size_t Simplifier::border_edges() const { return impl_->borders; }

Mesh Simplifier::mesh() const {
  Mesh out = impl_->source;
  out.triangles.clear();
  out.triangles.reserve(impl_->remaining);
  for (const Triangle& face : impl_->faces)
    if (face[0] != Impl::kNone) out.triangles.push_back(face);
  return without_unused_vertices(out);
}

}  // namespace vug::mesh
