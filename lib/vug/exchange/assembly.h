// What another program is given, as plain data: everything a scene shows, with names, units, axes
// and where it came from.
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

/// Right-handed.
struct Space {
  UpAxis up = UpAxis::y;
  double metres_per_unit = 1;

  bool operator==(const Space&) const = default;
};
std::string to_string(UpAxis up);  ///< "y" or "z".

/// What rebuilds it.
struct Provenance {
  std::string recipe;  ///< Scene text.
  uint64_t seed = 0;
  double frame = 1;
  std::string version;  ///< Of Vug.
};

/// A mesh with fewer triangles, and how far it is from the whole one.
struct Level {
  mesh::MeshPtr mesh;
  double distance = 0;  ///< Hausdorff, in the assembly's units.
};

/// A mesh with its look. What varies over it is an attribute of the mesh: see `channels` in
/// channels.h; the look then holds the mean.
struct Prototype {
  std::string name;
  mesh::MeshPtr mesh;
  std::string material;  ///< Its name.
  Look look;
  std::vector<Level> coarser;  ///< From fine to coarse.
};

/// Where a part stands, once or many times.
struct InstanceGroup {
  std::string name;
  size_t prototype = 0;
  std::vector<Transform> places;
};

/// A grid of a .vdb file, which is written apart.
struct VolumeGrid {
  std::string name;
  std::string grid_class;  ///< "level set", "fog volume", ...
  bool color = false;      ///< Vectors in place of numbers.
};
struct Volume {
  std::string name;
  std::string file;  ///< Beside the other files.
  std::vector<VolumeGrid> grids;
  Box3d bounds;
  std::optional<Medium> medium = {};  ///< What they mean, where that is known.
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

/// The box around all parts where they stand.
Box3d bounds(const Assembly& assembly);

/// The same in another space: the one place where axes and units change. Meshes, places, cameras,
/// lamps and boxes are turned and scaled; a dome turns with the axes; radiance stays.
Assembly converted(const Assembly& assembly, const Space& to);
/// From points of one space to those of another.
Transform space_transform(const Space& from, const Space& to);

}  // namespace vug::exchange
