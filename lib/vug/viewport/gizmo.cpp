// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/light.h>
#include <vug/scene/document.h>
#include <vug/viewport/gizmo.h>

namespace vug::viewport {
namespace {

SourceLocation declared_at(const loading::Loaded& loaded, const std::string& kind,
                           const std::string& name) {
  const auto* found = loaded.provenance.find(kind, scene::name_without_index(name));
  return found ? found->where : SourceLocation();
}

}  // namespace

std::vector<Gizmo> gizmos_of(const loading::Loaded& loaded) {
  std::vector<Gizmo> out;
  for (const auto& [name, light] : loaded.shot.lights) {
    if (light->is_infinite() && !light->is_portal()) continue;
    Gizmo gizmo{"light", name, Vec3d(light->center()), std::nullopt,
                declared_at(loaded, "light", name)};
    exchange::Light data;
    // Measured lights are spheres with a profile.
    if (light->as_data(data) &&
        (data.shape != exchange::Light::Shape::sphere || !data.profile.empty()))
      gizmo.direction = -data.place.column(2);
    out.push_back(std::move(gizmo));
  }
  for (const shot::CameraPlan& plan : loaded.shot.cameras) {
    const Vec3f middle = plan.camera->ray({0.5f, 0.5f}, 1, {0.5f, 0.5f}).direction;
    out.push_back({"camera", plan.name, Vec3d(plan.camera->position()), Vec3d(middle).normalized(),
                   declared_at(loaded, "camera", plan.name)});
  }
  return out;
}

}  // namespace vug::viewport
