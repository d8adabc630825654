// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/paths/direct.h>
#include <vug/render/paths/subsurface_walk.h>
#include <vug/render/paths/trace_path.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Sample dimensions reserved for each bounce, so that branches do not shift those of later
/// bounces.
constexpr uint32_t kCameraDimensions = 2;
constexpr uint32_t kBounceDimensions = 8;
constexpr uint32_t kTrackingDimension = 7;  // within a bounce

/// Smallest spread in radians of a ray cone after a diffuse bounce: what it sees needs no fine
/// detail.
constexpr float kBlur = 0.05f;

/// Russian roulette applies where the expected contribution of a path is below kNegligible times
/// the deviation of single paths (RadianceCache::noise) where the camera looks. The survival
/// probability is at least kMinSurvival, since the cached radiance may be wrong. Both constants,
/// and the square root of the ratio, were chosen by variance times time
/// (docs/explanation/decisions/0030-adjoint-driven-roulette.md).
constexpr float kNegligible = 20, kMinSurvival = 0.5f;

Rgb albedo_of(const Hit& hit, const Ray& ray) {
  const Frame frame(hit.surface.shading_normal);
  BsdfMemory memory;
  return hit.material->at(hit.surface, frame.to_local(-ray.direction), memory).albedo();
}

class PathTracer {
 public:
  PathTracer(const PreparedScene& world, const CameraRays& rays, const PathSettings& settings,
             const GuidingData& guiding, SampleCursor& numbers, const PathRecorders& recorders)
      : world_(world),
        medium_(world.medium()),
        settings_(settings),
        guiding_(guiding),
        numbers_(numbers),
        recorder_(recorders.light),
        path_recorder_(recorders.training),
        extra_rays_(rays.extra),
        ray_(rays.first),
        spread_(rays.first.spread) {}

  PathResult trace() {
    for (;; ++depth_) {
      Bounce bounce = begin_bounce();
      intersect(bounce);
      add_emission(bounce);
      if (depth_ > settings_.max_bounces) break;
      if (!sample_medium(bounce) && !(bounce.found && scatter(bounce))) break;
      if (is_black(throughput_) || !(bounce.roulette_done || survives(bounce.last.x))) break;
    }
    return result_;
  }

 private:
  struct Bounce {
    TrackingRng tracking;
    Hit hit;
    bool found = false;
    Vec2f choice{0, 0};  ///< Random numbers for the light and the lobe.
    Vec2f light{0, 0}, scatter{0, 0};
    Vec2f last{
        0,
        0};  ///< Random numbers for the survival of the path and for the light with a shadow ray.
    bool roulette_done = false;  ///< Whether the survival of the path has been decided.
  };

  Bounce begin_bounce() {
    const uint32_t first = kCameraDimensions + kBounceDimensions * static_cast<uint32_t>(depth_);
    Vec2f start(0.0f);
    if (medium_) {
      numbers_.jump(first + kTrackingDimension);
      start = numbers_.pair();
    }
    numbers_.jump(first);
    return {TrackingRng(start), {}};
  }

  void draw(Bounce& bounce) {
    const FourPairs four = numbers_.four_pairs();
    bounce.choice = four[0], bounce.light = four[1], bounce.scatter = four[2],
    bounce.last = four[3];
  }

  /// Finds the next surface on the ray.
  void intersect(Bounce& bounce) {
    Hit& hit = bounce.hit;
    bounce.found = world_.intersect(ray_, hit, [&] { draw(bounce); });
    if (bounce.found) {
      if (inside_body_) scale_throughput(beer_lambert(absorption_, hit.distance));
      hit.surface.footprint = width_ + spread_ * hit.distance;
    }
    if (depth_ > 0) return;
    if (bounce.found) {
      result_.first = {true, hit.surface.position, hit.surface.shading_normal, albedo_of(hit, ray_),
                       hit.object};
      if (recorder_) recorder_->read_surface(hit.surface, *hit.material);
    }
    result_.alpha = bounce.found ? 1 : 1 - transmittance(world_, ray_, kFar, bounce.tracking);
  }

