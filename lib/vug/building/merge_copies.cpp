// SPDX-License-Identifier: Apache-2.0
#include <vug/building/merge_copies.h>
#include <vug/flora/merge_instances.h>

#include <map>
#include <tuple>

namespace vug::building {
namespace {

bool can_merge(const render::Object& object) {
  return object.instance && !object.instance->moves() && object.mesh && !object.solid &&
         !object.world_space_material && object.emission == render::Rgb(0.0f) &&
         !(object.material &&
           (object.material->is_emissive() || object.material->refers_to_scene()));
}

Transform object_transform(const render::Object& object) {
  const render::Affine to = object.instance->at(0);
  return {Vec3d(to.x), Vec3d(to.y), Vec3d(to.z), Vec3d(to.origin)};
}

}  // namespace

std::vector<render::Object> merge_copies(const std::vector<render::Object>& objects) {
  using Alike = std::tuple<const mesh::Mesh*, const render::Material*, std::string, bool>;
  struct Group {
    size_t at = 0;  ///< Index in the result.
    std::vector<flora::MeshInstance> copies;
  };
  std::vector<render::Object> out;
  std::map<Alike, Group> groups;  // looked up by equal properties
  std::vector<Group*> of;         // group of each result; null: none
  for (const render::Object& object : objects) {
    if (!can_merge(object)) {
      out.push_back(object), of.push_back(nullptr);
      continue;
    }
    Group& group = groups[{object.mesh.get(), object.material.get(), object.name, object.flat}];
    if (group.copies.empty()) {
      group.at = out.size();
      out.push_back(object), of.push_back(&group);
    }
    group.copies.push_back({0, object_transform(object), RandomKey(group.copies.size())});
  }
  for (size_t i = 0; i < out.size(); ++i) {
    if (!of[i] || of[i]->copies.size() < 2) continue;
    out[i].mesh =
        std::make_shared<const mesh::Mesh>(flora::merge_instances({*out[i].mesh}, of[i]->copies));
    out[i].instance = nullptr;
  }
  return out;
}

}  // namespace vug::building
