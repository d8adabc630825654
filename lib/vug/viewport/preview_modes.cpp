// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/srgb.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>
#include <vug/viewport/preview_modes.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vug::viewport {
namespace {

using render::Hit;
using render::Ray;
using render::Rgb;

/// Share of the distance of a surface within which others occlude it.
constexpr float kOcclusionReach = 0.2f;

/// Linear values of the display, so that a clay picture needs no exposure.
constexpr float kHeadlight = 0.42f, kSky = 0.2f, kOccluded = 0.3f;

Rgb background(const Vec3f& direction) {
  const float up = 0.5f + 0.5f * direction.y;
  return Rgb(0.035f, 0.04f, 0.05f) * (1 - up) + Rgb(0.1f, 0.12f, 0.15f) * up;
}

float facing(const Ray& ray, const Vec3f& normal) {
  return std::max(0.0f, -render::dot(normal, ray.direction));
}

class PreviewIntegrator : public render::Integrator {
 public:
  render::PathResult trace(const render::PreparedScene& world, const Ray& ray,
                           render::SampleCursor& numbers, render::LightPathRecorder*,
                           std::span<const Ray>) const override {
    render::PathResult out;
    Hit hit;
    if (!world.intersect(ray, hit)) {
      out.radiance = background(ray.direction);
      return out;
    }
    out.alpha = 1;
    out.first = {true, hit.surface.position, hit.surface.shading_normal, Rgb(0.5f), hit.object};
    out.radiance = shade(world, ray, hit, numbers);
    return out;
  }

 private:
  virtual Rgb shade(const render::PreparedScene& world, const Ray& ray, const Hit& hit,
                    render::SampleCursor& numbers) const = 0;
};

class ClayIntegrator final : public PreviewIntegrator {
 public:
  explicit ClayIntegrator(bool occlusion) : occlusion_(occlusion) {}

 private:
  Rgb shade(const render::PreparedScene& world, const Ray& ray, const Hit& hit,
            render::SampleCursor& numbers) const override {
    const Vec3f& normal = hit.surface.shading_normal;
    const float open = occlusion_ ? openness(world, hit, numbers) : 1;
    const float sky = kSky * (0.6f + 0.4f * normal.y) * open;
    const float head = kHeadlight * facing(ray, normal) * (0.5f + 0.5f * open);
    return Rgb(1, 0.97f, 0.93f) * head + Rgb(0.93f, 0.97f, 1) * sky;
  }

  /// 1 for a direction of the cosine distribution without a surface near by.
  static float openness(const render::PreparedScene& world, const Hit& hit,
                        render::SampleCursor& numbers) {
    const render::Frame frame(hit.surface.shading_normal);
    const Vec3f direction = frame.to_world(render::sample_cosine_hemisphere(numbers.pair()));
    const Ray ray{hit.origin, render::normalized(direction)};
    return world.occluded(ray, kOcclusionReach * hit.distance) ? kOccluded : 1;
  }

  bool occlusion_;
};

class NormalIntegrator final : public PreviewIntegrator {
 private:
  Rgb shade(const render::PreparedScene&, const Ray&, const Hit& hit,
            render::SampleCursor&) const override {
    const Vec3f& n = hit.surface.shading_normal;
    const auto shown = [](float x) {
      return static_cast<float>(srgb_decode(0.5 + 0.5 * static_cast<double>(x)));
    };
    return {shown(n.x), shown(n.y), shown(n.z)};
  }
};

class IdIntegrator final : public PreviewIntegrator {
 private:
  Rgb shade(const render::PreparedScene&, const Ray& ray, const Hit& hit,
            render::SampleCursor&) const override {
    // Hues by multiples of the golden ratio, so that neighbours in the list differ.
    const float turn = 0.618034f * static_cast<float>(hit.object % 4096);
    const float hue = 6 * (turn - std::floor(turn));
    const auto wave = [&](float shift) {
      const float at = std::fmod(hue + shift, 6.0f);
      return std::clamp(std::fabs(at - 3) - 1, 0.0f, 1.0f);
    };
    const Rgb pure(wave(0), wave(4), wave(2));
    return (Rgb(0.12f) + pure * 0.5f) * (0.35f + 0.65f * facing(ray, hit.surface.shading_normal));
  }
};

}  // namespace

const std::vector<std::string>& mode_names() {
  static const std::vector<std::string> names = {"clay", "normals", "ids", "path"};
  return names;
}

Mode mode_of(const std::string& name) {
  const auto& names = mode_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(ErrorCode::bad_input, fmt::format("unknown mode '{}' of the viewport", name), {},
                fmt::format("use one of: {}", fmt::join(names, ", ")));
  return static_cast<Mode>(found - names.begin());
}

render::IntegratorPtr preview_integrator(Mode mode, bool occlusion) {
  static const render::IntegratorPtr open = std::make_shared<const ClayIntegrator>(false),
                                     occluded = std::make_shared<const ClayIntegrator>(true),
                                     normals = std::make_shared<const NormalIntegrator>(),
                                     ids = std::make_shared<const IdIntegrator>();
  switch (mode) {
    case Mode::clay:
      return occlusion ? occluded : open;
    case Mode::normals:
      return normals;
    case Mode::ids:
      return ids;
    case Mode::path:
      break;
  }
  return nullptr;
}

}  // namespace vug::viewport
