// SPDX-License-Identifier: Apache-2.0
// The export data model: everything that a scene shows, as plain data with names, units, axes and
// provenance.
#pragma once

#include <vug/exchange/camera.h>
#include <vug/exchange/light.h>
#include <vug/exchange/look.h>
#include <vug/exchange/medium.h>
#include <vug/mesh/mesh.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug::exchange {

enum class UpAxis { y, z };

/// A right-handed coordinate system.
struct Space {
  UpAxis up = UpAxis::y;
  double metres_per_unit = 1;

  bool operator==(const Space&) const = default;
};
std::string to_string(UpAxis up);  ///< "y" or "z".

/// Everything needed to reproduce the assembly.
struct Provenance {
  std::string recipe;  ///< Scene text.
  uint64_t seed = 0;
  double frame = 1;
  std::string version;  ///< Version of Vug.
};

/// A level of detail: a mesh with fewer triangles and its distance from the full mesh.
struct Level {
  mesh::MeshPtr mesh;
  double distance = 0;  ///< Hausdorff distance in the assembly's units.
};

/// A mesh with its look, as a prototype for instances. Properties that vary over the surface are
/// attributes of the mesh (see `channels` in channels.h); the look then contains their mean.
struct Prototype {
  std::string name;
  mesh::MeshPtr mesh;
  std::string material;  ///< Name of the material.
  Look look;
  std::vector<Level> coarser;  ///< From fine to coarse.
  /// The means over the triangles of each rock material of the mesh, ordered by name; none for a
  /// mesh without weights of rocks.
  std::vector<RockLook> rocks = {};
};

/// The prototype with the look and the name "MATERIAL_ROCK" of one of its rocks.
Prototype of_rock(const Prototype& prototype, const RockLook& rock);

/// One or many instances of a prototype.
struct InstanceGroup {
  std::string name;
  size_t prototype = 0;
  std::vector<Transform> places;
};

/// A grid of a .vdb file; the file is written separately.
struct VolumeGrid {
  std::string name;
  std::string grid_class;  ///< "level set", "fog volume", ...
  bool color = false;      ///< Vectors instead of numbers.
  bool whole = false;      ///< Whole numbers, such as the numbers of materials.
};
struct Volume {
  std::string name;
  std::string file;  ///< In the folder of the other files.
  std::vector<VolumeGrid> grids;
  Box3d bounds;
  std::optional<Medium> medium = {};  ///< Interpretation of the grids, if known.
};

struct Assembly {
  std::string name;
  Space space;
  Provenance provenance;
  std::vector<Prototype> prototypes;
  std::vector<InstanceGroup> groups;
  std::vector<Volume> volumes;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
};

/// The bounding box of all instances.
Box3d bounds(const Assembly& assembly);

/// Converts to another space. This is the only function that changes axes and units: meshes,
/// instances, cameras, lights and boxes are rotated and scaled; a dome rotates with the axes;
/// radiance is unchanged.
Assembly converted(const Assembly& assembly, const Space& to);
/// The transform of points from one space to another.
Transform space_transform(const Space& from, const Space& to);

}  // namespace vug::exchange
