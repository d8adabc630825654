#include <vug/render/geometry.h>
#include <vug/render/world.h>

namespace vug::render {
World::World(const Scene& scene)
    : geometry_(std::make_unique<Geometry>(scene.objects)), owned_(scene.lights) {
  bool portals = false;
  for (const LightPtr& light : owned_) {
    if (!light) continue;
    if (!light->is_sky()) lamps_.push_back(light.get());
    if (light->is_sky() && !light->is_portal()) skies_.push_back(light.get());
    portals |= light->is_portal();
  }
  sky_scale_ = 0;
  for (const Light* sky : skies_) sky_scale_ += sky->mean_luminance();
  for (const LightPtr& light : owned_) {
    if (!light) continue;
    // Where portals are, they find the sky better than the sky does.
    if (light->is_sky() && (light->is_portal() != portals || !(sky_scale_ > 0))) continue;
    sampled_.push_back(light.get());
    if (light->is_sky()) sampled_skies_.push_back(light.get());
  }
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

Rgb World::sky_radiance(const Vec3f& direction) const {
  Rgb sum(0.0f);
  for (const Light* sky : skies_) sum += sky->escape_radiance(direction);
  return sum;
}

/// One pass: each light takes the place of those before it with the odds of its weight, and the
/// uniform number is stretched back to [0, 1) each time (Chao 1982, reservoir sampling).
template <class Weight>
LightChoice World::choose_by(float u, const Weight& importance) const {
  LightChoice choice;
  const bool even = u < 0.5f;
  double total = 0, count = 0, chosen = 0;
  double rest = 2 * static_cast<double>(u) - (even ? 0 : 1);
  for (const Light* light : sampled_) {
    const auto w = static_cast<double>(importance(*light));
    if (!(w > 0)) continue;
    total += w;
    count += 1;
    const double odds = even ? 1 / count : w / total;
    if (rest < odds) {
      rest /= odds;
      choice.light = light;
      chosen = w;
    } else {
      rest = (rest - odds) / (1 - odds);
    }
  }
  choice.odds = {false, static_cast<float>(total), static_cast<float>(count)};
  if (choice.light) choice.probability = choice.odds.of(static_cast<float>(chosen));
  return choice;
}

LightChoice World::choose(const LitPoint& point, float u) const {
  return choose_by(u, [&](const Light& light) { return importance(light, point); });
}

LightChoice World::choose_along(const Ray& ray, const Segment& segment, float u) const {
  return choose_by(u, [&](const Light& light) { return importance_along(light, ray, segment); });
}

float World::importance(const Light& light, const LitPoint& point) const {
  return (light.is_sky() ? sky_scale_ : 1) * light.importance(point);
}

float World::importance_along(const Light& light, const Ray& ray, const Segment& segment) const {
  return (light.is_sky() ? sky_scale_ : 1) *
         light.importance_along(ray, segment.begin, segment.end);
}

float World::sky_pdf(const LitPoint& point, const LightOdds& odds, const Vec3f& direction) const {
  float sum = 0;
  for (const Light* light : sampled_skies_)
    if (const float samples = odds.of(importance(*light, point)); samples > 0)
      sum += samples * light->pdf(point, direction);
  return sum;
}

}  // namespace vug::render
