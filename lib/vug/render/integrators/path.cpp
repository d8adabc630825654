// Unidirectional path tracing with next-event estimation. Lamps and sky are found both by
// choosing them and by following the material, weighed by the balance heuristic (Veach 1997,
// "Robust Monte Carlo methods for light transport simulation", section 9.2, cite veach1997).
// In a medium, light that one lamp scatters into the ray is estimated at a distance chosen by
// equiangular sampling (Kulla and Fajardo 2012, "Importance sampling techniques for path tracing
// in participating media", cite kulla2012media) or by the medium itself, half and half.
#include <vug/base/maths.h>
#include <vug/render/kind.h>
#include <vug/render/tally.h>
#include <vug/render/world.h>

#include <algorithm>

namespace vug::render {
namespace {

struct Path {
  int max_bounces = 8;
  bool roulette = true;
  std::optional<double> clamp;

  static void describe(Schema<Path>& s) {
    s.doc("Path tracing from the camera with direct sampling of lights.")
        .cite("veach1997")
        .param("max_bounces", &Path::max_bounces,
               {.doc = "A path scatters at most once more than this.", .min = 0, .max = 1000})
        .param("roulette", &Path::roulette,
               {.doc = "Ends dim paths at random; without it noise is less and time more."})
        .param("clamp", &Path::clamp,
               {.doc = "Cuts light that comes over more than one surface to this radiance: fewer "
                       "fireflies, and a darker, no longer exact picture. Not cut when not given.",
                .min = 0,
                .above_min = true});
  }
};

/// Numbers that one bounce may spend, so that branches do not shift those of later bounces.
constexpr uint32_t kCameraDimensions = 2;
constexpr uint32_t kBounceDimensions = 8;
/// Shadow rays stop this part of the way to the lamp, before any wall it may lie against.
constexpr float kAlmost = 0.9999f;

/// The last place where the path scattered: what a light found by the ray is weighed against.
struct Vertex {
  /// `through`: behind a surface that lets light through, where lights are not sampled.
  enum { camera, surface, through, medium } kind = camera;
  LitPoint point;
  float pdf = 0;   ///< Of the direction taken, over solid angle.
  LightOdds odds;  ///< By which lights were sampled.
};

class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(const Path& p)
      : max_bounces_(p.max_bounces),
        roulette_(p.roulette),
        most_(p.clamp ? static_cast<float>(*p.clamp) : kFar) {}

  PathResult trace(const World& world, const Ray& camera_ray, SampleCursor& numbers,
                   Tally* tally) const override;

 private:
  static Rgb lamp_light(const World& world, const Ray& ray, float end, const Vertex& from,
                        float& alpha, Tally* tally);
  static Rgb emitted_light(const World& world, const Ray& ray, const Hit& hit, const Vertex& from,
                           Tally* tally);
  static Rgb sky_light(const World& world, const Ray& ray, const Vertex& from, Tally* tally);
  static Rgb surface_light(const World& world, const Hit& hit, const Bsdf& bsdf, const Frame& frame,
                           Vertex& vertex, float choice, const Vec2f& u, Tally* tally);
  static Rgb light_from(const World& world, const LightChoice& chosen, const Hit& hit,
                        const Bsdf& bsdf, const Frame& frame, const Vertex& vertex, const Vec2f& u,
                        Tally* tally);
  static Rgb medium_light(const World& world, const Ray& ray, const Segment& segment, bool all,
                          float choice, float where, const Vec2f& u, Tally* tally);
  static Rgb scattered_from(const World& world, const LightChoice& chosen, const Ray& ray,
                            const Segment& segment, float where, const Vec2f& u, Tally* tally);

  /// Which part of the light of one vertex may go into the picture: all while the camera sees it
  /// itself.
  float kept(const Rgb& light, int depth) const {
    const float most = depth <= 0 ? kFar : most_;
    const float brightest = largest(light);
    return brightest > most ? most / brightest : 1;
  }

