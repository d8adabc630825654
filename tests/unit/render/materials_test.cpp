// SPDX-License-Identifier: Apache-2.0
// Properties of every material in the registry: samples have their density, the BSDF is reciprocal,
// and white conserves energy. Cases are the kind's defaults, and each fraction in 0..1 set to 1, so
// that a new kind or lobe is tested as soon as it is listed.
#include "chi2.h"
#include "uniform.h"

#include <vug/base/rng.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

constexpr int kSamples = 100000;

double level(int tests) { return 1 - std::pow(0.99, 1.0 / tests); }

float one(RandomStream& random) { return uniform_2d(random).x; }

Value as_value(const MaterialPtr& material) { return ValueTraits<MaterialPtr>::write(material); }

struct Case {
  std::string kind, name;
  NamedValues parameters;
  bool variant = false;  ///< With a switch inverted.

  MaterialPtr make(const NamedValues& more = {}) const {
    NamedValues all = parameters;
    for (const auto& given : more) {
      const auto known = std::find_if(all.begin(), all.end(),
                                      [&](const auto& each) { return each.first == given.first; });
      if (known == all.end())
        all.push_back(given);
      else
        known->second = given.second;
    }
    return make_material(kind, all);
  }
};

const KindInfo& info_of(const std::string& kind) { return find_kind(materials(), kind)->info; }

bool is_roughness(const ParamInfo& p) { return p.name.find("roughness") != std::string::npos; }
bool is_share(const ParamInfo& p) {
  return p.type.find("number") == 0 && p.min == 0 && p.max == 1 && !is_roughness(p);
}

/// `white`: required colours are white.
std::vector<Case> cases(bool white) {
  std::vector<Case> all;
  for (const auto* kind : materials()) {
    if (kind->info.name == "by_rock") continue;  // Consists of `mix`, by attributes of a mesh.
    NamedValues needed;
    for (const ParamInfo& p : kind->info.params) {
      if (p.type == "material" && p.required) {
        const Vec3d albedo(white ? 1.0 : 0.4);
        needed.emplace_back(
            p.name, as_value(needed.empty() ? make_material("lambert", {{"albedo", albedo}})
                                            : make_material("coated", {{"albedo", albedo},
                                                                       {"roughness", 0.5}})));
      }
      const bool color = p.type == "colour or paint" || p.name == "albedo";
      if (white && color) needed.emplace_back(p.name, Vec3d(1));
    }
    std::vector<Case> basic = {{kind->info.name, kind->info.name, needed}};
    for (const ParamInfo& p : kind->info.params)
      if (p.type == "true or false") {
        Case other{kind->info.name, kind->info.name + " " + p.name, needed};
        other.parameters.emplace_back(p.name, p.fallback != "true");
        other.variant = true;
        basic.push_back(std::move(other));
      }
    for (const Case& base : basic) {
      all.push_back(base);
      for (const ParamInfo& p : kind->info.params) {
        if (!is_share(p)) continue;
        Case more = base;
        more.name += " with " + p.name + " 1";
        more.parameters.emplace_back(p.name, 1.0);
        all.push_back(std::move(more));
      }
    }
  }
  return all;
}

Surface flat_surface(bool inside) {
  Surface surface;
  surface.position = {0, 0, 0};
  surface.geometric_normal = surface.shading_normal = {0, 0, 1};
  surface.inside = inside;
  return surface;
}

