// SPDX-License-Identifier: Apache-2.0
// The keys of products in a store, and the epochs of their kinds.
#pragma once

#include <vug/shot/shot.h>
#include <vug/store/key.h>
#include <vug/volume/level_set.h>

namespace vug::building {

/// The kinds of products that are stored. Increase the epoch of a kind in the same change as the
/// code that alters bytes of its products, or their files; tests/unit/building/epoch_test.cpp
/// fails otherwise. A change of fields alters level sets and meshes.
inline const store::ProductKind kLevelSetKind{"level_set", 3};
inline const store::ProductKind kMeshKind{"mesh", 4};
inline const store::ProductKind kCellMeshKind{"cell_mesh", 1};
inline const store::ProductKind kDripGraphKind{"drip_graph", 1};
inline const store::ProductKind kGrownFormsKind{"grown_forms", 1};

/// The key of the level set of the plan's field, or of `source` if the plan voxelises a mesh.
store::Key level_set_key(const shot::VolumePlan& plan, const mesh::Mesh* source = nullptr);
/// The key of make_surface_mesh for a plan whose volume has a field. Drafts are not polished.
store::Key surface_mesh_key(const shot::MeshPlan& plan, bool draft);
/// The same for a plan whose volume voxelises a mesh.
store::Key surface_mesh_key(const shot::MeshPlan& plan, bool draft,
                            const volume::LevelSet& surface);

/// The keys of the graph and of the forms of drips with these inputs, see shot::DripsPlan::digest.
store::Key drip_graph_key(const Digest& inputs);
store::Key grown_forms_key(const Digest& inputs);

}  // namespace vug::building
