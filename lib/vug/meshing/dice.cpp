// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/split_triangle.h>
#include <vug/meshing/blocks.h>
#include <vug/meshing/dice.h>
#include <vug/meshing/place_on_field.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::meshing {
namespace {

constexpr size_t kTask = 2048;  // Triangles of one task.
constexpr size_t kMostTriangles = size_t{1} << 31;
constexpr double kBlockEdges = 32;   // Edge of a block of points, in mean edge lengths.
constexpr double kPlacement = 0.01;  // Distance of a vertex from the field, and the deviation of
constexpr double kDeviation = 0.03;  // single precision, in lengths of the finest edges.
constexpr double kSharpAngle = 25;   // Degrees; see PolygonizeOptions::crease_angle.

/// An edge to be divided, once for each triangle at it.
struct Division {
  uint64_t ends = 0;  ///< The lower vertex number in the upper half.
  uint32_t side = 0;  ///< 3 * triangle + corner at which the edge starts.

  bool operator<(const Division& other) const {
    return ends != other.ends ? ends < other.ends : side < other.side;
  }
};

class Dicer {
 public:
  Dicer(const mesh::Mesh& mesh, const field::Field& field, const DiceOptions& options,
        Progress& progress)
      : field_(field), options_(options), progress_(progress) {
    mesh_ = mesh;
    if (mesh_.normals.empty()) mesh_.normals = mesh::vertex_normals(mesh_);
    active_.swap(mesh_.triangles);
    directions_ = mesh_.normals;
    set_lengths(0);
  }

  /// Moves the vertices of the undivided mesh onto the field.
  void move_vertices() {
    const double total = ordered_sum(active_.size(), 0.0, [&](size_t i) {
      const mesh::Triangle& t = active_[i];
      return std::sqrt(static_cast<double>(length2(t[0], t[1])));
    });
    std::vector<FieldLine> lines(mesh_.positions.size());
    for (uint32_t v = 0; v < lines.size(); ++v)
      lines[v] = {Vec3d(mesh_.positions[v]), direction(directions_[v]), options_.reach,
                  kPlacement * static_cast<double>(lengths_[v])};
    place(lines, 0, total / static_cast<double>(active_.size()));
    set_lengths(0);
  }

  /// Divides long edges once; false if there were none.
  bool divide() {
    const std::vector<Division> divisions = find_divisions();
    if (divisions.empty()) return false;
    std::vector<uint32_t> middles(3 * active_.size(), mesh::kNotSplit);
    const size_t first = mesh_.positions.size();
    add_vertices(divisions, middles);
    set_lengths(first);
    split(middles);
    if (done_.size() + active_.size() > kMostTriangles)
      throw Error(
          ErrorCode::too_large,
          fmt::format("the detail of the mesh needs more than {} triangles", kMostTriangles), {},
          "use a longer edge");
    return true;
  }

  DiceResult result() {
    done_.insert(done_.end(), active_.begin(), active_.end());
    mesh_.triangles = std::move(done_);
    smooth_creases();
    return {std::move(mesh_), report_};
  }

 private:
  float length2(uint32_t a, uint32_t b) const {
    return (mesh_.positions[a] - mesh_.positions[b]).length2();
  }
  bool is_long(uint32_t a, uint32_t b) const {
    const float longest = std::min(lengths_[a], lengths_[b]);
    return length2(a, b) > longest * longest;
  }
  Vec3d direction(const Vec3f& normal) const {
    const Vec3d n(normal);
    const double size = n.length();
    return size > 0 ? n / size : Vec3d(0, 1, 0);
  }

  void set_lengths(size_t first) {
    lengths_.resize(mesh_.positions.size());
    parallel_for(
        lengths_.size() - first,
        [&](size_t i) {
          const size_t v = first + i;
          lengths_[v] = static_cast<float>(options_.edge_length(Vec3d(mesh_.positions[v])));
        },
        kTask);
  }