TEST(Materials, SampleTheirDensity) {
  const float cosines[] = {1.0f, 0.95f, 0.85f, 0.7f, 0.5f, 0.4f, 0.3f, 0.2f, 0.1f, 0.01f};
  const std::vector<Case> all = cases(false);
  const int tests = static_cast<int>(2 * all.size() * std::size(cosines));
  size_t turn = 0;
  for (const Case& each : all) {
    ++turn;
    for (const float cosine : cosines) {
      // The basic case of a kind covers all cosines, its variants and shares half of them.
      const size_t place = static_cast<size_t>(&cosine - cosines);
      if (each.variant && place > 4) continue;
      if (each.name != each.kind && !each.variant && place % 2 != turn % 2) continue;
      const bool inside = cosine == 0.7f || cosine == 0.2f;
      SCOPED_TRACE(each.name + " at cosine " + std::to_string(cosine));
      // Narrower lobes slip through the quadrature of the expected counts.
      NamedValues wide;
      for (const ParamInfo& p : info_of(each.kind).params)
        if (is_roughness(p)) wide.emplace_back(p.name, 0.4);
      const MaterialPtr material = each.make(wide);
      BsdfMemory memory;
      const Bsdf& bsdf = material->at(flat_surface(inside), direction_at(cosine, 0.3f), memory);
      // Each side separately, so that the cells are narrow around both poles.
      for (const float side : {1.0f, -1.0f}) {
        RandomStream random(RandomKey(5).at(each.name));
        int wrong = 0;
        const Chi2 result = chi2(
            {0, 0, side}, 1 + 1e-6, kSamples,  // past the horizon by rounding
            [&](int) -> DirectionSample {
              const float lobe = one(random);
              const BsdfSample s = bsdf.sample(lobe, uniform_2d(random));
              if (!(s.pdf > 0) || s.subsurface || s.direction.z * side < 0) return {};
              const Scattering f = bsdf.evaluate(s.direction);
              const auto agrees = [&](float weighed, float value) {
                return std::fabs(weighed * s.pdf - value) <= 2e-3f * value + 1e-6f;
              };
              wrong += !agrees(s.weight.x, f.total().x) || !agrees(s.diffuse.x, f.diffuse.x);
              return {s.direction, static_cast<double>(s.pdf)};
            },
            [&](const Vec3f& in) { return static_cast<double>(bsdf.evaluate(in).pdf); }, 32);
        EXPECT_EQ(wrong, 0);
        EXPECT_TRUE(result.integral == 0 || result.p > level(tests)) << result.p;
        EXPECT_LT(result.integral, 1.003);
        EXPECT_LE(result.stray, 2);
        EXPECT_LT(result.disagreements, kSamples / 10000);
      }
    }
  }
}

// Helmholtz reciprocity; refraction preserves radiance over the square of the index, so f times the
// square of the viewer's index is symmetric.
TEST(Materials, AreReciprocal) {
  for (const Case& each : cases(false)) {
    SCOPED_TRACE(each.name);
    const MaterialPtr material = each.make();
    double index = 1;
    for (const ParamInfo& p : info_of(each.kind).params)
      if (p.name == "ior" && !material->thin()) index = std::stod(p.fallback);
    RandomStream random(RandomKey(6).at(each.name));
    const auto f = [&](const Vec3f& out, const Vec3f& in, bool inside) {
      BsdfMemory memory;
      const Bsdf& bsdf = material->at(flat_surface(inside), out, memory);
      return static_cast<double>(bsdf.evaluate(in).total().y / std::fabs(in.z));
    };
    for (int trial = 0; trial < 300; ++trial) {
      Vec3f a = sample_cosine_hemisphere(uniform_2d(random)),
            b = sample_cosine_hemisphere(uniform_2d(random));
      a.z = std::max(a.z, 1e-3f), b.z = std::max(b.z, 1e-3f);
      a.normalize(), b.normalize();
      const double there = f(a, b, false);
      EXPECT_NEAR(there, f(b, a, false), 1e-3 * there + 1e-6);
      // From above to below and back: the frame of a viewer below is flipped.
      const double down = f(a, {b.x, b.y, -b.z}, false);
      const double up = f({b.x, -b.y, b.z}, {a.x, -a.y, -a.z}, true);
      EXPECT_NEAR(down, up * index * index, 2e-3 * down + 1e-5);
    }
  }
}

