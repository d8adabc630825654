// SPDX-License-Identifier: Apache-2.0
// Interface of integrators: computes the radiance along a camera ray.
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
struct GuidingData;

/// The first surface on a camera ray, for AOVs.
struct FirstHit {
  bool hit = false;
  Vec3f position{0, 0, 0};
  Vec3f normal{0, 0, 0};  ///< Shading normal, on the viewer's side.
  Rgb albedo{0, 0, 0};
  uint32_t object = kNoObject;  ///< Index in Scene::objects.
};

struct PathResult {
  Rgb radiance{0, 0, 0};
  float alpha = 0;  ///< 0 if the camera ray sees only the environment.
  FirstHit first;
  float time = 0.5f;  ///< Shutter time of the camera ray: 0 as the shutter opens, 1 as it closes.
};

/// The picture to be rendered, as far as integrators may use it for training.
struct TrainingContext {
  const PreparedScene& world;
  const Camera& camera;
  const Sampler& sampler;
  float aspect = 1;      ///< Width over height.
  uint64_t samples = 0;  ///< Number for the whole picture.
  uint64_t seed = 0;

  /// The id of sample `index` out of `count`; `salt` separates independent uses of random numbers.
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
  /// Learns to guide paths in this scene; null if there is nothing to learn. The result is the same
  /// for any number of threads and for every slice of the picture.
  virtual std::shared_ptr<const GuidingData> learn(const TrainingContext& context,
                                                   Progress& progress) const {
    (void)context, (void)progress;
    return nullptr;
  }
  /// The integrator, guided by data that it has learned before; null if it does not learn.
  virtual std::shared_ptr<const Integrator> guided_by(
      std::shared_ptr<const GuidingData> guiding) const {
    (void)guiding;
    return nullptr;
  }
  /// The settings that bias the picture, such as "clamp 3"; empty without any.
  virtual std::string inexact() const { return {}; }
  /// `recorder`: records the components of the radiance; may be null. `extra_rays`: further camera
  /// rays of the pixel; directly visible emission becomes the mean over all of them.
  virtual PathResult trace(const PreparedScene& world, const Ray& ray, SampleCursor& numbers,
                           LightPathRecorder* recorder = nullptr,
                           std::span<const Ray> extra_rays = {}) const = 0;
};
using IntegratorPtr = std::shared_ptr<const Integrator>;

}  // namespace vug::render
