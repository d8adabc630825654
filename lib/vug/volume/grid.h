// SPDX-License-Identifier: Apache-2.0
// A handle to a sparse grid with its name, class and metadata, as stored in files.
#pragma once

#include <vug/base/hash.h>
#include <vug/base/vec.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>

namespace vug::volume {

/// Meaning of a grid's values, by which programs that read the file decide how to render it.
enum class GridClass { unknown, level_set, fog, staggered };

std::string to_string(GridClass grid_class);

using MetaValue = std::variant<bool, int64_t, double, std::string>;
using Metadata = std::map<std::string, MetaValue>;

struct Statistics {
  uint64_t active_voxels = 0;
  uint64_t leaves = 0;        ///< Dense blocks of 8^3 voxels.
  uint64_t memory_bytes = 0;  ///< Current memory use.
  Vec3i index_min{0, 0,
                  0};  ///< Inclusive bounds of the active voxels; undefined without active voxels.
  Vec3i index_max{-1, -1, -1};
  Box3d bounds;  ///< World-space box around the centres of the active voxels; empty without active
                 ///< voxels.
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
  /// Digest of the content: transform, topology and values, independent of the name and metadata.
  Digest content() const;

  Grid named(const std::string& name) const;
  /// Replaces metadata of the same names and keeps the rest.
  Grid with(const Metadata& metadata) const;
  /// Whether files store its floats as 16 bits.
  Grid stored_as_half(bool half) const;

  const Data& data() const { return *data_; }

 protected:
  std::shared_ptr<const Data> data_;
};

}  // namespace vug::volume
