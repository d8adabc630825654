// Unidirectional path tracing with next-event estimation, led by a guide to bright surfaces.
#include <vug/render/kind.h>
#include <vug/render/paths/direct.h>
#include <vug/render/paths/rehearsal.h>
#include <vug/render/paths/wander.h>
#include <vug/render/tally.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::render {
namespace {

enum class Guided { automatic, on, off };

struct Path {
  int max_bounces = 8;
  bool roulette = true;
  Guided guide = Guided::automatic;
  std::optional<double> clamp;
  double regularize = 0;

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
                .above_min = true})
        .param("regularize", &Path::regularize,
               {.doc = "Roughness that faces have at least where light is followed to them over "
                       "matte ones, 0.3 to 0.5: small lamps over water and polish make soft light "
                       "instead of bright dots, and the picture is no longer exact.",
                .min = 0,
                .max = 1})
        .choice("guide", &Path::guide,
                {{"auto", Guided::automatic}, {"on", Guided::on}, {"off", Guided::off}},
                "Learns first which surfaces are bright, and from where these and the lights are "
                "seen, and lets paths turn to them: less noise where light comes over walls and "
                "where walls hide lamps. auto leaves it out of tiny pictures.");
  }
};

/// Numbers that one bounce may spend, so that branches do not shift those of later bounces.
constexpr uint32_t kCameraDimensions = 2;
constexpr uint32_t kBounceDimensions = 8;
constexpr uint32_t kTrackingDimension = 7;  // of a bounce's

/// A cone that a diffuse surface has turned is so wide at least, in radians: what is seen by way
/// of it needs no fine detail.
constexpr float kBlur = 0.05f;

/// Where the camera looks, a few lights at once are cheaper than more paths.
constexpr float kLightsSeen = 2;

/// Pictures of fewer samples are done before a guide is learned.
constexpr uint64_t kWorthLearning = 1u << 16;
/// The guide learns from this part of the samples, and at most so many.
constexpr double kLearning = 0.04;
constexpr uint64_t kFewestPaths = 1u << 12, kMostPaths = 1u << 18;

Rgb albedo_of(const Hit& hit, const Ray& ray) {
  const Frame frame(hit.surface.shading_normal);
  BsdfMemory memory;
  return hit.material->at(hit.surface, frame.to_local(-ray.direction), memory).albedo();
}

class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(const Path& p)
      : max_bounces_(p.max_bounces),
        roulette_(p.roulette),
        guided_(p.guide),
        most_(p.clamp ? static_cast<float>(*p.clamp) : kFar),
        regularize_(static_cast<float>(p.regularize)) {}

  std::string inexact() const override {
    std::string out;
    if (most_ < kFar) out = fmt::format("clamp {:g}", most_);
    if (regularize_ > 0)
      out += fmt::format("{}regularize {:g}", out.empty() ? "" : ", ", regularize_);
    return out;
  }

  std::shared_ptr<const Integrator> rehearsed(const Rehearsal& rehearsal,
                                              Progress& progress) const override {
    if (guided_ == Guided::off || max_bounces_ < 1) return nullptr;
    if (guided_ == Guided::automatic && rehearsal.samples < kWorthLearning) return nullptr;
    const auto share = static_cast<uint64_t>(kLearning * static_cast<double>(rehearsal.samples));
    const auto gather = [&](const Ray& ray, SampleCursor& numbers, const Learned& learned,
                            Trail& trail) {
      trail.learn(walk(rehearsal.world, ray, numbers, nullptr, learned, &trail).radiance);
    };
    auto led = std::make_shared<PathIntegrator>(*this);
    led->learned_ = learn(rehearsal, std::clamp(share, kFewestPaths, kMostPaths), gather, progress);
    return led;
  }
  PathResult trace(const World& world, const Ray& camera_ray, SampleCursor& numbers,
                   Tally* tally) const override {
    return walk(world, camera_ray, numbers, tally, learned_, nullptr);
  }

 private:
  PathResult walk(const World& world, const Ray& camera_ray, SampleCursor& numbers, Tally* tally,
                  const Learned& learned, Trail* trail) const;

  /// Which part of the light of one vertex may go into the picture: all while the camera sees it
  /// itself.
  float kept(const Rgb& light, int depth) const {
    const float most = depth <= 0 ? kFar : most_;
    const float brightest = largest(light);
    return brightest > most ? most / brightest : 1;
  }

  int max_bounces_;
  bool roulette_;
  Guided guided_;
  float most_;
  float regularize_;
  Learned learned_;
};

