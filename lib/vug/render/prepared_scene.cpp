// SPDX-License-Identifier: Apache-2.0
#include <vug/render/geometry/geometry.h>
#include <vug/render/prepared_scene.h>

namespace vug::render {
namespace {

std::vector<LightPtr> joined(std::vector<LightPtr> lights, const std::vector<LightPtr>& more) {
  lights.insert(lights.end(), more.begin(), more.end());
  return lights;
}

}  // namespace

PreparedScene::PreparedScene(const Scene& scene, const PreparedScene* before)
    : geometry_(
          std::make_shared<Geometry>(scene.objects, before ? before->geometry_.get() : nullptr)),
      lights_(std::make_shared<const LightSet>(scene.lights, scene.objects, scene.omitted)) {
  medium_ = scene.medium;
  if (medium_)
    if (MediumPtr fitted = medium_->with_bounds(geometry_->bounds)) medium_ = fitted;
}

PreparedScene::PreparedScene(const PreparedScene& other, const Scene& scene,
                             const std::vector<LightPtr>& more)
    : geometry_(other.geometry_),
      lights_(std::make_shared<const LightSet>(joined(scene.lights, more), scene.objects,
                                               scene.omitted)),
      medium_(other.medium_) {}

PreparedScene::PreparedScene(const PreparedScene& other, float time)
    : geometry_(other.geometry_), lights_(other.lights_), medium_(other.medium_), time_(time) {}

PreparedScene::~PreparedScene() = default;

bool PreparedScene::intersect(const Ray& ray, float distance, Hit& hit, void (*work)(const void*),
                              const void* what) const {
  const Geometry::Intersection found = geometry_->intersect(ray, distance, time_);
  work(what);
  return geometry_->fill_hit(found, ray, time_, hit);
}
bool PreparedScene::occluded(const Ray& ray, float distance) const {
  return geometry_->occluded(ray, distance, time_);
}
const TreeCounts& PreparedScene::trees() const { return geometry_->trees; }
bool PreparedScene::moves() const { return geometry_->moves; }
const Box3f& PreparedScene::bounds() const { return geometry_->bounds; }

}  // namespace vug::render