  /// The line on which the vertex between two others is placed. The same for (b, a).
  FieldLine line_between(uint32_t a, uint32_t b) const {
    const Vec3d from(mesh_.positions[a]), to(mesh_.positions[b]);
    const Vec3d normals = direction(directions_[a]) + direction(directions_[b]);
    // The smooth normal of ends that look in opposite directions is arbitrary; the lower end's.
    const Vec3d out =
        normals.length() > 1e-3 ? normals.normalized() : direction(directions_[std::min(a, b)]);
    return {(from + to) * 0.5, out, (from - to).length(),
            kPlacement * static_cast<double>(std::min(lengths_[a], lengths_[b]))};
  }

  /// Places the vertices from `first` on; `size` is the mean length of their edges.
  void place(const std::vector<FieldLine>& lines, size_t first, double size) {
    std::vector<Vec3d> starts(lines.size());
    double reach = 0;
    for (size_t i = 0; i < lines.size(); ++i)
      starts[i] = lines[i].start, reach = std::max(reach, lines[i].reach);
    std::vector<char> found(lines.size(), 0);
    for_each_block(
        field_, starts, {kBlockEdges * size, reach},
        [&](const std::vector<uint32_t>& indices, const field::Field& local) {
          std::vector<FieldLine> some;
          some.reserve(indices.size());
          double tolerance = 0;
          for (const uint32_t i : indices)
            some.push_back(lines[i]), tolerance += lines[i].tolerance;
          const double error =
              tolerance / static_cast<double>(some.size()) * (kDeviation / kPlacement);
          const std::vector<PlacedPoint> placed = place_on_field(local, some, error);
          for (size_t k = 0; k < indices.size(); ++k) {
            const size_t v = first + indices[k];
            mesh_.positions[v] = Vec3f(placed[k].point);
            if (placed[k].found || first > 0) mesh_.normals[v] = Vec3f(placed[k].normal);
            found[indices[k]] = placed[k].found;
          }
        },
        progress_);
    report_.unfollowed += static_cast<size_t>(std::count(found.begin(), found.end(), 0));
  }

  std::vector<Division> find_divisions() const {
    const auto for_each_long = [&](size_t chunk, const auto& body) {
      const size_t end = std::min((chunk + 1) * kTask, active_.size());
      for (size_t i = chunk * kTask; i < end; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const uint32_t a = active_[i][k], b = active_[i][(k + 1) % 3];
          if (is_long(a, b))
            body(Division{uint64_t{std::min(a, b)} << 32 | std::max(a, b),
                          static_cast<uint32_t>(3 * i + k)});
        }
    };
    const size_t chunks = (active_.size() + kTask - 1) / kTask;
    std::vector<size_t> begin(chunks + 1, 0);
    parallel_for(chunks, [&](size_t chunk) {
      for_each_long(chunk, [&](const Division&) { ++begin[chunk + 1]; });
    });
    for (size_t chunk = 0; chunk < chunks; ++chunk) begin[chunk + 1] += begin[chunk];
    std::vector<Division> divisions(begin.back());
    parallel_for(chunks, [&](size_t chunk) {
      size_t next = begin[chunk];
      for_each_long(chunk, [&](const Division& each) { divisions[next++] = each; });
    });
    parallel_sort(divisions.begin(), divisions.end());
    return divisions;
  }