/// Radiance towards a viewer in a uniform environment of 1, by scrambled sequences; their spread
/// gives the error.
struct Furnace {
  double kept = 0, error = 0;
};
Furnace furnace(const Bsdf& bsdf, uint32_t samples = 256) {
  static const SamplerPtr sobol = make_sampler("sobol");
  constexpr int kTrials = 16;
  double sum = 0, squares = 0;
  for (uint64_t trial = 0; trial < kTrials; ++trial) {
    double kept = 0;
    SampleId id;
    id.spp = samples, id.seed = trial;
    for (; id.index < id.spp; ++id.index) {
      SampleCursor numbers(*sobol, id);
      const Vec2f u = numbers.pair();
      const BsdfSample s = bsdf.sample(numbers.single(), u);
      if (s.pdf > 0) kept += static_cast<double>(largest(s.weight)) / id.spp;
    }
    sum += kept, squares += kept * kept;
  }
  const double mean = sum / kTrials;
  const double error = std::sqrt(std::max(0.0, squares / kTrials - mean * mean) / (kTrials - 1));
  if (error > 0.0008 && samples < 16384) return furnace(bsdf, 4 * samples);
  return {mean, error};
}

TEST(Materials, WhiteOnesConserveEnergy) {
  for (const Case& each : cases(true))
    for (const double roughness : {0.02, 0.1, 0.3, 0.6, 1.0}) {
      NamedValues rough;
      for (const ParamInfo& p : info_of(each.kind).params)
        if (is_roughness(p)) rough.emplace_back(p.name, std::max(roughness, p.min));
      if (rough.empty() && roughness > 0.02) continue;
      const MaterialPtr material = each.make(rough);
      for (const bool inside : {false, true})
        for (const float cosine : {1.0f, 0.8f, 0.5f, 0.3f, 0.1f, 0.03f}) {
          SCOPED_TRACE(each.name + ", roughness " + std::to_string(roughness) + ", cosine " +
                       std::to_string(cosine) + (inside ? ", from inside" : ""));
          BsdfMemory memory;
          const Bsdf& bsdf = material->at(flat_surface(inside), direction_at(cosine, 0.2f), memory);
          const Furnace light = furnace(bsdf);
          EXPECT_LT(light.error, 0.002);
          EXPECT_GT(light.kept, 0.995 - 4 * light.error);
          EXPECT_LT(light.kept, 1.001 + 4 * light.error);
        }
    }
}

// Colours between black and white never reflect more than they receive, whatever the index.
TEST(Materials, NeverReflectMoreThanTheyReceive) {
  RandomStream random(RandomKey(12));
  for (const Case& each : cases(true))
    for (int trial = 0; trial < 3; ++trial) {
      NamedValues some;
      for (const ParamInfo& p : info_of(each.kind).params) {
        if (p.type.find("number") != 0 || p.dimension != Dimension::none || p.max > 3) continue;
        const double place = p.max > 1 ? trial % 3 * 0.5 : random.uniform();  // few indices
        some.emplace_back(p.name, std::max(p.min, 0.0) * (1 - place) + p.max * place);
      }
      const MaterialPtr material = each.make(some);
      SCOPED_TRACE(each.name + ", trial " + std::to_string(trial));
      BsdfMemory memory;
      const Bsdf& bsdf = material->at(flat_surface(trial % 2 == 1),
                                      direction_at(0.02f + 0.98f * one(random), 0.7f), memory);
      const Furnace light = furnace(bsdf);
      EXPECT_LT(light.kept, 1.002 + 4 * light.error);
      EXPECT_GT(light.kept, 0.99 - 4 * light.error);
    }
}

TEST(Materials, FitTheMemoryTheyNeed) {
  MaterialPtr mixed = make_material("surface");
  try {
    for (int depth = 0; depth < 20; ++depth)
      mixed = make_material("mix", {{"a", as_value(mixed)}, {"b", as_value(mixed)}});
    FAIL() << "mixes of any depth are taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too many materials"), std::string::npos);
  }
  EXPECT_LE(mixed->memory_bytes(), BsdfMemory::kBytes);
}

}  // namespace
}  // namespace vug::render
