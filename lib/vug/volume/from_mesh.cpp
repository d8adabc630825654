// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/mesh/components.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/topology.h>
#include <vug/mesh/weld.h>
#include <vug/volume/contact.h>
#include <vug/volume/fitting_voxel.h>
#include <vug/volume/from_mesh.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <fmt/format.h>
#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace vug::volume {
namespace {

/// The corners and triangles of a mesh as OpenVDB reads them, the corners in lattice units.
struct LatticeMesh {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;

  LatticeMesh(const mesh::Mesh& mesh, double voxel) {
    points.reserve(mesh.positions.size());
    for (const Vec3f& p : mesh.positions) {
      const Vec3d at = Vec3d(p) / voxel;
      points.emplace_back(static_cast<float>(at.x), static_cast<float>(at.y),
                          static_cast<float>(at.z));
    }
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles)
      triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
};

struct Interrupter final : openvdb::util::NullInterrupter {
  explicit Interrupter(const Progress& watched) : progress(watched) {}
  // NOLINTNEXTLINE(readability-identifier-naming): OpenVDB calls this name.
  bool wasInterrupted(int) override { return progress.cancelled(); }
  const Progress& progress;
};

void require_closed(const mesh::Mesh& welded, const mesh::Edges& edges) {
  const size_t open = mesh::inspect(welded, edges).boundary_edges;
  if (open > 0)
    throw Error(ErrorCode::bad_input,
                fmt::format("a mesh with {} open edges does not bound a solid", open), {},
                "a level set requires a closed mesh");
}

void require_on_lattice(const mesh::Mesh& mesh, const FromMeshOptions& options) {
  constexpr double kFarthest = 2147483647.0 - 8192;
  double farthest = 0;
  for (const Vec3f& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis)
      farthest = std::max(farthest, std::fabs(static_cast<double>(p[axis])));
  if (!(farthest / options.voxel + options.half_width < kFarthest))
    throw Error(
        ErrorCode::bad_input,
        fmt::format("with voxels of {} m the solid extends beyond 2^31 voxels from the origin",
                    options.voxel),
        {}, "use a larger voxel or move the solid to the origin");
}

/// The smallest single-precision number that OpenVDB's check accepts for `half_width` voxels.
float mesh_background(const FromMeshOptions& options) {
  auto background = static_cast<float>(options.half_width * options.voxel);
  while (static_cast<double>(background) / options.voxel < options.half_width)
    background = std::nextafter(background, std::numeric_limits<float>::infinity());
  return background;
}

double area_of(const mesh::Mesh& mesh) {
  double area = 0;
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    area += 0.5 * double_area_vector(mesh, face).length();
  return area;
}

using Tree = openvdb::FloatTree;

/// Whether a neighbour of the voxel is clearly outside.
bool has_outside(const openvdb::tree::ValueAccessor<const Tree, false>& at, const openvdb::Coord& c,
                 float clear) {
  for (int side = 0; side < 6; ++side) {
    openvdb::Coord next = c;
    next[static_cast<size_t>(side / 2)] += side % 2 ? 1 : -1;
    if (at.getValue(next) > clear) return true;
  }
  return false;
}

/// OpenVDB's values deviate by up to a voxel at the edge of the band, and have the wrong sign
/// within a twentieth of a voxel. Distances become exact. Signs remain as determined from far away,
/// except next to the surface, where the triangles decide. Voxels beyond the background become
/// inactive.
void make_exact(Tree& tree, const mesh::Mesh& mesh, double voxel, float background) {
  const mesh::MeshDistance exact(mesh);
  const Tree before(tree);
  const auto clear = static_cast<float>(0.1 * voxel);
  double farthest = 0;
  for (const Vec3f& p : mesh.positions)
    farthest = std::max({farthest, std::fabs(static_cast<double>(p.x)),
                         std::fabs(static_cast<double>(p.y)), std::fabs(static_cast<double>(p.z))});
  const float contact = contact_distance(farthest);
  std::vector<Tree::LeafNodeType*> leaves;
  tree.getNodes(leaves);
  parallel_for(leaves.size(), [&](size_t n) {
    const openvdb::tree::ValueAccessor<const Tree, false> at(before);
    for (auto it = leaves[n]->beginValueOn(); it; ++it) {
      const openvdb::Coord c = it.getCoord();
      const Vec3d p = Vec3d(c.x(), c.y(), c.z()) * voxel;
      const auto closest = exact.closest(p);
      bool inside = *it < 0;
      if (std::fabs(*it) < clear && has_outside(at, c, clear))
        inside = (p - closest.point).dot(closest.normal) < 0;
      const auto distance = static_cast<float>(closest.distance);
      if (distance <= contact) {
        it.setValue(-std::max(distance, kLeastDistance));
        continue;
      }
      const float value = std::min(distance, background);
      if (distance < background)
        it.setValue(inside ? -value : value);
      else
        leaves[n]->setValueOff(it.pos(), inside ? -value : value);
    }
  });
}

/// The compiled template of OpenVDB's library; any other would take a minute to compile.
openvdb::FloatGrid::Ptr voxelized(openvdb::util::NullInterrupter& interrupter,
                                  const LatticeMesh& mesh, const openvdb::math::Transform& lattice,
                                  float band) {
  using Adapter = openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I>;
  return openvdb::tools::meshToVolume<openvdb::FloatGrid>(
      interrupter, Adapter(mesh.points, mesh.triangles), lattice, band, band,
      openvdb::tools::DISABLE_RENORMALIZATION);
}

/// The components of a mesh and the volumes that they enclose; see mesh/components.h.
struct Components {
  const mesh::Mesh& mesh;
  std::vector<uint32_t> component_of;
  std::vector<double> volumes;