  /// Adds one vertex for each divided edge, and sets the middles of the triangles' sides.
  void add_vertices(const std::vector<Division>& divisions, std::vector<uint32_t>& middles) {
    const size_t first = mesh_.positions.size();
    std::vector<uint64_t> edges;
    for (const Division& each : divisions) {
      if (edges.empty() || edges.back() != each.ends) edges.push_back(each.ends);
      middles[each.side] = static_cast<uint32_t>(first + edges.size() - 1);
    }
    const size_t count = first + edges.size();
    mesh_.positions.resize(count), mesh_.normals.resize(count), directions_.resize(count);
    for (mesh::Attribute& each : mesh_.attributes)
      each.values.resize(count * static_cast<size_t>(each.arity));
    std::vector<FieldLine> lines(edges.size());
    parallel_for(
        edges.size(),
        [&](size_t i) {
          const auto a = static_cast<uint32_t>(edges[i] >> 32), b = static_cast<uint32_t>(edges[i]);
          lines[i] = line_between(a, b);
          directions_[first + i] = Vec3f(lines[i].direction);
          for (mesh::Attribute& each : mesh_.attributes) {
            const auto arity = static_cast<size_t>(each.arity);
            for (size_t c = 0; c < arity; ++c)
              each.values[(first + i) * arity + c] =
                  (each.values[a * arity + c] + each.values[b * arity + c]) * 0.5f;
          }
        },
        kTask);
    const double total = ordered_sum(lines.size(), 0.0, [&](size_t i) { return lines[i].reach; });
    place(lines, first, total / static_cast<double>(lines.size()));
    report_.added_vertices += edges.size();
  }

  void split(const std::vector<uint32_t>& middles) {
    const size_t chunks = (active_.size() + kTask - 1) / kTask;
    std::vector<std::vector<mesh::Triangle>> finished(chunks), parts(chunks);
    parallel_for(chunks, [&](size_t chunk) {
      const size_t end = std::min((chunk + 1) * kTask, active_.size());
      for (size_t i = chunk * kTask; i < end; ++i) {
        const std::array<uint32_t, 3> m = {middles[3 * i], middles[3 * i + 1], middles[3 * i + 2]};
        const bool whole = m[0] == m[1] && m[1] == m[2];  // All are kNotSplit.
        mesh::split_triangle(
            active_[i], m, [&](uint32_t a, uint32_t b) { return length2(a, b); },
            whole ? finished[chunk] : parts[chunk]);
      }
    });
    active_.clear();
    for (size_t chunk = 0; chunk < chunks; ++chunk) {
      done_.insert(done_.end(), finished[chunk].begin(), finished[chunk].end());
      active_.insert(active_.end(), parts[chunk].begin(), parts[chunk].end());
    }
  }

  void smooth_creases() {
    std::vector<Vec3f> sums(mesh_.positions.size(), Vec3f(0.0f));
    for (const mesh::Triangle& t : mesh_.triangles) {
      const Vec3f& a = mesh_.positions[t[0]];
      const Vec3f n = (mesh_.positions[t[1]] - a).cross(mesh_.positions[t[2]] - a);
      for (const uint32_t v : t) sums[v] += n;
    }
    const auto cosine = static_cast<float>(maths::cos(kSharpAngle * kPi / 180));
    parallel_for(
        sums.size(),
        [&](size_t v) {
          const float size = sums[v].length();
          if (size > 0 && sums[v].dot(mesh_.normals[v]) < cosine * size)
            mesh_.normals[v] = sums[v] / size;
        },
        kTask);
  }

  const field::Field& field_;
  const DiceOptions& options_;
  Progress& progress_;
  mesh::Mesh mesh_;                ///< Its triangles are in `active_` and `done_`.
  std::vector<Vec3f> directions_;  ///< Smooth normals, along which vertices move.
  std::vector<float> lengths_;     ///< The edge length at each vertex.
  std::vector<mesh::Triangle> active_;
  std::vector<mesh::Triangle> done_;  ///< Triangles without long edges.
  DiceReport report_;
};

}  // namespace

DiceResult dice(const mesh::Mesh& mesh, const field::Field& field, const DiceOptions& options,
                Progress& progress) {
  if (mesh.triangles.empty()) return {mesh, {}};
  Dicer dicer(mesh, field, options, progress);
  dicer.move_vertices();
  for (int level = 0; level < options.levels && dicer.divide(); ++level) progress.check();
  return dicer.result();
}

}  // namespace vug::meshing
