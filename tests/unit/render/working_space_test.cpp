// SPDX-License-Identifier: Apache-2.0
// A scene in another rendering colour space is the same scene: it emits the same light in other
// numbers, and reflects the same of white light.
#include "scenes.h"

#include <vug/render/materials/material_input.h>
#include <vug/render/working_space.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

using image::ColourMatrix;
using image::WorkingSpace;

const ColourMatrix& way() {
  static const ColourMatrix there(WorkingSpace::rec709, WorkingSpace::acescg);
  return there;
}

void expect_same(const Rgb& there, const Rgb& plain, const std::string& what) {
  const Rgb expected = way()(plain);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(there[i], expected[i], 1e-5f * (1 + std::fabs(expected[i]))) << what;
}

/// A light of every kind that needs no file, coloured where possible.
std::vector<std::pair<std::string, LightPtr>> all_lights() {
  std::vector<std::pair<std::string, LightPtr>> out;
  for (const auto* kind : lights()) {
    NamedValues arguments;
    bool whole = true;
    for (const ParamInfo& param : kind->info.params) {
      if (param.required) whole = false;
      if (param.name == "radiance") arguments.emplace_back("radiance", Vec3d(3, 1, 0.2));
      if (param.name == "group") arguments.emplace_back("group", std::string("key"));
    }
    if (whole) out.emplace_back(kind->info.name, make_light(kind->info.name, arguments));
  }
  return out;
}

TEST(WorkingSpace, LightsEmitTheSame) {
  const LightSampleContext point{{0.3f, -1.2f, 0.4f}, {0, 0, 0}, kNoObject};
  size_t shone = 0;
  for (const auto& [name, plain] : all_lights()) {
    const LightPtr there = in_space(plain, way());
    EXPECT_EQ(there->linking().group, plain->linking().group) << name;
    EXPECT_EQ(there->is_infinite(), plain->is_infinite()) << name;
    EXPECT_EQ(there->is_portal(), plain->is_portal()) << name;
    EXPECT_EQ(there->sampled_with_portals(), plain->sampled_with_portals()) << name;
    EXPECT_EQ(there->camera_visible(), plain->camera_visible()) << name;
    EXPECT_EQ(there->mean_luminance(), plain->mean_luminance()) << name;
    EXPECT_EQ(there->importance(point), plain->importance(point)) << name;
    EXPECT_EQ(there->bounds().strength, plain->bounds().strength) << name;
    for (int i = 0; i < 16; ++i) {
      const Vec2f u((static_cast<float>(i) + 0.5f) / 16, static_cast<float>(i * 7 % 16) / 16);
      const LightSample a = plain->sample(point, u), b = there->sample(point, u);
      EXPECT_EQ(a.pdf, b.pdf) << name;
      EXPECT_EQ(a.direction, b.direction) << name;
      if (!(a.pdf > 0)) continue;
      EXPECT_EQ(there->pdf(point, a.direction), plain->pdf(point, a.direction)) << name;
      expect_same(b.radiance, a.radiance, name);
      const Rgb sky = plain->is_infinite() ? plain->eval_environment(a.direction) : Rgb(0.0f);
      if (plain->is_infinite()) expect_same(there->eval_environment(a.direction), sky, name);
      LightHit met, met_there;
      const Ray ray{point.position, a.direction};
      const bool hit = !plain->is_infinite() && plain->intersect(ray, kFar, met);
      EXPECT_EQ(hit, !plain->is_infinite() && there->intersect(ray, kFar, met_there)) << name;
      if (hit) expect_same(met_there.radiance, met.radiance, name);
      shone += !is_black(a.radiance) || !is_black(sky);
    }
  }
  EXPECT_GT(shone, 40u);
}

