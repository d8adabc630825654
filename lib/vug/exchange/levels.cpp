// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/exchange/levels.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/weld.h>

#include <meshoptimizer.h>

#include <algorithm>

namespace vug::exchange {
namespace {

/// A level is useful only if it is still a closed surface and has clearly fewer triangles than the
/// previous one: at most this fraction.
constexpr size_t kFewest = 4;
constexpr double kAtMost = 0.75;

/// The maximum distance of a mesh's points from the other mesh.
double farthest(const mesh::Mesh& from, const mesh::MeshDistance& to) {
  const auto most = [](double a, double b) { return std::max(a, b); };
  const auto distance = [&](const Vec3d& p) { return to.closest(p).distance; };
  const double corners = ordered_reduce(
      from.positions.size(), 0.0, [&](size_t i) { return distance(Vec3d(from.positions[i])); },
      most);
  const double middles = ordered_reduce(
      from.triangles.size(), 0.0,
      [&](size_t i) {
        const auto p = mesh::corners(from, i);
        double out = distance((p[0] + p[1] + p[2]) / 3);
        for (size_t k = 0; k < 3; ++k) out = std::max(out, distance((p[k] + p[(k + 1) % 3]) * 0.5));
        return out;
      },
      most);
  return std::max(corners, middles);
}

}  // namespace

mesh::Mesh coarser(const mesh::Mesh& mesh, double share) {
  if (mesh.triangles.empty()) return mesh;
  const size_t indices = 3 * mesh.triangles.size();
  const size_t wanted = static_cast<size_t>(static_cast<double>(indices) * share) / 3 * 3;
  std::vector<mesh::Triangle> triangles(mesh.triangles.size());
  constexpr float kAnyError =
      1;  // Relative to the extent of the mesh: the number of triangles decides.
  const size_t left =
      meshopt_simplify(triangles[0].data(), mesh.triangles[0].data(), indices, &mesh.positions[0].x,
                       mesh.positions.size(), sizeof(Vec3f), wanted, kAnyError, 0, nullptr);
  triangles.resize(left / 3);
  mesh::Mesh out = mesh;
  out.triangles = std::move(triangles);
  return mesh::without_unused_vertices(out);
}

double hausdorff_distance(const mesh::Mesh& a, const mesh::Mesh& b) {
  if (a.triangles.empty() || b.triangles.empty()) return 0;
  return std::max(farthest(a, mesh::MeshDistance(b)), farthest(b, mesh::MeshDistance(a)));
}

void add_levels(Assembly& assembly, int count, Progress& progress) {
  progress.begin("levels of detail", assembly.prototypes.size() * static_cast<uint64_t>(count));
  for (Prototype& prototype : assembly.prototypes) {
    prototype.coarser.clear();
    mesh::MeshPtr finer = prototype.mesh;
    for (int i = 0; i < count; ++i) {
      progress.check();
      mesh::Mesh made = coarser(*finer);
      const auto most = kAtMost * static_cast<double>(finer->triangles.size());
      if (made.triangles.size() < kFewest || static_cast<double>(made.triangles.size()) > most)
        break;
      const double distance = hausdorff_distance(*prototype.mesh, made);
      finer = std::make_shared<const mesh::Mesh>(std::move(made));
      prototype.coarser.push_back({finer, distance});
      progress.advance();
    }
  }
  progress.end();
}

Assembly at_level(const Assembly& assembly, int number) {
  Assembly out = assembly;
  for (Prototype& prototype : out.prototypes) {
    if (!prototype.coarser.empty())
      prototype.mesh =
          prototype.coarser[std::min(static_cast<size_t>(number), prototype.coarser.size()) - 1]
              .mesh;
    prototype.coarser.clear();
  }
  return out;
}

}  // namespace vug::exchange