  Components(const mesh::Mesh& closed, const mesh::Edges& edges)
      : mesh(closed),
        component_of(mesh::face_components(closed, edges)),
        volumes(mesh::component_volumes(closed, component_of)) {
    // If the normals of the largest component point inwards, all normals are taken as reversed.
    const std::vector<uint32_t> order = by_size();
    if (!order.empty() && volumes[order[0]] < 0)
      for (double& volume : volumes) volume = -volume;
  }

  bool all_solid() const {
    return std::all_of(volumes.begin(), volumes.end(), [](double volume) { return volume >= 0; });
  }
  /// The numbers of the components, the largest first.
  std::vector<uint32_t> by_size() const {
    std::vector<uint32_t> out(volumes.size());
    std::iota(out.begin(), out.end(), 0U);
    std::stable_sort(out.begin(), out.end(), [&](uint32_t a, uint32_t b) {
      return std::fabs(volumes[a]) > std::fabs(volumes[b]);
    });
    return out;
  }
  Vec3d point_of(uint32_t component) const {
    const auto face = std::find(component_of.begin(), component_of.end(), component);
    return corners(mesh, static_cast<size_t>(face - component_of.begin()))[0];
  }
};

/// Voxelizes components from the largest to the smallest, because OpenVDB fills whatever a surface
/// encloses. A component is a cavity if its normals point into the space that it encloses and it
/// lies in the solid of the larger ones. `voxelize` makes the grid of a solid.
template <class Voxelize>
class ComponentVoxelizer {
 public:
  ComponentVoxelizer(const Components& parts, const Voxelize& voxelize)
      : parts_(parts), voxelize_(voxelize), pending_(parts.volumes.size()) {}

  openvdb::FloatGrid::Ptr run() && {
    for (const uint32_t component : parts_.by_size()) {
      const bool cavity = parts_.volumes[component] < 0 && is_inside(parts_.point_of(component));
      if (cavity != removes_) merge();
      removes_ = cavity;
      pending_[component] = 1;
    }
    merge();
    return solid_;
  }

 private:
  /// Whether a point lies in the solid of all larger components.
  bool is_inside(const Vec3d& point) {
    if (!removes_) merge();
    const openvdb::Vec3d at(point.x, point.y, point.z);
    return solid_->tree().getValue(openvdb::Coord::round(solid_->worldToIndex(at))) < 0;
  }
  /// Adds the pending components to the solid, or removes them from it.
  void merge() {
    if (std::count(pending_.begin(), pending_.end(), 1) == 0) return;
    const openvdb::FloatGrid::Ptr next =
        voxelize_(mesh::remaining(parts_.mesh, parts_.component_of, pending_));
    pending_.assign(pending_.size(), 0);
    if (!solid_)
      solid_ = next;
    else if (removes_)
      openvdb::tools::csgDifference(*solid_, *next);
    else
      openvdb::tools::csgUnion(*solid_, *next);
  }

  const Components& parts_;
  const Voxelize& voxelize_;
  openvdb::FloatGrid::Ptr solid_;
  std::vector<char> pending_;  // For each component whether it is in the next merge.
  bool removes_ = false;
};

}  // namespace

double from_mesh_bytes(double area, const FromMeshOptions& options) {
  constexpr double kActiveBytes = 40;  // A distance and a triangle index, in partly filled leaves.
  return kActiveBytes * 2 * options.half_width * area / (options.voxel * options.voxel);
}

LevelSet from_mesh(const mesh::Mesh& mesh, const FromMeshOptions& options, Progress& progress) {
  initialise_openvdb();
  const mesh::Mesh closed = mesh::welded(mesh);
  const mesh::Edges edges = mesh::find_edges(closed);
  require_closed(closed, edges);
  require_on_lattice(mesh, options);
  const double bytes = from_mesh_bytes(area_of(mesh), options);
  const uint64_t limit = options.max_memory ? options.max_memory : available_memory();
  require_memory(bytes, limit, fmt::format("a level set with voxels of {} m", options.voxel),
                 fitting_voxel_hint(options.voxel, bytes, limit));
  progress.begin("level set of a mesh", 1);
  const auto lattice = openvdb::math::Transform::createLinearTransform(options.voxel);
  const auto band = static_cast<float>(options.half_width + 1);
  Interrupter interrupter(progress);
  const auto voxelize = [&](const mesh::Mesh& solid) {
    return voxelized(interrupter, LatticeMesh(solid, options.voxel), *lattice, band);
  };
  const Components parts(closed, edges);
  const auto grid = parts.all_solid() ? voxelize(mesh) : ComponentVoxelizer(parts, voxelize).run();
  progress.check();
  const float background = mesh_background(options);
  if (grid->activeVoxelCount() > 0) make_exact(grid->tree(), closed, options.voxel, background);
  openvdb::tools::changeLevelSetBackground(grid->tree(), background);
  openvdb::tools::pruneLevelSet(grid->tree());
  progress.check();
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  progress.advance();
  progress.end();
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