/// The reflected fraction of white light: its colour is the same in both spaces, whatever parameter
/// of whatever kind it comes from.
TEST(WorkingSpace, MaterialsReflectTheSame) {
  Surface surface;
  surface.position = {0.1f, 0.2f, 0.3f};
  surface.geometric_normal = surface.shading_normal = {0, 0, 1};
  surface.color = {0.9f, 0.6f, 0.3f};
  const Vec3f out = normalized(Vec3f(0.3f, 0.2f, 0.8f));
  size_t colours = 0;
  for (const auto* kind : materials())
    for (const ParamInfo& param : kind->info.params) {
      if (param.type != "colour or paint" && !(param.type == "vector" && param.max == 1)) continue;
      for (const bool painted : {false, true}) {
        const Vec3d colour(0.8, 0.3, 0.1);
        if (painted && param.type == "vector") continue;
        const auto painting =
            paint::make_paint([colour](const paint::EvalPoint&) { return colour; });
        NamedValues arguments = {
            {param.name, painted ? ValueTraits<paint::Paint>::write(painting) : Value(colour)}};
        for (const ParamInfo& other : kind->info.params)
          if (other.name == "fuzz" || other.name == "transmission")
            arguments.emplace_back(other.name, 0.4);
          else if (other.name == "emission_radiance")
            arguments.emplace_back(other.name, 5.0);
        const MaterialPtr plain = make_material(kind->info.name, arguments);
        const MaterialPtr there = plain->in_space(way());
        BsdfMemory a, b;
        const Bsdf &one = plain->at(surface, out, a), &other = there->at(surface, out, b);
        const std::string what = kind->info.name + "." + param.name;
        // Coats transmit a colourless fraction of the light in and out, so that a sum of single
        // reflections is close, but not equal; one lobe's diffuse part is.
        const Rgb expected = way()(one.albedo());
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(other.albedo()[i], expected[i], 0.06f) << what;
        if (!is_black(one.absorption())) {
          const auto left = [](const Rgb& rate) {
            return Rgb(std::exp(-rate.x), std::exp(-rate.y), std::exp(-rate.z));
          };
          expect_same(left(other.absorption()), left(one.absorption()), what);
        }
        expect_same(there->emission(surface), plain->emission(surface), what);
        ++colours;
      }
    }
  EXPECT_GE(colours, 7u);
}

TEST(WorkingSpace, MediaScatterTheSame) {
  for (const auto* kind : media()) {
    const MediumPtr plain = make_medium(kind->info.name, {{"albedo", Vec3d(0.9, 0.5, 0.2)}});
    EXPECT_EQ(in_space(plain, way())->is_emissive(), plain->is_emissive());
    const MediumPtr there = in_space(plain, way());
    expect_same(there->albedo({0, 0, 0}), plain->albedo({0, 0, 0}), kind->info.name);
    EXPECT_EQ(there->typical_extinction(), plain->typical_extinction());
    EXPECT_EQ(there->needs_density(), plain->needs_density());
    EXPECT_EQ(there->phase(0.3f), plain->phase(0.3f));
    const Box3f box({-1, -1, -1}, {1, 1, 1});
    const MediumPtr fitted = plain->with_bounds(box), fitted_there = there->with_bounds(box);
    EXPECT_EQ(fitted == nullptr, fitted_there == nullptr);
    if (fitted) expect_same(fitted_there->albedo({0, 0, 0}), fitted->albedo({0, 0, 0}), "fitted");
  }
  EXPECT_EQ(in_space(MediumPtr(), way()), nullptr);
}

/// Under white light a picture of single reflections is the same in both spaces; that of a coloured
/// light on a coloured floor is not, which is why the space can be chosen.
TEST(WorkingSpace, PicturesOfWhiteLightAreTheSame) {
  Scene scene;
  scene.objects.push_back(object(floor_mesh(4), 0.5));
  scene.objects[0].material = make_material("lambert", {{"albedo", Vec3d(0.8, 0.3, 0.1)}});
  scene.camera = view({0, 3, 3}, {0, 0, 0}, 0.6);
  const auto picture = [&](const Vec3d& light, WorkingSpace space) {
    Scene lit = scene;
    lit.lights.push_back(make_light("sky", {{"radiance", light}}));
    Options o = options(8, 8, 16, 0);
    // Russian roulette depends on the colour's numbers.
    o.integrator =
        make_integrator("path", {{"max_bounces", 0.0}, {"roulette", Value::Name{"off"}}});
    return render(in_space(lit, space), o).select({"R", "G", "B"});
  };
  const auto furthest = [&](const Vec3d& light) {
    const image::Image a =
        image::in_rec709(picture(light, WorkingSpace::acescg), WorkingSpace::acescg);
    const image::Image b = picture(light, WorkingSpace::rec709);
    float most = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
      most = std::max(most, std::fabs(a.pixels[i] - b.pixels[i]));
    return most;
  };
  EXPECT_LT(furthest(Vec3d(0.7)), 1e-5f);
  EXPECT_GT(furthest({0.1, 0.9, 0.2}), 0.01f);
  const Scene same = in_space(scene, WorkingSpace::rec709);
  EXPECT_EQ(same.objects[0].material, scene.objects[0].material);
}

}  // namespace
}  // namespace vug::render
