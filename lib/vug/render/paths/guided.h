// SPDX-License-Identifier: Apache-2.0
// A BSDF combined with path guiding.
#pragma once

#include <vug/render/bsdf.h>
#include <vug/render/guiding/cone_mixture.h>

namespace vug::render {

/// One-sample mixture of the Bsdf's density and the guide's (Mueller, Gross, Novak 2017, "Practical
/// path guiding for efficient light-transport simulation", section 3.5, mueller2017guiding); only
/// the Bsdf where the guide is empty.
class GuidedBsdf {
 public:
  GuidedBsdf(const Bsdf& bsdf, const Frame& frame, const ConeMixture& guide)
      : bsdf_(bsdf),
        frame_(frame),
        guide_(guide),
        share_(bsdf.guided_fraction() * guide.mixture_weight()) {}

  /// `direction` is in world space, `in` is the same in the local frame.
  Scattering evaluate(const Vec3f& in, const Vec3f& direction) const {
    Scattering s = bsdf_.evaluate(in);
    if (share_ > 0) s.pdf += share_ * (guide_.pdf(direction) - s.pdf);
    return s;
  }

  struct Sample {
    BsdfSample scattered;   ///< Local direction; weight with respect to the mixture's density.
    Vec3f direction;        ///< World space.
    Rgb unguided{0, 0, 0};  ///< Weight as if only the Bsdf had been sampled.
  };
  Sample sample(float lobe, const Vec2f& u) const {
    Sample out;
    if (!(share_ > 0)) {
      out.scattered = bsdf_.sample(lobe, u);
      out.direction = frame_.to_world(out.scattered.direction);
      out.unguided = out.scattered.weight;
      return out;
    }
    Vec3f in;
    const Bsdf* body = nullptr;
    if (lobe < share_) {
      out.direction = guide_.sample(u);
      in = frame_.to_local(out.direction);
    } else {
      const BsdfSample own = bsdf_.sample((lobe - share_) / (1 - share_), u);
      if (!(own.pdf > 0)) return out;
      in = own.direction;
      body = own.body;
      out.direction = frame_.to_world(in);
    }
    const Scattering s = bsdf_.evaluate(in);
    const float pdf = s.pdf + share_ * (guide_.pdf(out.direction) - s.pdf);
    const Rgb f = s.total();
    if (!(s.pdf > 0 && pdf > 0) || is_black(f)) return out;
    out.scattered = {in, f * (1 / pdf), s.diffuse * (1 / pdf), pdf, body};
    // Unbounded where the Bsdf itself would hardly sample this direction.
    out.unguided = f * (1 / std::fmax(s.pdf, largest(f)));
    return out;
  }

 private:
  const Bsdf& bsdf_;
  const Frame& frame_;
  const ConeMixture& guide_;
  float share_;
};

}  // namespace vug::render
