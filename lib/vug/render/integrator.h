// The seam of integrators: from a camera ray to radiance.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/light.h>
#include <vug/render/sampler.h>
#include <vug/render/vectors.h>

#include <memory>
#include <span>
#include <string>

namespace vug::render {

class Camera;
class LightPathRecorder;
class PreparedScene;

/// What the first surface on a camera ray looks like.
struct FirstHit {
  bool hit = false;
  Vec3f position{0, 0, 0};
  Vec3f normal{0, 0, 0};  ///< Shading normal, on the viewer's side.
  Rgb albedo{0, 0, 0};
  uint32_t object = kNoObject;  ///< Index in the scene.
};

struct PathResult {
  Rgb radiance{0, 0, 0};
  float alpha = 0;  ///< 0 where the camera ray sees only the sky.
  FirstHit first;
  float time = 0.5f;  ///< At which the camera looked, from 0 as the shutter opens to 1.
};

/// The picture that paths will be traced for, as far as they can learn from it beforehand.
struct TrainingContext {
  const PreparedScene& world;
  const Camera& camera;
  const Sampler& sampler;
  float aspect = 1;      ///< Width over height.
  uint64_t samples = 0;  ///< Of the whole picture.
  uint64_t seed = 0;

  /// Of the index-th of `count` samples; `salt` tells one use of numbers from others.
  SampleId sample_id(uint64_t salt, size_t index, size_t count) const {
    SampleId id;
    id.seed = seed ^ salt;
    id.spp = static_cast<uint32_t>(count);
    id.index = static_cast<uint32_t>(index);
    return id;
  }
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// The integrator that knows this scene; null when there is nothing to learn. The same for any
  /// number of threads and for every part of the picture.
  virtual std::shared_ptr<const Integrator> trained(const TrainingContext& context,
                                                    Progress& progress) const {
    (void)context, (void)progress;
    return nullptr;
  }
  /// What makes pictures other than exact, on request: "clamp 3"; empty where nothing does.
  virtual std::string inexact() const { return {}; }
  /// `recorder`: null, or where to keep the parts of the radiance apart. `extra_rays`: more camera
  /// rays of the pixel; what the camera sees shine by itself becomes the mean over all of them.
  virtual PathResult trace(const PreparedScene& world, const Ray& ray, SampleCursor& numbers,
                           LightPathRecorder* recorder = nullptr,
                           std::span<const Ray> extra_rays = {}) const = 0;
};
using IntegratorPtr = std::shared_ptr<const Integrator>;

}  // namespace vug::render
