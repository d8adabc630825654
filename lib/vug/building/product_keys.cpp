// SPDX-License-Identifier: Apache-2.0
#include <vug/building/product_keys.h>

namespace vug::building {
namespace {

/// All members of the plan that determine the samples; the others name the product, or say what
/// files contain.
void add_samples_of(const shot::VolumePlan& plan, store::Key& key) {
  key.add("field", plan.field)
      .add("voxel", plan.voxel)
      .add("half_width", plan.half_width)
      .add("repair", plan.repair)
      .add("region", plan.from, plan.to);
}

store::Key& add_surface_of(const shot::MeshPlan& plan, bool draft, store::Key& key) {
  return key.add("adaptivity", plan.adaptivity)
      .add("polish", plan.polish && !draft)
      .add("topology", plan.topology)
      .add("smallest_piece", plan.smallest_piece);
}

}  // namespace

store::Key level_set_key(const shot::VolumePlan& plan, const mesh::Mesh* source) {
  store::Key key(kLevelSetKind);
  if (source)  // Without attributes, such as colours.
    key.add("mesh", mesh::digest({source->positions, source->triangles, {}, {}}))
        .add("voxel", plan.voxel)
        .add("half_width", plan.half_width);
  else
    add_samples_of(plan, key);
  return key;
}

store::Key surface_mesh_key(const shot::MeshPlan& plan, bool draft) {
  store::Key key(kMeshKind);
  add_samples_of(*plan.volume, key);
  return add_surface_of(plan, draft, key);
}

store::Key surface_mesh_key(const shot::MeshPlan& plan, bool draft,
                            const volume::LevelSet& surface) {
  store::Key key(kMeshKind);
  key.add("volume", surface.content());
  return add_surface_of(plan, draft, key);
}

store::Key drip_graph_key(const Digest& inputs) {
  return store::Key(kDripGraphKind).add("drips", inputs);
}

store::Key grown_forms_key(const Digest& inputs) {
  return store::Key(kGrownFormsKind).add("drips", inputs);
}

}  // namespace vug::building
