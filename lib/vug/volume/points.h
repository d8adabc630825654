// SPDX-License-Identifier: Apache-2.0
// Points with attributes, as plain arrays and as grids of .vdb files.
#pragma once

#include <vug/volume/grid.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace vug::volume {

/// One value per point.
struct PointAttribute {
  using Values = std::variant<std::vector<float>, std::vector<Vec3f>, std::vector<int32_t>>;

  std::string name;  ///< Conventional name: N, Cd, pscale, id, ...
  Values values;
  bool half = false;  ///< Store as 16 bits unless a value is too large.

  size_t size() const;
  bool operator==(const PointAttribute&) const = default;
};

/// A subset of the points.
struct PointGroup {
  std::string name;
  std::vector<uint8_t> member;  ///< 1 for each member, otherwise 0.

  bool operator==(const PointGroup&) const = default;
};

struct Points {
  std::vector<Vec3f> position;  ///< World space, metres.
  std::vector<PointAttribute> attributes;
  std::vector<PointGroup> groups;

  size_t size() const { return position.size(); }
  const PointAttribute* find(const std::string& name) const;
  /// The values of an attribute. Throws Error(bad_input), listing the existing attributes, for an
  /// unknown name or a different type.
  template <class T>
  const std::vector<T>& values(const std::string& name) const;
  /// The members of a group; throws Error(bad_input) as `values` does.
  const std::vector<uint8_t>& members(const std::string& name) const;
  bool operator==(const Points&) const = default;
};

/// A voxel size with about 12 points per occupied voxel, if each point represents this area of a
/// surface in square metres.
double voxel_for_points(double area_each);

/// Positions are stored with 16 bits per axis: the error is at most half a voxel / 65535. Points of
/// one voxel keep their order; voxels are in tree order. The grid is the same for any number of
/// threads. Throws Error(bad_input) for arrays of different lengths, duplicate names, names that
/// OpenVDB does not accept, and positions that are not finite or too many voxels away.
Grid point_grid(const Points& points, double voxel);

/// Whether the grid contains points.
bool is_points(const Grid& grid);

/// The points of a grid of any origin, in its order. Attributes are included if they are numbers of
/// 32 or 64 bits, vectors of three such numbers, or integers of up to 32 bits. Throws
/// Error(bad_input) for a grid without points.
Points points(const Grid& grid);

/// Reads the points of a .vdb file from the grid of that name, or from the first grid with points.
/// Throws Error(bad_input) with the path for a file without such a grid.
Points read_points(const std::filesystem::path& source, const std::string& name = {});

struct PointsInfo {
  struct Attribute {
    std::string name, type, codec;  ///< OpenVDB's names: "N", "vec3s", "trnc".
  };
  struct Group {
    std::string name;
    uint64_t points = 0;
  };
  uint64_t count = 0;
  Box3d bounds;  ///< Bounds of the points themselves; empty without points.
  std::vector<Attribute> attributes;
  std::vector<Group> groups;  ///< Sorted by name.
};
PointsInfo points_info(const Grid& grid);

Digest digest(const Points& points);

}  // namespace vug::volume
