// The seam of integrators: from a camera ray to radiance.
#pragma once

#include <vug/render/sampler.h>
#include <vug/render/vectors.h>

#include <memory>

namespace vug::render {

class Tally;
class World;

/// What the first surface on a camera ray looks like.
struct FirstHit {
  bool hit = false;
  Vec3f position{0, 0, 0};
  Vec3f normal{0, 0, 0};  ///< Shading normal, on the viewer's side.
  Rgb albedo{0, 0, 0};
};

struct PathResult {
  Rgb radiance{0, 0, 0};
  float alpha = 0;  ///< 0 where the camera ray sees only the sky.
  FirstHit first;
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// `tally`: null, or where to keep the parts of the radiance apart.
  virtual PathResult trace(const World& world, const Ray& ray, SampleCursor& numbers,
                           Tally* tally = nullptr) const = 0;
};
using IntegratorPtr = std::shared_ptr<const Integrator>;

}  // namespace vug::render
