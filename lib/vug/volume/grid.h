// A handle to any sparse grid, with its name, class and metadata: what files hold.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/vec.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>

namespace vug::volume {

/// What a grid's values mean; programs that read the file decide by it how to draw them.
enum class GridClass { unknown, level_set, fog, staggered };

std::string to_string(GridClass grid_class);

using MetaValue = std::variant<bool, int64_t, double, std::string>;
using Metadata = std::map<std::string, MetaValue>;

struct Statistics {
  uint64_t active_voxels = 0;
  uint64_t leaves = 0;        ///< Dense blocks of 8^3 voxels.
  uint64_t memory_bytes = 0;  ///< In memory now.
  Vec3i index_min{0, 0, 0};   ///< Active voxels, inclusive; meaningless without any.
  Vec3i index_max{-1, -1, -1};
  Box3d bounds;  ///< World box around the centres of the active voxels; empty without any.
};

/// Immutable and shared: copies are cheap and refer to the same voxels.
class Grid {
 public:
  struct Data;  // the OpenVDB grid; see grid_access.h

  explicit Grid(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::string name() const;
  GridClass grid_class() const;
  std::string value_type() const;  ///< "float", "vec3s", ...
  Vec3d voxel_size() const;        ///< Metres along the index axes.
  bool saved_as_half() const;
  Metadata metadata() const;
  Statistics statistics() const;
  /// Identity of the content: transform, topology and values, whatever the name and metadata.
  Digest content() const;

  Grid named(const std::string& name) const;
  /// Metadata of that name is replaced, other metadata kept.
  Grid with(const Metadata& metadata) const;
  /// Files will hold its floats as 16 bits, or as they are.
  Grid stored_as_half(bool half) const;

  const Data& data() const { return *data_; }

 protected:
  std::shared_ptr<const Data> data_;
};

}  // namespace vug::volume