  /// Emission that the ray hits counts as direct light of the vertex that it comes from.
  void add_emission(Bounce& bounce) {
    const float end = bounce.found ? bounce.hit.distance : kFar;
    const LightEmission lights =
        light_emission(world_, ray_, end, from_, bounce.tracking, recorder_);
    if (lights.opaque) result_.alpha = 1;
    Rgb seen = lights.radiance;
    seen += bounce.found
                ? surface_emission(world_, ray_, bounce.hit, from_, bounce.tracking, recorder_)
                : environment_emission(world_, ray_, from_, bounce.tracking, recorder_);
    float share = 1;
    if (depth_ == 0 && !extra_rays_.empty()) {
      for (const Ray& ray : extra_rays_)
        seen += camera_emission(world_, ray, bounce.tracking, recorder_);
      share /= static_cast<float>(extra_rays_.size() + 1);
    }
    const Rgb scale = add(throughput_ * seen * share, depth_ - 1);
    if (recorder_) recorder_->flush_emission(depth_, scale * share);
  }

  /// Returns true if the path scatters in the medium before it reaches the surface.
  bool sample_medium(Bounce& bounce) {
    if (!medium_ || inside_body_) return false;
    const Segment segment = medium_->clip(ray_, bounce.found ? bounce.hit.distance : kFar);
    if (segment.empty() || !(segment.end < kFar)) return false;
    const Vec2f distance_u = numbers_.pair();
    ScatteredLight lit(world_, ray_, segment, {light_samples(), settings_.light_sampler},
                       guiding_.light_visibility,
                       {{bounce.choice.x, distance_u.x}, numbers_.pair(), bounce.tracking});
    const DistanceSample collision = medium_->sample_distance(
        ray_, segment, distance_u.y, lit.scatter_points(), bounce.tracking);
    const Rgb scale = add(throughput_ * lit.arriving(recorder_), depth_);
    if (recorder_) recorder_->flush_medium(depth_, scale);
    if (medium_->is_emissive())
      add_medium_emission(medium_->sample_emission(ray_, segment, bounce.tracking));
    if (!collision.scattered) return false;
    const Vec3f point = ray_.at(collision.distance);
    if (const Rgb glow = medium_->emission(point); !is_black(glow)) add_medium_emission(glow);
    scale_throughput(medium_->albedo(point));
    ray_ = {point, medium_->sample_phase(ray_.direction, bounce.scatter)};
    from_ = {PathVertex::medium, {point, Vec3f(0.0f)}, 0, {}};
    blur_ = settings_.regularize;
    if (recorder_ && depth_ == 0) recorder_->scattered_in_medium();
    return true;
  }
  void add_medium_emission(const Rgb& light) {
    const Rgb scale = add(throughput_ * light, depth_);
    if (!recorder_) return;
    recorder_->record(LightSet::kNoGroup, light);
    recorder_->flush_medium(depth_, scale);
  }

