// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/parallel.h>
#include <vug/mesh/distance.h>
#include <vug/mesh/shells.h>
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
#include <utility>
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

void require_closed(const mesh::Mesh& mesh) {
  const size_t open = mesh::inspect(mesh::welded(mesh)).boundary_edges;
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
  const mesh::MeshDistance exact(mesh::welded(mesh));
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

/// Voxelizes the shells of a mesh from the largest to the smallest, because OpenVDB fills whatever
/// a surface encloses. A shell is a cavity if its normals point into the space that it encloses and
/// it lies in the solid of the larger shells.
class ShellVoxelizer {
 public:
  ShellVoxelizer(openvdb::util::NullInterrupter& interrupter, double voxel, float band)
      : interrupter_(interrupter),
        voxel_(voxel),
        band_(band),
        lattice_(openvdb::math::Transform::createLinearTransform(voxel)) {}

  openvdb::FloatGrid::Ptr run(const mesh::Mesh& mesh) {
    std::vector<mesh::Shell> shells = mesh::shells(mesh::welded(mesh));
    // If the normals of the largest shell point inwards, all normals are taken as reversed.
    const double outward = !shells.empty() && shells[0].volume < 0 ? -1 : 1;
    const bool solid = std::all_of(shells.begin(), shells.end(), [&](const mesh::Shell& shell) {
      return outward * shell.volume >= 0;
    });
    if (solid) return whole(mesh);
    for (const mesh::Shell& shell : shells) {
      const bool cavity = outward * shell.volume < 0 && holds(shell);
      if (cavity != removes_) merge();
      removes_ = cavity;
      append(shell.surface);
    }
    merge();
    return grid_;
  }

 private:
  openvdb::FloatGrid::Ptr whole(const mesh::Mesh& mesh) const {
    return voxelized(interrupter_, LatticeMesh(mesh, voxel_), *lattice_, band_);
  }
  void append(const mesh::Mesh& surface) {
    const auto first = static_cast<uint32_t>(pending_.positions.size());
    pending_.positions.insert(pending_.positions.end(), surface.positions.begin(),
                              surface.positions.end());
    for (const mesh::Triangle& t : surface.triangles)
      pending_.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  /// Whether the larger shells before this one contain it.
  bool holds(const mesh::Shell& shell) {
    if (!removes_) merge();
    const Vec3d p = Vec3d(shell.surface.positions[0]) / voxel_;
    return grid_->tree().getValue(openvdb::Coord::round(openvdb::Vec3d(p.x, p.y, p.z))) < 0;
  }
  /// Adds the pending shells to the solid, or removes them from it.
  void merge() {
    if (pending_.triangles.empty()) return;
    const openvdb::FloatGrid::Ptr next = whole(std::exchange(pending_, {}));
    if (!grid_)
      grid_ = next;
    else if (removes_)
      openvdb::tools::csgDifference(*grid_, *next);
    else
      openvdb::tools::csgUnion(*grid_, *next);
  }

  openvdb::util::NullInterrupter& interrupter_;
  double voxel_;
  float band_;
  openvdb::math::Transform::Ptr lattice_;
  openvdb::FloatGrid::Ptr grid_;
  mesh::Mesh pending_;
  bool removes_ = false;
};

}  // namespace

double from_mesh_bytes(double area, const FromMeshOptions& options) {
  constexpr double kActiveBytes = 40;  // A distance and a triangle index, in partly filled leaves.
  return kActiveBytes * 2 * options.half_width * area / (options.voxel * options.voxel);
}

LevelSet from_mesh(const mesh::Mesh& mesh, const FromMeshOptions& options, Progress& progress) {
  initialise_openvdb();
  require_closed(mesh);
  require_on_lattice(mesh, options);
  const double bytes = from_mesh_bytes(area_of(mesh), options);
  const uint64_t limit = options.max_memory ? options.max_memory : available_memory();
  require_memory(bytes, limit, fmt::format("a level set with voxels of {} m", options.voxel),
                 fitting_voxel_hint(options.voxel, bytes, limit));
  progress.begin("level set of a mesh", 1);
  const auto band = static_cast<float>(options.half_width + 1);
  Interrupter interrupter(progress);
  const auto grid = ShellVoxelizer(interrupter, options.voxel, band).run(mesh);
  progress.check();
  const float background = mesh_background(options);
  if (grid->activeVoxelCount() > 0) make_exact(grid->tree(), mesh, options.voxel, background);
  openvdb::tools::changeLevelSetBackground(grid->tree(), background);
  openvdb::tools::pruneLevelSet(grid->tree());
  progress.check();
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  progress.advance();
  progress.end();
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
