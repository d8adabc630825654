// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/raytree/path_scheduler.h>
#include <vug/render/camera.h>
#include <vug/render/paths/training.h>
#include <vug/render/paths/vertex.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <algorithm>
#include <array>

namespace vug::render {
namespace {

constexpr uint64_t kTrainingSalt = 0x6775696465ull;

/// Share of the samples of a picture that are used for training, and the limits of their number.
constexpr double kTrainingFraction = 0.04;
constexpr uint64_t kMinPaths = 1u << 12, kMaxPaths = 1u << 18;
/// Training rounds; each has twice the paths of the previous one and is guided by it, so that paths
/// found by chance become frequent in the next round.
constexpr int kRounds = 3;
constexpr size_t kChunk = 256;
/// Number of points for visibility samples, relative to the paths of a round; they are spread
/// evenly over all radiance samples.
constexpr double kPointsPerPath = 0.5;
/// Number of lights tested from each point.
constexpr size_t kLightsPerPoint = 4;
/// Edge of the regions that share visibility and radiance: see Regions.
constexpr float kRadianceRegion = 1.0f / 32;

constexpr uint32_t kNothing = ~0u;

/// Removes samples without a target.
std::vector<VisibilitySample> without_empty(std::vector<VisibilitySample> visibility_samples) {
  visibility_samples.erase(
      std::remove_if(visibility_samples.begin(), visibility_samples.end(),
                     [](const VisibilitySample& sample) { return sample.target == kNothing; }),
      visibility_samples.end());
  return visibility_samples;
}

/// Traces `paths` training paths over the whole picture; returns their samples in order.
std::vector<RadianceSample> trace_training_paths(const TrainingContext& context, size_t paths,
                                                 uint64_t salt, const GuidingData& guiding,
                                                 const TrainingPath& trace, Progress& progress) {
  std::vector<std::vector<RadianceSample>> chunks((paths + kChunk - 1) / kChunk);
  parallel_for(chunks.size(), [&](size_t chunk) {
    progress.check();
    std::array<std::vector<RadianceSample>, raytree::kMaxInFlight> seen;
    const size_t begin = chunk * kChunk;
    raytree::run_interleaved(
        std::min(paths - begin, kChunk),
        [&](size_t i) {
          SampleCursor numbers(context.sampler,
                               context.sample_id(kTrainingSalt + salt, begin + i, paths));
          const Vec2f film = numbers.pair(), lens = numbers.pair();
          PathRecorder path_recorder(seen[i % raytree::kMaxInFlight]);
          trace(context.camera.ray(film, context.aspect, lens), numbers, guiding, path_recorder);
        },
        [&](size_t i) {
          std::vector<RadianceSample>& path = seen[i % raytree::kMaxInFlight];
          chunks[chunk].insert(chunks[chunk].end(), path.begin(), path.end());
          path.clear();
        });
  });
  std::vector<RadianceSample> out;
  for (const std::vector<RadianceSample>& chunk : chunks)
    out.insert(out.end(), chunk.begin(), chunk.end());
  return out;
}

/// Tests the visibility of clusters from points on paths: half of the time of a cluster that would
/// light the point, half of any cluster, since the estimated visibility may be wrong here.
std::vector<VisibilitySample> sample_cluster_visibility(
    const TrainingContext& context, size_t most, uint64_t salt, const Guide& guide,
    const std::vector<RadianceSample>& radiance_samples, Progress& progress) {
  const size_t step = std::max<size_t>(1, radiance_samples.size() / std::max<size_t>(most, 1));
  const size_t places = radiance_samples.size() / step;
  const std::vector<BrightCluster>& clusters = guide.clusters();
  std::vector<VisibilitySample> visibility_samples(2 * places,
                                                   VisibilitySample{{0, 0, 0}, kNothing, false});
  raytree::parallel_interleaved(places, [&](size_t place) {
    progress.check();
    const RadianceSample& at = radiance_samples[place * step];
    SampleCursor numbers(context.sampler, context.sample_id(kTrainingSalt + salt, place, places));
    const ConeMixture cones = guide.at(at.point, at.normal);
    for (size_t i = 2 * place; i < 2 * place + 2; ++i) {
      const Vec2f which = numbers.pair(), u = numbers.pair();
      auto cluster = static_cast<uint32_t>(which.x * static_cast<float>(clusters.size()));
      if (i % 2 == 0) {
        if (cones.size() == 0) continue;
        cluster = cones.id(cones.choose(which.x));
      }
      const Vec3f to = clusters[cluster].center - at.point;
      const float distance = length(to), radius = clusters[cluster].radius;
      if (!(distance > radius)) continue;
      const float sine = radius / distance, rim = one_minus_cosine(sine * sine);
      const Vec3f direction = Frame(to / distance).to_world(direction_off_axis(rim * u.x, u.y));
      if (!(dot(direction, at.normal) > 0)) continue;
      Hit hit;
      const bool found = context.world.intersect({at.point, direction}, hit);
      const bool reached =
          found && length(hit.surface.position - clusters[cluster].center) <= radius;
      visibility_samples[i] = {at.point, cluster, reached};
    }
  });
  return without_empty(std::move(visibility_samples));
}

/// A random point on a ray along which light may reach a surface.
LightSampleContext point_in_medium(const PreparedScene& world, const RadianceSample& at,
                                   SampleCursor& numbers) {
  const Ray ray{at.point, Frame(at.normal).to_world(sample_cosine_hemisphere(numbers.pair()))};
  Hit hit;
  const float end = world.intersect(ray, hit) ? hit.distance : length(world.bounds().size());
  return {ray.at(end * numbers.single())};
}

/// Tests the visibility of lights from points on paths, for a few branches each in turn.
std::vector<VisibilitySample> sample_light_visibility(
    const TrainingContext& context, size_t most, uint64_t salt,
    const std::vector<RadianceSample>& radiance_samples, Progress& progress) {
  const PreparedScene& world = context.world;
  const size_t branches = world.lights().branches(), each = std::min(branches, kLightsPerPoint);
  const size_t step = std::max<size_t>(1, radiance_samples.size() / std::max<size_t>(most, 1));
  const size_t places = radiance_samples.size() / step;
  std::vector<VisibilitySample> visibility_samples(each * places,
                                                   VisibilitySample{{0, 0, 0}, kNothing, false});
  raytree::parallel_interleaved(places, [&](size_t place) {
    progress.check();
    const RadianceSample& at = radiance_samples[place * step];
    SampleCursor numbers(context.sampler, context.sample_id(kTrainingSalt + salt, place, places));
    LightSampleContext point{at.point, at.normal};
    if (world.medium() && place % 2 == 1) point = point_in_medium(world, at, numbers);
    for (size_t i = each * place; i < each * (place + 1); ++i) {
      const float which = numbers.single();
      const Vec2f u = numbers.pair();
      const LightChoice chosen = world.lights().choose_in(i % branches, point, which);
      if (chosen.light == kNoLight) continue;
      const LightSample s = world.lights().sample(chosen.light, point, u);
      if (!(s.pdf > 0) || (point.on_surface() && !(dot(s.direction, point.normal) > 0)) ||
          is_black(unoccluded_radiance(world, s, kNoObject)))
        continue;
      visibility_samples[i] = {point.position, static_cast<uint32_t>(i % branches),
                               !occluded(world, {point.position, s.direction}, s.distance)};
    }
  });
  return without_empty(std::move(visibility_samples));
}

}  // namespace

uint64_t training_paths(uint64_t samples) {
  const auto share = static_cast<uint64_t>(kTrainingFraction * static_cast<double>(samples));
  return std::clamp(share, kMinPaths, kMaxPaths);
}

GuidingData train(const TrainingContext& context, uint64_t paths, const TrainingPath& trace,
                  Progress& progress) {
  progress.begin("learning where light comes from", 2 * kRounds);
  const Box3f& bounds = context.world.bounds();
  const size_t branches = context.world.lights().branches();
  const auto places = static_cast<size_t>(kPointsPerPath * static_cast<double>(paths));
  std::vector<RadianceSample> radiance_samples;
  GuidingData guiding;
  for (int round = 0; round < kRounds; ++round) {
    const auto salt = static_cast<uint64_t>(3 * round);
    const std::vector<RadianceSample> traced = trace_training_paths(
        context, std::max<size_t>(1, (paths << round) >> kRounds), salt, guiding, trace, progress);
    radiance_samples.insert(radiance_samples.end(), traced.begin(), traced.end());
    progress.advance();
    if (branches > 1)
      guiding.light_visibility = VisibilityCache(
          bounds, kRadianceRegion, branches,
          sample_light_visibility(context, places, salt + 1, radiance_samples, progress));
    guiding.guide = Guide(radiance_samples, bounds);
    if (!guiding.guide.empty())
      guiding.guide.update_visibility(sample_cluster_visibility(
          context, places, salt + 2, guiding.guide, radiance_samples, progress));
    progress.advance();
  }
  // Not earlier: paths that ended by it would underestimate the radiance that they end by.
  guiding.radiance = RadianceCache(radiance_samples, bounds, kRadianceRegion);
  progress.end();
  return guiding;
}

}  // namespace vug::render
