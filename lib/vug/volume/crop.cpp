// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/crop.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/Prune.h>

namespace vug::volume {

void crop(openvdb::GridBase& level_set, const LatticeBox& box) {
  auto& tree = static_cast<openvdb::FloatGrid&>(level_set).tree();
  tree.clip({openvdb::Coord(box.min.x, box.min.y, box.min.z),
             openvdb::Coord(box.max.x, box.max.y, box.max.z)});
  openvdb::tools::prune(tree);  // pruneLevelSet would need a band between inside and outside.
}

}  // namespace vug::volume
