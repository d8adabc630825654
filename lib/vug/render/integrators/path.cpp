// Unidirectional path tracing with next-event estimation, led by a guide to bright surfaces.
#include <vug/render/kind.h>
#include <vug/render/paths/trace_path.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::render {
namespace {

enum class Guided { automatic, on, off };

struct Path {
  int max_bounces = 8;
  Roulette roulette = Roulette::adjoint;
  int light_samples = 2;
  LightSampler light_sampler = LightSampler::tree;
  Guided guide = Guided::automatic;
  std::optional<double> clamp;
  double regularize = 0;

  static void describe(Schema<Path>& s) {
    s.doc("Path tracing from the camera with direct sampling of lights.")
        .cite("veach1997")
        .param("max_bounces", &Path::max_bounces,
               {.doc = "A path scatters at most once more than this.", .min = 0, .max = 1000})
        .choice("roulette", &Path::roulette,
                {{"worth", Roulette::adjoint},
                 {"throughput", Roulette::throughput},
                 {"off", Roulette::off}},
                "Which paths end at random, and count for more where they go on: worth ends those "
                "that would add little to the picture, behind the first surface; throughput all "
                "by the root of what they carry, from the first surface on, as most path tracers "
                "do: more samples a second, more noise in each; off none: less noise, more time.")
        .param("light_samples", &Path::light_samples,
               {.doc = "Lights that the first surface a path meets looks at; others look at one.",
                .min = 1,
                .max = static_cast<double>(LightChoices::kMax)})
        .choice("light_sampler", &Path::light_sampler,
                {{"tree", LightSampler::tree}, {"uniform", LightSampler::uniform}},
                "How a surface chooses its lights: tree by what they may give it, thousands as "
                "readily as ten; uniform any of them alike, which costs less and is noisy as soon "
                "as lights are of different use.")
        .param("clamp", &Path::clamp,
               {.doc = "Cuts light that comes over more than one surface to this radiance: fewer "
                       "fireflies, and a darker, no longer exact picture. Not cut when not given.",
                .min = 0,
                .above_min = true})
        .param("regularize", &Path::regularize,
               {.doc = "Roughness that faces have at least where light is followed to them over "
                       "matte ones, 0.3 to 0.5: small lights over water and polish make soft light "
                       "instead of bright dots, and the picture is no longer exact.",
                .min = 0,
                .max = 1})
        .choice("guide", &Path::guide,
                {{"auto", Guided::automatic}, {"on", Guided::on}, {"off", Guided::off}},
                "Learns first which surfaces are bright, and from where these and the lights are "
                "seen, and lets paths turn to them: less noise where light comes over walls and "
                "where walls hide lights. auto leaves it out of tiny pictures.");
  }
};

/// Pictures of fewer samples are done before a guide is learned.
constexpr uint64_t kMinSamples = 1u << 16;
/// The guide learns from this part of the samples, and at most so many.
constexpr double kTrainingFraction = 0.04;
constexpr uint64_t kMinPaths = 1u << 12, kMaxPaths = 1u << 18;

class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(const Path& p)
      : settings_{p.max_bounces,
                  p.roulette,
                  static_cast<float>(p.light_samples),
                  p.light_sampler,
                  p.clamp ? static_cast<float>(*p.clamp) : kFar,
                  static_cast<float>(p.regularize)},
        guided_(p.guide) {}

  std::string inexact() const override {
    std::string out;
    if (settings_.max_radiance < kFar) out = fmt::format("clamp {:g}", settings_.max_radiance);
    if (settings_.regularize > 0)
      out += fmt::format("{}regularize {:g}", out.empty() ? "" : ", ", settings_.regularize);
    return out;
  }

  std::shared_ptr<const Integrator> trained(const TrainingContext& context,
                                            Progress& progress) const override {
    if (guided_ == Guided::off || settings_.max_bounces < 1) return nullptr;
    if (guided_ == Guided::automatic && context.samples < kMinSamples) return nullptr;
    const auto share =
        static_cast<uint64_t>(kTrainingFraction * static_cast<double>(context.samples));
    const auto trace = [&](const Ray& ray, SampleCursor& numbers, const GuidingData& guiding,
                           PathRecorder& path_recorder) {
      path_recorder.finish(
          trace_path(context.world, ray, settings_, guiding, numbers, nullptr, &path_recorder)
              .radiance);
    };
    auto with_guiding = std::make_shared<PathIntegrator>(*this);
    with_guiding->guiding_ =
        train(context, std::clamp(share, kMinPaths, kMaxPaths), trace, progress);
    return with_guiding;
  }
  PathResult trace(const PreparedScene& world, const Ray& ray, SampleCursor& numbers,
                   LightPathRecorder* recorder, std::span<const Ray> extra_rays) const override {
    return trace_path(world, ray, settings_, guiding_, numbers, recorder, nullptr, extra_rays);
  }

 private:
  PathSettings settings_;
  Guided guided_;
  GuidingData guiding_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(path, integrator, IntegratorPtr, Path, PathIntegrator)
