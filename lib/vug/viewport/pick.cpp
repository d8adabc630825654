// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/document.h>
#include <vug/viewport/pick.h>

namespace vug::viewport {
namespace {

/// The declarations of "OBJECT", "PLACE", "PLACE/NUMBER" or "PLACE/OBJECT".
std::vector<DeclaredPlace> declarations_of_object(const PreviewScene& scene,
                                                  const std::string& name) {
  for (const std::string& key : {name, name.substr(0, name.find('/'))})
    if (const auto found = scene.declared.find(key); found != scene.declared.end())
      return found->second;
  return {};
}

}  // namespace

std::optional<Pick> pick(const PickScene& scene, double x, double y) {
  const Vec2f film(static_cast<float>(x), static_cast<float>(y));
  const render::Ray ray = scene.camera->ray(film, static_cast<float>(scene.aspect), {0.5f, 0.5f});
  render::Hit hit;
  if (!scene.world->intersect(ray, hit)) return std::nullopt;
  const render::Object& object = scene.scene->job.scene.objects.at(hit.object);
  Pick out;
  out.object = object.name;
  out.material = object.material_name;
  out.position = Vec3d(hit.surface.position);
  out.normal = Vec3d(hit.surface.shading_normal);
  out.distance = static_cast<double>(hit.distance);
  out.triangle = hit.triangle;
  out.declared = declarations_of_object(*scene.scene, object.name);
  return out;
}

}  // namespace vug::viewport
