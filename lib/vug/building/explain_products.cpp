// SPDX-License-Identifier: Apache-2.0
#include <vug/building/explain_products.h>
#include <vug/building/product_keys.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/queries.h>

#include <set>

namespace vug::building {

std::vector<ProductReport> explain_products(const shot::Shot& shot, const StoreUse& use) {
  std::vector<ProductReport> out;
  const auto add = [&](const store::Key& inputs, const std::string& name) {
    const store::Key key = use.complete(inputs);
    ProductReport report;
    report.kind = key.kind();
    report.name = name;
    if (use.store) {
      report.reused = use.store->contains(key);
      if (const auto before = use.store->recall(use.product_name(name), key))
        report.changed = store::changed_parts(*before, key);
    }
    out.push_back(std::move(report));
  };
  for (const shot::NamedDrips& each : shot.drips) {
    const Digest inputs = each.drips->digest();
    for (const store::Key& key : {drip_graph_key(inputs), grown_forms_key(inputs)}) {
      add(key, each.name);
      // Not every scene needs both.
      if (!out.back().reused && !out.back().changed) out.pop_back();
    }
  }
  for (const shot::VolumePtr& volume : shot.volumes)
    if (!volume->source_mesh) add(level_set_key(*volume), volume->name);
  std::set<shot::MeshPtr> known;
  for (const auto& list : {shot::declared_meshes(shot), shot::shown_meshes(shot)})
    for (const shot::MeshPtr& mesh : list)
      if (known.insert(mesh).second && mesh->volume && !mesh->cells && !mesh->volume->source_mesh)
        add(surface_mesh_key(*mesh, shot.draft), mesh->name);
  return out;
}

}  // namespace vug::building
