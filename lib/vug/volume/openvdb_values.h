// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: typed access to OpenVDB grids. Only .cpp files include this header, because
// OpenVDB's own headers are expensive.
#pragma once

#include <vug/volume/grid_access.h>

#include <openvdb/openvdb.h>

// Their virtual functions are compiled once, in openvdb_values.cpp.
extern template class openvdb::Grid<openvdb::FloatTree>;
extern template class openvdb::Grid<openvdb::Vec3STree>;
extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::Vec3STree::RootNodeType>;

namespace vug::volume {

/// The OpenVDB grid of a handle whose values are known to be floats, such as a level set.
inline const openvdb::FloatGrid& floats(const Grid& grid) {
  return static_cast<const openvdb::FloatGrid&>(*grid.data().grid);
}

/// A value in the type that OpenVDB stores.
inline float stored(float value) { return value; }
inline int32_t stored(int32_t value) { return value; }
inline openvdb::Vec3f stored(const Vec3f& v) { return {v.x, v.y, v.z}; }

}  // namespace vug::volume
