#include <vug/render/paths/explore.h>
#include <vug/render/paths/guided.h>
#include <vug/render/paths/vertex.h>

namespace vug::render {

void explore(const World& world, const Ray& camera_ray, SampleCursor& numbers, int bounces,
             const Guide* guide, const RadianceCache& brightness, GuideTraining& training) {
  constexpr uint32_t kCamera = 2, kBounce = 3;
  Ray ray = camera_ray;
  Hit hit;
  if (!world.intersect(ray, hit)) return;
  for (int depth = 0; depth < bounces; ++depth) {
    numbers.jump(kCamera + kBounce * static_cast<uint32_t>(depth));
    const Frame frame(hit.surface.shading_normal);
    BsdfMemory memory;
    const Bsdf& own = hit.material->at(hit.surface, frame.to_local(-ray.direction), memory);
    const GuidedBsdf bsdf(own, frame, guide ? guide->at(hit.surface.position) : nullptr);
    const float lobe = numbers.single();
    const GuidedBsdf::Sample s = bsdf.sample(lobe, numbers.pair());
    if (!(s.scattered.pdf > 0)) return;
    const Vec3f from = hit.surface.position;
    const bool passes = s.scattered.direction.z < 0;
    ray = {passes ? hit.behind : hit.origin, s.direction};
    const float weight = std::fabs(s.scattered.direction.z) / s.scattered.pdf;
    if (!world.intersect(ray, hit)) {
      // The sky counts as far as it is not found by choosing it.
      const LitPoint point{ray.origin, hit.surface.geometric_normal, hit.object};
      const PathVertex vertex{PathVertex::surface, point, s.scattered.pdf,
                              world.lights().choose(point, 0).odds};
      TrackingNumbers through(numbers.pair());
      training.record(from, ray.direction,
                      weight * luminance(sky_met(world, ray, vertex, through, nullptr)));
      return;
    }
    training.record(
        from, ray.direction,
        weight * brightness.radiance(hit.surface.position, hit.surface.geometric_normal));
    if (!(numbers.single() < largest(s.unled))) return;
  }
}

}  // namespace vug::render