  int max_bounces_;
  bool roulette_;
  float most_;
};

float clear_part(const World& world, const Ray& ray, float end) {
  const Medium* medium = world.medium();
  return medium ? medium->transmittance(ray, medium->clip(ray, end)) : 1;
}

Rgb albedo_of(const Hit& hit, const Ray& ray) {
  const Frame frame(hit.surface.shading_normal);
  BsdfMemory memory;
  return hit.material->at(hit.surface, frame.to_local(-ray.direction), memory).albedo();
}

/// Light from a sampled light that reaches the ray's origin, over the sample's density.
Rgb unshadowed(const World& world, const LightSample& s) {
  return s.distance == kFar ? world.lights().sky_radiance(s.direction) : s.radiance;
}
bool shadowed(const World& world, const Ray& ray, float distance) {
  return world.occluded(ray, distance == kFar ? kFar : distance * kAlmost);
}

/// Emission of lamps between the ray's origin and `end`; a lamp that the camera sees is opaque.
Rgb PathIntegrator::lamp_light(const World& world, const Ray& ray, float end, const Vertex& from,
                               float& alpha, Tally* tally) {
  Rgb light(0.0f);
  // From a medium, direct sampling finds all of a lamp's light.
  if (from.kind == Vertex::medium) return light;
  world.lights().each_lamp_on(ray, end, [&](LightId id, const Light& lamp) {
    LightHit hit;
    if (!lamp.intersect(ray, end, hit)) return;
    float weight = 1;
    if (from.kind == Vertex::camera) {
      if (!lamp.camera_visible()) return;
      alpha = 1;
    } else if (from.kind == Vertex::surface) {
      const float direct =
          world.lights().share(id, from.point, from.odds) * lamp.pdf(from.point, ray.direction);
      weight = from.pdf / (from.pdf + direct);
    }
    const Rgb arriving = hit.radiance * (weight * clear_part(world, ray, hit.distance));
    if (tally) tally->note(world.lights().group(id), arriving);
    light += arriving;
  });
  return light;
}

/// What the surface that a ray meets sends out itself; as with lamps, but it ends the ray.
Rgb PathIntegrator::emitted_light(const World& world, const Ray& ray, const Hit& hit,
                                  const Vertex& from, Tally* tally) {
  if (is_black(hit.emission) || from.kind == Vertex::medium) return Rgb(0.0f);
  const LightSet& lights = world.lights();
  const LightId id = lights.emitter(hit.object, hit.triangle);
  float weight = 1;
  if (from.kind == Vertex::surface) {
    const float share = lights.share(id, from.point, from.odds);
    const float direct = share > 0 ? share * lights.pdf(id, from.point, ray.direction) : 0;
    weight = from.pdf / (from.pdf + direct);
  }
  const Rgb arriving = hit.emission * (weight * clear_part(world, ray, hit.distance));
  if (tally) tally->note(lights.group(id), arriving);
  return arriving;
}

Rgb PathIntegrator::sky_light(const World& world, const Ray& ray, const Vertex& from,
                              Tally* tally) {
  const LightSet& lights = world.lights();
  if (!lights.has_sky()) return Rgb(0.0f);
  float weight = 1;
  if (from.kind == Vertex::surface) {
    const float direct = lights.sky_pdf(from.point, from.odds, ray.direction);
    weight = from.pdf / (from.pdf + direct);
  } else if (from.kind == Vertex::medium) {
    // Direct sampling finds the sky only where it may turn to.
    for (const LightId id : lights.sampled_skies())
      if (lights.pdf(id, from.point, ray.direction) > 0) return Rgb(0.0f);
  }
  weight *= clear_part(world, ray, kFar);
  if (tally) tally->note_sky(world, ray.direction, Rgb(weight));
  return lights.sky_radiance(ray.direction) * weight;
}

/// Direct light at a surface, reflected towards `out`; notes in `vertex` how lights were sampled.
Rgb PathIntegrator::surface_light(const World& world, const Hit& hit, const Bsdf& bsdf,
                                  const Frame& frame, Vertex& vertex, float choice, const Vec2f& u,
                                  Tally* tally) {
  if (vertex.odds.all) {
    Rgb sum(0.0f);
    for (const LightId id : world.lights().few())
      if (world.lights().share(id, vertex.point, vertex.odds) > 0)
        sum += light_from(world, {id, 1, vertex.odds}, hit, bsdf, frame, vertex, u, tally);
    return sum;
  }
  const LightChoice chosen = world.lights().choose(vertex.point, choice);
  vertex.odds = chosen.odds;
  if (chosen.light == kNoLight) return Rgb(0.0f);
  return light_from(world, chosen, hit, bsdf, frame, vertex, u, tally);
}

Rgb PathIntegrator::light_from(const World& world, const LightChoice& chosen, const Hit& hit,
                               const Bsdf& bsdf, const Frame& frame, const Vertex& vertex,
                               const Vec2f& u, Tally* tally) {
  const LightSample s = world.lights().sample(chosen.light, vertex.point, u);
  if (!(s.pdf > 0) || !(dot(s.direction, hit.surface.geometric_normal) > 0)) return Rgb(0.0f);
  const Vec3f in = frame.to_local(s.direction);
  if (!(in.z > 0)) return Rgb(0.0f);
  const Scattering scattering = bsdf.evaluate(in);
  const Rgb f = scattering.total();
  const Rgb light = unshadowed(world, s);
  const Ray ray{hit.origin, s.direction};
  if (is_black(f) || is_black(light) || shadowed(world, ray, s.distance)) return Rgb(0.0f);
  const float direct = s.distance == kFar
                           ? world.lights().sky_pdf(vertex.point, chosen.odds, s.direction)
                           : chosen.probability * s.pdf;
  const float density = direct + scattering.pdf;
  if (!(density > 0)) return Rgb(0.0f);
  const float weight = clear_part(world, ray, s.distance) / density;
  if (tally && s.distance == kFar)
    tally->note_sky(world, s.direction, f * weight, scattering.diffuse * weight);
  else if (tally)
    tally->note(world.lights().group(chosen.light), f * light * weight,
                scattering.diffuse * light * weight);
  return f * light * weight;
}

/// Light that is scattered once into the ray, anywhere in the segment, weighed by the clear part
/// of the way back to the ray's origin.
Rgb PathIntegrator::medium_light(const World& world, const Ray& ray, const Segment& segment,
                                 bool all, float choice, float where, const Vec2f& u,
                                 Tally* tally) {
  if (all) {
    Rgb sum(0.0f);
    const LightOdds every{true};
    for (const LightId id : world.lights().few())
      if (world.lights().share_along(id, ray, segment, every) > 0)
        sum += scattered_from(world, {id, 1, every}, ray, segment, where, u, tally);
    return sum;
  }
  const LightChoice chosen = world.lights().choose_along(ray, segment, choice);
  return chosen.light == kNoLight ? Rgb(0.0f)
                                  : scattered_from(world, chosen, ray, segment, where, u, tally);
}

Rgb PathIntegrator::scattered_from(const World& world, const LightChoice& chosen, const Ray& ray,
                                   const Segment& segment, float where, const Vec2f& u,
                                   Tally* tally) {
  const Medium& medium = *world.medium();
  // Distances from the foot of the perpendicular, which equiangular sampling is about.
  const Vec3f to = world.lights().centre(chosen.light) - ray.origin;
  const float foot = dot(to, ray.direction);
  const auto height = static_cast<double>(
      std::max(length(to - ray.direction * foot), 1e-4f * (segment.end - segment.begin)));
  const double a = static_cast<double>(segment.begin - foot),
               b = static_cast<double>(segment.end - foot);
  const double angle_a = maths::atan2(a, height), angle_b = maths::atan2(b, height);
  const double optical = static_cast<double>(medium.extinction(ray.at(segment.begin)));
  const double span = b - a;
  const double through = 1 - maths::exp(-optical * span);
  double t = 0;
  if (where < 0.5f) {
    t = height * maths::tan(angle_a + 2 * static_cast<double>(where) * (angle_b - angle_a));
  } else {
    const double v = 2 * static_cast<double>(where) - 1;
    t = a + (through > 1e-6 ? -maths::log(1 - v * through) / optical : v * span);
  }
  t = std::clamp(t, a, b);
  const double equiangular = height / ((angle_b - angle_a) * (height * height + t * t));
  const double falling =
      through > 1e-6 ? optical * maths::exp(-optical * (t - a)) / through : 1 / span;
  const auto density = static_cast<float>(0.5 * (equiangular + falling));
  const float distance = static_cast<float>(t) + foot;

  const LitPoint point{ray.at(distance), Vec3f(0.0f)};
  const LightSample s = world.lights().sample(chosen.light, point, u);
  if (!(s.pdf > 0) || !(density > 0)) return Rgb(0.0f);
  const Rgb light = unshadowed(world, s);
  const Ray shadow{point.position, s.direction};
  if (is_black(light) || shadowed(world, shadow, s.distance)) return Rgb(0.0f);
  // Portals that share a direction share its light.
  float sharing = 1;
  if (s.distance == kFar) {
    sharing = 0;
    for (const LightId sky : world.lights().sampled_skies())
      if (sky == chosen.light || world.lights().pdf(sky, point, s.direction) > 0) sharing += 1;
  }
  const float pdf = chosen.probability * s.pdf * sharing;
  const float scattered =
      medium.extinction(point.position) * medium.phase(dot(ray.direction, s.direction)) *
      medium.transmittance(ray, {segment.begin, distance}) * clear_part(world, shadow, s.distance);
  const Rgb weight = medium.albedo(point.position) * (scattered / (pdf * density));
  if (tally && s.distance == kFar)
    tally->note_sky(world, s.direction, weight);
  else if (tally)
    tally->note(world.lights().group(chosen.light), light * weight);
  return light * weight;
}

PathResult PathIntegrator::trace(const World& world, const Ray& camera_ray, SampleCursor& numbers,
                                 Tally* tally) const {
  PathResult result;
  Ray ray = camera_ray;
  Rgb throughput(1.0f);
  Vertex from;
  const Medium* medium = world.medium();
  for (int depth = 0;; ++depth) {
    numbers.jump(kCameraDimensions + kBounceDimensions * static_cast<uint32_t>(depth));
    Hit hit;
    const bool found = world.intersect(ray, hit);
    const float end = found ? hit.distance : kFar;
    if (depth == 0 && found)
      result.first = {true, hit.surface.position, hit.surface.shading_normal, albedo_of(hit, ray)};
    if (depth == 0) result.alpha = found ? 1 : 1 - clear_part(world, ray, kFar);
    // What a ray runs into belongs to the place it comes from, as direct light there.
    Rgb seen = lamp_light(world, ray, end, from, result.alpha, tally);
    seen +=
        found ? emitted_light(world, ray, hit, from, tally) : sky_light(world, ray, from, tally);
    seen *= throughput;
    const float kept_seen = kept(seen, depth - 1);
    result.radiance += seen * kept_seen;
    if (tally) tally->settle_met(depth, throughput * kept_seen);
    if (depth > max_bounces_) break;

    const Vec2f choice = numbers.pair();  // which light, which lobe
    const Vec2f light_u = numbers.pair();
    const Vec2f scatter_u = numbers.pair();
    const float survive_u = numbers.single();
    // Where the camera looks, a few lights are cheaper to sample all than to choose from.
    const bool all_lights = depth == 0 && !world.lights().few().empty();
    bool in_medium = false;
    if (medium) {
      const Segment segment = medium->clip(ray, end);
      if (!segment.empty() && segment.end < kFar) {
        const Vec2f distance_u = numbers.pair();
        const Rgb light = throughput * medium_light(world, ray, segment, all_lights, choice.x,
                                                    distance_u.x, numbers.pair(), tally);
        const float kept_light = kept(light, depth);
        result.radiance += light * kept_light;
        if (tally) tally->settle_medium(depth, throughput * kept_light);
        const DistanceSample collision = medium->sample_distance(ray, segment, distance_u.y);
        if (collision.scattered) {
          in_medium = true;
          const Vec3f point = ray.at(collision.distance);
          throughput *= medium->albedo(point);
          ray = {point, medium->sample_phase(ray.direction, scatter_u)};
          from = {Vertex::medium, {point, Vec3f(0.0f)}, 0, {}};
          if (tally && depth == 0) tally->turned_in_medium();
        }
      }
    }
    if (!in_medium) {
      if (!found) break;
      const Frame frame(hit.surface.shading_normal);
      BsdfMemory memory;
      const Bsdf& bsdf = hit.material->at(hit.surface, frame.to_local(-ray.direction), memory);
      from = {
          Vertex::surface, {hit.origin, hit.surface.geometric_normal, hit.object}, 0, {all_lights}};
      const Rgb light =
          throughput * surface_light(world, hit, bsdf, frame, from, choice.x, light_u, tally);
      const float kept_light = kept(light, depth);
      result.radiance += light * kept_light;
      if (tally) tally->settle_surface(depth, throughput * kept_light);
      const BsdfSample s = bsdf.sample(choice.y, scatter_u);
      if (!(s.pdf > 0)) break;
      const Vec3f direction = frame.to_world(s.direction);
      const bool through = s.direction.z < 0;
      if ((dot(direction, hit.surface.geometric_normal) > 0) == through) break;
      if (tally && depth == 0) tally->turned_at_surface(through, s.weight, s.diffuse);
      throughput *= s.weight;
      from.pdf = s.pdf;
      if (through) from.kind = Vertex::through;
      ray = {through ? hit.behind : hit.origin, direction};
    }
    if (roulette_) {
      // The square root keeps dim paths longer than their share of light: fewer, fainter fireflies.
      const float survival = std::sqrt(largest(throughput));
      if (survival < 1) {
        if (!(survive_u < survival)) break;
        throughput *= 1 / survival;
      }
    } else if (is_black(throughput)) {
      break;
    }
  }
  return result;
}

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(path, integrator, IntegratorPtr, Path, PathIntegrator)
