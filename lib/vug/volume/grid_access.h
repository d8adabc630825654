// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: access to the OpenVDB grid of a handle. Uses forward declarations, so that
// OpenVDB's headers stay in .cpp files.
#pragma once

#include <vug/volume/grid.h>

namespace openvdb {
namespace v10_0 {
class GridBase;
class MetaMap;
}  // namespace v10_0
using namespace v10_0;  // as OpenVDB's own headers do
}  // namespace openvdb

namespace vug::volume {

struct Grid::Data {
  std::shared_ptr<const openvdb::GridBase> grid;
};

/// Registers OpenVDB's types once. Every function that creates or reads grids calls it first.
void initialise_openvdb();

/// Converts metadata of a grid or file in both directions; unknown types become text.
Metadata read_metadata(const openvdb::MetaMap& map);
void write_metadata(openvdb::MetaMap& map, const Metadata& metadata);

Grid wrap(std::shared_ptr<const openvdb::GridBase> grid);

}  // namespace vug::volume
