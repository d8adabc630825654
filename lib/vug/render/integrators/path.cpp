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
  Roulette roulette = Roulette::worth;
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
                {{"worth", Roulette::worth},
                 {"throughput", Roulette::throughput},
                 {"off", Roulette::off}},
                "Which paths end at random, and count for more where they go on: worth ends those "
                "that would add little to the picture, behind the first surface; throughput all "
                "by the root of what they carry, from the first surface on, as most path tracers "
                "do: more samples a second, more noise in each; off none: less noise, more time.")
        .param("light_samples", &Path::light_samples,
               {.doc = "Lights that the first surface a path meets looks at; others look at one.",
                .min = 1,
                .max = static_cast<double>(LightChoices::kMost)})
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

/// Pictures of fewer samples are done before a guide is learned.
constexpr uint64_t kWorthLearning = 1u << 16;
/// The guide learns from this part of the samples, and at most so many.
constexpr double kLearning = 0.04;
constexpr uint64_t kFewestPaths = 1u << 12, kMostPaths = 1u << 18;

class PathIntegrator final : public Integrator {
 public:
  explicit PathIntegrator(const Path& p)
      : rules_{p.max_bounces,
               p.roulette,
               static_cast<float>(p.light_samples),
               p.light_sampler,
               p.clamp ? static_cast<float>(*p.clamp) : kFar,
               static_cast<float>(p.regularize)},
        guided_(p.guide) {}

  std::string inexact() const override {
    std::string out;
    if (rules_.most < kFar) out = fmt::format("clamp {:g}", rules_.most);
    if (rules_.regularize > 0)
      out += fmt::format("{}regularize {:g}", out.empty() ? "" : ", ", rules_.regularize);
    return out;
  }

  std::shared_ptr<const Integrator> rehearsed(const Rehearsal& rehearsal,
                                              Progress& progress) const override {
    if (guided_ == Guided::off || rules_.max_bounces < 1) return nullptr;
    if (guided_ == Guided::automatic && rehearsal.samples < kWorthLearning) return nullptr;
    const auto share = static_cast<uint64_t>(kLearning * static_cast<double>(rehearsal.samples));
    const auto gather = [&](const Ray& ray, SampleCursor& numbers, const Learned& learned,
                            Trail& trail) {
      trail.learn(walk(rehearsal.world, ray, rules_, learned, numbers, nullptr, &trail).radiance);
    };
    auto led = std::make_shared<PathIntegrator>(*this);
    led->learned_ = learn(rehearsal, std::clamp(share, kFewestPaths, kMostPaths), gather, progress);
    return led;
  }
  PathResult trace(const World& world, const Ray& ray, SampleCursor& numbers, Tally* tally,
                   std::span<const Ray> beside) const override {
    return walk(world, ray, rules_, learned_, numbers, tally, nullptr, beside);
  }

 private:
  WalkRules rules_;
  Guided guided_;
  Learned learned_;
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(path, integrator, IntegratorPtr, Path, PathIntegrator)
