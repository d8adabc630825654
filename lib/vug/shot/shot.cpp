// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/shot.h>

namespace vug::shot {
namespace {

/// Calls `with` for each pair of lists; the only enumeration of all lists.
template <class A, class B, class With>
void with_lists(A& a, B& b, const With& with) {
  with(a.networks, b.networks);
  with(a.drips, b.drips);
  with(a.volumes, b.volumes);
  with(a.meshes, b.meshes);
  with(a.objects, b.objects);
  with(a.instancers, b.instancers);
  with(a.cameras, b.cameras);
  with(a.lights, b.lights);
  with(a.media, b.media);
  with(a.materials, b.materials);
  with(a.renders, b.renders);
  with(a.derivations, b.derivations);
  with(a.lsystems, b.lsystems);
}

}  // namespace

MeshPtr plain_mesh(const VolumePtr& volume) {
  MeshPlan plan;
  plan.name = volume->name;
  plan.volume = volume;
  return std::make_shared<const MeshPlan>(std::move(plan));
}

Shot::Snapshot Shot::snapshot() const {
  Snapshot out;
  with_lists(*this, *this,
             [&](const auto& list, const auto&) { out.lists.push_back(list.size()); });
  return out;
}

Shot Shot::delta(const Snapshot& snapshot) const {
  Shot out;
  size_t i = 0;
  with_lists(*this, out, [&](const auto& from, auto& to) {
    to.assign(from.begin() + static_cast<std::ptrdiff_t>(snapshot.lists.at(i++)), from.end());
  });
  return out;
}

void Shot::add(const Shot& more) {
  with_lists(more, *this,
             [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); });
}

}  // namespace vug::shot