  /// Scatters at the surface; false if the path ends there.
  bool scatter(Bounce& bounce) {
    Hit& hit = bounce.hit;
    if (hit.material->bump(hit.surface)) hit.surface.face(ray_.direction);
    const Frame frame(hit.surface.shading_normal);
    hit.surface.blur = blur_;
    BsdfMemory memory;
    const Bsdf& own = hit.material->at(hit.surface, frame.to_local(-ray_.direction), memory);
    const ConeMixture bright = guiding_.guide.at(hit.surface.position, hit.surface.shading_normal);
    const GuidedBsdf bsdf(own, frame, bright);
    if (path_recorder_)
      path_recorder_->add(hit.origin, hit.surface.geometric_normal, throughput_, result_.radiance);
    set_surface_vertex(hit, light_samples());
    // Then light arrives from both sides.
    if (own.lit_from_behind()) from_.point.normal = Vec3f(0.0f);
    const Rgb light =
        throughput_ *
        direct_light(world_, {hit, bsdf, frame}, from_,
                     {{bounce.choice.x, bounce.last.y}, bounce.light, bounce.tracking}, recorder_);
    const Rgb scale = add(light, depth_);
    if (path_recorder_) path_recorder_->add_direct(result_.radiance);
    if (recorder_) recorder_->flush_surface(depth_, scale);
    // The cache says nothing about specular and transmissive surfaces, and too little about light
    // that leaves a body elsewhere: there it would double the variance times time.
    bounce.roulette_done = settings_.roulette == Roulette::adjoint && !guiding_.radiance.empty() &&
                           own.guided_fraction() > 0 && !(own.subsurface_fraction() > 0);
    if (bounce.roulette_done && !survives_adjoint(hit, bounce.last.x)) return false;
    const GuidedBsdf::Sample s = bsdf.sample(bounce.choice.y, bounce.scatter);
    if (!(s.scattered.pdf > 0)) return false;
    const bool through = s.scattered.direction.z < 0;
    if (through && dot(s.direction, hit.surface.geometric_normal) > 0) return false;
    if (recorder_ && depth_ == 0)
      recorder_->scattered_at_surface(through && !s.scattered.subsurface, s.scattered.weight,
                                      s.scattered.diffuse);
    scale_throughput(s);
    width_ = hit.surface.footprint;
    if (!is_black(s.scattered.diffuse)) spread_ = std::max(spread_, kBlur);
    // Kaplanyan and Dachsbacher 2013, "Path space regularization for holistic and robust light
    // transport" (cite kaplanyan2013regularization), with constant width.
    if (2 * largest(s.scattered.diffuse) > largest(s.scattered.weight))
      blur_ = settings_.regularize;
    const Bsdf& body = s.scattered.body ? *s.scattered.body : own;
    if (s.scattered.subsurface) return exit_subsurface(bounce, body, s.direction);
    if (through && !own.thin()) {
      if (!own.lit_from_behind()) from_.kind = PathVertex::transmission;
      inside_body_ = !hit.surface.inside;
      absorption_ = inside_body_ ? body.absorption() : Rgb(0.0f);
    }
    ray_ = {through ? hit.behind : hit.origin, s.direction};
    return true;
  }

  /// Random walk inside a body until the path leaves it elsewhere; false if it does not.
  bool exit_subsurface(Bounce& bounce, const Bsdf& body, const Vec3f& direction) {
    Hit& hit = bounce.hit;
    RandomStream random = subsurface_random(bounce.scatter, bounce.choice.y);
    Rgb left(1.0f);
    if (!random_walk_subsurface(world_, body.subsurface(), direction, random, hit, left))
      return false;
    scale_throughput(left);
    const Frame frame(hit.surface.shading_normal);
    BsdfMemory memory;
    const Bsdf* exit_bsdf = hit.material->subsurface_exit(hit.surface, memory);
    if (!exit_bsdf) return false;
    const ConeMixture bright = guiding_.guide.at(hit.surface.position, hit.surface.shading_normal);
    const GuidedBsdf bsdf(*exit_bsdf, frame, bright);
    set_surface_vertex(hit, 1);
    const Vec2f which = next_pair(random);
    const Rgb light =
        throughput_ * direct_light(world_, {hit, bsdf, frame}, from_,
                                   {which, next_pair(random), bounce.tracking}, recorder_);
    const Rgb scale = add(light, depth_ + 1);
    if (recorder_) recorder_->flush_surface(depth_ + 1, scale);
    const float lobe = next_float(random);
    const GuidedBsdf::Sample s = bsdf.sample(lobe, next_pair(random));
    if (!(s.scattered.pdf > 0) || !(s.scattered.direction.z > 0)) return false;
    scale_throughput(s);
    ray_ = {hit.origin, s.direction};
    return true;
  }

