// SPDX-License-Identifier: Apache-2.0
// Unidirectional path tracing with next-event estimation and path guiding.
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
    s.doc("Path tracing from the camera with next-event estimation.")
        .cite("veach1997")
        .param("max_bounces", &Path::max_bounces,
               {.doc = "Paths scatter at most max_bounces + 1 times.", .min = 0, .max = 1000})
        .choice(
            "roulette", &Path::roulette,
            {{"worth", Roulette::adjoint},
             {"throughput", Roulette::throughput},
             {"off", Roulette::off}},
            "Russian roulette: worth ends paths that would contribute little to the picture, "
            "after the first surface (adjoint-driven); throughput ends paths by the square root "
            "of their throughput, from the first surface on, as most path tracers do: more "
            "samples per second, more noise in each; off ends none: less noise, more time.")
        .param("light_samples", &Path::light_samples,
               {.doc = "Lights sampled at the first surface of a path; later surfaces sample one.",
                .min = 1,
                .max = static_cast<double>(LightChoices::kMax)})
        .choice("light_sampler", &Path::light_sampler,
                {{"tree", LightSampler::tree}, {"uniform", LightSampler::uniform}},
                "How surfaces choose lights: tree by their estimated contribution, efficient even "
                "for thousands of lights; uniform with equal probability, which is cheaper but "
                "noisy if lights contribute differently.")
        .param("clamp", &Path::clamp,
               {.doc = "Maximum radiance of indirect light: fewer fireflies, but a darker, biased "
                       "picture. No limit by default.",
                .min = 0,
                .above_min = true})
        .param(
            "regularize", &Path::regularize,
            {.doc = "Minimum roughness of specular lobes on paths that reach them from diffuse "
                    "surfaces, 0.3 to 0.5 if used: caustics of small lights in water and polished "
                    "surfaces are blurred instead of noisy, and the picture is biased.",
             .min = 0,
             .max = 1})
        .choice("guide", &Path::guide,
                {{"auto", Guided::automatic}, {"on", Guided::on}, {"off", Guided::off}},
                "Path guiding: a training pass learns where bright surfaces are, and from where "
                "they and the lights are visible. Less noise in indirect light, and where walls "
                "occlude lights. auto disables it for tiny pictures.");
  }
};

/// Pictures with fewer samples are not worth a training pass.
constexpr uint64_t kMinSamples = 1u << 16;

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

  std::shared_ptr<const GuidingData> learn(const TrainingContext& context,
                                           Progress& progress) const override {
    if (guided_ == Guided::off || settings_.max_bounces < 1) return nullptr;
    if (guided_ == Guided::automatic && context.samples < kMinSamples) return nullptr;
    const auto trace = [&](const Ray& ray, SampleCursor& numbers, const GuidingData& guiding,
                           PathRecorder& path_recorder) {
      path_recorder.finish(trace_path(context.world, {ray}, settings_, guiding, numbers,
                                      {.training = &path_recorder})
                               .radiance);
    };
    return std::make_shared<const GuidingData>(
        train(context, training_paths(context.samples), trace, progress));
  }
  std::shared_ptr<const Integrator> guided_by(
      std::shared_ptr<const GuidingData> guiding) const override {
    auto guided = std::make_shared<PathIntegrator>(*this);
    guided->guiding_ = std::move(guiding);
    return guided;
  }
  PathResult trace(const PreparedScene& world, const Ray& ray, SampleCursor& numbers,
                   LightPathRecorder* recorder, std::span<const Ray> extra_rays) const override {
    return trace_path(world, {ray, extra_rays}, settings_, *guiding_, numbers, {.light = recorder});
  }

 private:
  PathSettings settings_;
  Guided guided_;
  std::shared_ptr<const GuidingData> guiding_ = std::make_shared<const GuidingData>();
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(path, integrator, IntegratorPtr, Path, PathIntegrator)
