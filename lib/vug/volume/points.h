// Points with attributes as plain arrays, and as grids that .vdb files hold.
#pragma once

#include <vug/volume/grid.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace vug::volume {

/// One value a point.
struct PointAttribute {
  using Values = std::variant<std::vector<float>, std::vector<Vec3f>, std::vector<int32_t>>;

  std::string name;  ///< As programs know them: N, Cd, pscale, id, ...
  Values values;
  bool half = false;  ///< Numbers go into 16 bits, unless one of them is too large for that.

  size_t size() const;
  bool operator==(const PointAttribute&) const = default;
};

/// A set of points.
struct PointGroup {
  std::string name;
  std::vector<uint8_t> member;  ///< 1 for each point that belongs to it, else 0.

  bool operator==(const PointGroup&) const = default;
};

struct Points {
  std::vector<Vec3f> position;  ///< Metres, in world space.
  std::vector<PointAttribute> attributes;
  std::vector<PointGroup> groups;

  size_t size() const { return position.size(); }
  const PointAttribute* find(const std::string& name) const;
  /// The values of an attribute; Error(bad_input), with what there is, where there is none of that
  /// name or it is of another type.
  template <class T>
  const std::vector<T>& values(const std::string& name) const;
  /// The members of a group; Error(bad_input) likewise.
  const std::vector<uint8_t>& members(const std::string& name) const;
  bool operator==(const Points&) const = default;
};

/// An edge for voxels such that about 12 points share one that they lie in, where each stands for
/// so many square metres of a surface.
double voxel_for_points(double area_each);

/// Positions are stored as 16 bits an axis: up to half a voxel / 65535 off. Points of one voxel
/// keep their order; voxels have that of the tree. The same grid for any number of threads.
/// Error(bad_input) for arrays that differ in length, names that are used twice or that OpenVDB
/// does not take, positions that are not finite or too many voxels away.
Grid point_grid(const Points& points, double voxel);

/// Whether the grid holds points.
bool is_points(const Grid& grid);

/// The points of a grid of any origin, in its order; of its attributes those that are numbers of 32
/// or 64 bits, vectors of three of them, or whole numbers of up to 32 bits. Error(bad_input) for a
/// grid without points.
Points points(const Grid& grid);

/// Points of a .vdb file: of the grid of that name, or of its first that holds any.
/// Error(bad_input), naming the path, for a file without.
Points read_points(const std::filesystem::path& source, const std::string& name = {});

struct PointsInfo {
  struct Attribute {
    std::string name, type, codec;  ///< As OpenVDB calls them: "N", "vec3s", "trnc".
  };
  struct Group {
    std::string name;
    uint64_t points = 0;
  };
  uint64_t count = 0;
  Box3d bounds;  ///< Of the points themselves; empty without any.
  std::vector<Attribute> attributes;
  std::vector<Group> groups;  ///< By name.
};
PointsInfo points_info(const Grid& grid);

Digest digest(const Points& points);

}  // namespace vug::volume