  bool survives(float u) {
    if (settings_.roulette == Roulette::off) return true;
    // Light after the first surface is directly visible: a uniform sky would show as grain.
    if (settings_.roulette == Roulette::adjoint && depth_ == 0) return true;
    // The square root keeps dim paths alive longer than in proportion: fewer and fainter fireflies.
    return survives_by(std::sqrt(largest(unguided_throughput_)), u);
  }
  /// Compares the expected contribution of the path beyond the lights sampled here (Vorba and
  /// Krivanek 2016, "Adjoint-driven Russian roulette and splitting in light transport simulation",
  /// cite vorba2016adjoint) with what the camera sees and its noise level (Rath et al. 2022, "EARS:
  /// Efficiency-aware Russian roulette and splitting", cite rath2022ears).
  bool survives_adjoint(const Hit& hit, float u) {
    const RadianceStats& light = guiding_.radiance.at(hit.origin, hit.surface.geometric_normal);
    if (!(negligible_ > 0)) negligible_ = kNegligible * guiding_.radiance.noise() * light.mean;
    if (depth_ == 0) return true;
    const float adjoint = luminance(throughput_) * light.indirect / negligible_;
    return survives_by(std::max(kMinSurvival, std::sqrt(adjoint)), u);
  }
  bool survives_by(float survival, float u) {
    if (!(survival < 1)) return true;
    if (!(u < survival)) return false;
    scale_throughput(Rgb(1 / survival));
    return true;
  }

  float light_samples() const { return depth_ == 0 ? settings_.light_samples : 1; }

  void set_surface_vertex(const Hit& hit, float samples) {
    const float* visibility =
        guiding_.light_visibility.empty() ? nullptr : guiding_.light_visibility.at(hit.origin);
    from_ = {PathVertex::surface,
             {hit.origin, hit.surface.shading_normal, hit.object},
             0,
             {samples, settings_.light_sampler, visibility}};
  }
  void scale_throughput(const Rgb& part) { throughput_ *= part, unguided_throughput_ *= part; }
  void scale_throughput(const GuidedBsdf::Sample& s) {
    throughput_ *= s.scattered.weight;
    unguided_throughput_ *= s.unguided;
    from_.pdf = s.scattered.pdf;
  }
  /// Adds the light of one vertex, clamped unless the camera sees the vertex itself. Returns the
  /// scale for the recorder.
  Rgb add(const Rgb& light, int depth) {
    const float most = depth <= 0 ? kFar : settings_.max_radiance, brightest = largest(light);
    const float part = brightest > most ? most / brightest : 1;
    result_.radiance += light * part;
    return throughput_ * part;
  }

  const PreparedScene& world_;
  const Medium* medium_;
  const PathSettings& settings_;
  const GuidingData& guiding_;
  SampleCursor& numbers_;
  LightPathRecorder* recorder_;
  PathRecorder* path_recorder_;
  std::span<const Ray> extra_rays_;

  PathResult result_;
  int depth_ = 0;
  Ray ray_;
  Rgb throughput_{1, 1, 1};
  Rgb unguided_throughput_{1, 1, 1};  ///< The throughput without guiding.
  PathVertex from_;
  float negligible_ = 0;      ///< See kNegligible; 0: unknown.
  float width_ = 0, spread_;  ///< Width and spread of the path's ray cone.
  float blur_ = 0;            ///< Smallest roughness of the surfaces it sees.
  bool inside_body_ = false;  ///< In a clear body with this absorption:
  Rgb absorption_{0, 0, 0};
};

}  // namespace

PathResult trace_path(const PreparedScene& world, const CameraRays& rays,
                      const PathSettings& settings, const GuidingData& guiding,
                      SampleCursor& numbers, const PathRecorders& recorders) {
  return PathTracer(world, rays, settings, guiding, numbers, recorders).trace();
}

}  // namespace vug::render