PathResult PathIntegrator::walk(const World& world, const Ray& camera_ray, SampleCursor& numbers,
                                Tally* tally, const Learned& learned, Trail* trail) const {
  PathResult result;
  Ray ray = camera_ray;
  Rgb throughput(1.0f);
  Rgb unled(1.0f);  // the throughput that would be left without a guide
  PathVertex from;
  float width = 0, spread = camera_ray.spread;  // of the cone that the path looks along
  float blur = 0;                               // least roughness of what it sees
  Rgb absorption(0.0f);                         // of the clear body that the ray is in
  bool within = false;
  const Medium* medium = world.medium();
  const auto odds_at = [&](const Vec3f& point, float lights) {
    return LightOdds{lights, learned.lights.empty() ? nullptr : learned.lights.at(point)};
  };
  // Adds what one vertex gives; the scale at which the tally settles it.
  const auto add = [&](const Rgb& light, int depth) {
    const float part = kept(light, depth);
    result.radiance += light * part;
    return throughput * part;
  };
  for (int depth = 0;; ++depth) {
    const uint32_t first = kCameraDimensions + kBounceDimensions * static_cast<uint32_t>(depth);
    Vec2f begin(0.0f);
    if (medium) {
      numbers.jump(first + kTrackingDimension);
      begin = numbers.pair();
    }
    TrackingNumbers tracking(begin);
    numbers.jump(first);
    Hit hit;
    const bool found = world.intersect(ray, hit);
    const float end = found ? hit.distance : kFar;
    if (within && found) {
      const Rgb clear = unabsorbed(absorption, hit.distance);
      throughput *= clear, unled *= clear;
    }
    if (found) hit.surface.footprint = width + spread * hit.distance;
    if (depth == 0 && found)
      result.first = {true, hit.surface.position, hit.surface.shading_normal, albedo_of(hit, ray),
                      hit.object};
    if (tally && depth == 0 && found) tally->read(hit.surface, *hit.material);
    if (depth == 0) result.alpha = found ? 1 : 1 - clear_part(world, ray, kFar, tracking);
    // What a ray runs into belongs to the place it comes from, as direct light there.
    Rgb seen = lamps_met(world, ray, end, from, result.alpha, tracking, tally);
    seen += found ? surface_met(world, ray, hit, from, tracking, tally)
                  : sky_met(world, ray, from, tracking, tally);
    const Rgb met_scale = add(throughput * seen, depth - 1);
    if (tally) tally->settle_met(depth, met_scale);
    if (depth > max_bounces_) break;

    const Vec2f choice = numbers.pair();  // which light, which lobe
    const Vec2f light_u = numbers.pair();
    const Vec2f scatter_u = numbers.pair();
    const float survive_u = numbers.single();
    const float lights = depth == 0 ? kLightsSeen : 1;
    bool in_medium = false;
    if (medium && !within) {
      const Segment segment = medium->clip(ray, end);
      if (!segment.empty() && segment.end < kFar) {
        const Vec2f distance_u = numbers.pair();
        const Rgb light =
            throughput * scattered_light(world, ray, segment, lights, learned.lights, choice.x,
                                         distance_u.x, numbers.pair(), tracking, tally);
        const Rgb scale = add(light, depth);
        if (tally) tally->settle_medium(depth, scale);
        if (medium->burns()) {
          const Rgb flames = medium->flames(ray, segment, tracking);
          const Rgb flames_scale = add(throughput * flames, depth);
          if (tally) {
            tally->note(LightSet::kNoGroup, flames);
            tally->settle_medium(depth, flames_scale);
          }
        }
        const DistanceSample collision =
            medium->sample_distance(ray, segment, distance_u.y, tracking);
        if (collision.scattered) {
          in_medium = true;
          const Vec3f point = ray.at(collision.distance);
          if (const Rgb glow = medium->glow(point); !is_black(glow)) {
            const Rgb glow_scale = add(throughput * glow, depth);
            if (tally) {
              tally->note(LightSet::kNoGroup, glow);
              tally->settle_medium(depth, glow_scale);
            }
          }
          throughput *= medium->albedo(point);
          unled *= medium->albedo(point);
          ray = {point, medium->sample_phase(ray.direction, scatter_u)};
          from = {PathVertex::medium, {point, Vec3f(0.0f)}, 0, {}};
          blur = regularize_;
          if (tally && depth == 0) tally->turned_in_medium();
        }
      }
    }
    if (!in_medium) {
      if (!found) break;
      if (hit.material->bump(hit.surface)) hit.surface.face(ray.direction);
      const Frame frame(hit.surface.shading_normal);
      hit.surface.blur = blur;
      BsdfMemory memory;
      const Bsdf& own = hit.material->at(hit.surface, frame.to_local(-ray.direction), memory);
      const Cones bright = learned.guide.at(hit.surface.position, hit.surface.shading_normal);
      const GuidedBsdf bsdf(own, frame, bright);
      if (trail) trail->add(hit.origin, hit.surface.geometric_normal, throughput, result.radiance);
      from = {PathVertex::surface,
              {hit.origin, hit.surface.geometric_normal, hit.object},
              0,
              odds_at(hit.origin, lights)};
      // Then light arrives from both sides.
      if (own.lit_from_behind()) from.point.normal = Vec3f(0.0f);
      const Rgb light = throughput * direct_light(world, hit, bsdf, frame, from, choice.x, light_u,
                                                  tracking, tally);
      const Rgb scale = add(light, depth);
      if (tally) tally->settle_surface(depth, scale);
      const GuidedBsdf::Sample s = bsdf.sample(choice.y, scatter_u);
      if (!(s.scattered.pdf > 0)) break;
      const bool through = s.scattered.direction.z < 0;
      if ((dot(s.direction, hit.surface.geometric_normal) > 0) == through) break;
      if (tally && depth == 0)
        tally->turned_at_surface(through && !s.scattered.beneath, s.scattered.weight,
                                 s.scattered.diffuse);
      throughput *= s.scattered.weight;
      unled *= s.unled;
      from.pdf = s.scattered.pdf;
      width = hit.surface.footprint;
      if (!is_black(s.scattered.diffuse)) spread = std::max(spread, kBlur);
      // Kaplanyan and Dachsbacher 2013, "Path space regularization for holistic and robust light
      // transport" (cite kaplanyan2013regularization), with a width that stays.
      if (2 * largest(s.scattered.diffuse) > largest(s.scattered.weight)) blur = regularize_;
      const Bsdf& body = s.scattered.body ? *s.scattered.body : own;
      if (s.scattered.beneath) {
        RandomStream random = walk_numbers(scatter_u, choice.y);
        Rgb left(1.0f);
        if (!wander(world, body.beneath(), s.direction, random, hit, left)) break;
        throughput *= left, unled *= left;
        const Frame outside(hit.surface.shading_normal);
        BsdfMemory place;
        const Bsdf* leaving = hit.material->leaving(hit.surface, place);
        if (!leaving) break;
        const Cones around = learned.guide.at(hit.surface.position, hit.surface.shading_normal);
        const GuidedBsdf out(*leaving, outside, around);
        from = {PathVertex::surface,
                {hit.origin, hit.surface.geometric_normal, hit.object},
                0,
                odds_at(hit.origin, 1)};
        const float which = next_float(random);
        const Rgb more = throughput * direct_light(world, hit, out, outside, from, which,
                                                   next_pair(random), tracking, tally);
        const Rgb more_scale = add(more, depth + 1);
        if (tally) tally->settle_surface(depth + 1, more_scale);
        const float lobe = next_float(random);
        const GuidedBsdf::Sample away = out.sample(lobe, next_pair(random));
        if (!(away.scattered.pdf > 0) || !(away.scattered.direction.z > 0) ||
            !(dot(away.direction, hit.surface.geometric_normal) > 0))
          break;
        throughput *= away.scattered.weight;
        unled *= away.unled;
        from.pdf = away.scattered.pdf;
        ray = {hit.origin, away.direction};
      } else {
        if (through && !own.thin()) {
          if (!own.lit_from_behind()) from.kind = PathVertex::through;
          within = !hit.surface.inside;
          absorption = within ? body.absorption() : Rgb(0.0f);
        }
        ray = {through ? hit.behind : hit.origin, s.direction};
      }
    }
    if (is_black(throughput)) break;
    // What the first surface sends on is seen as it is: an even sky would be grain there.
    if (roulette_ && depth > 0) {
      // The square root keeps dim paths longer than their share of light: fewer, fainter fireflies.
      const float survival = std::sqrt(largest(unled));
      if (survival < 1) {
        if (!(survive_u < survival)) break;
        throughput *= 1 / survival;
        unled *= 1 / survival;
      }
    }
  }
  return result;
}

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(path, integrator, IntegratorPtr, Path, PathIntegrator)
