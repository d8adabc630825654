#include <vug/render/geometry.h>
#include <vug/render/world.h>

namespace vug::render {
World::World(const Scene& scene)
    : geometry_(std::make_unique<Geometry>(scene.objects)), lights_(scene.lights, scene.objects) {
  medium_ = scene.medium;
  if (medium_)
    if (MediumPtr fitted = medium_->fitted(geometry_->bounds)) medium_ = fitted;
}

World::~World() = default;

bool World::intersect(const Ray& ray, Hit& hit) const { return geometry_->intersect(ray, hit); }
bool World::occluded(const Ray& ray, float distance) const {
  return geometry_->occluded(ray, distance);
}
const Box3f& World::bounds() const { return geometry_->bounds; }

}  // namespace vug::render
