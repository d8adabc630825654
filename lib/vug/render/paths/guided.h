// SPDX-License-Identifier: Apache-2.0
// A BSDF combined with path guiding.
#pragma once

#include <vug/render/bsdf.h>
#include <vug/render/guiding/cone_mixture.h>

#include <algorithm>

namespace vug::render {

/// One-sample mixture of the Bsdf's density and the guide's (Mueller, Gross, Novak 2017, "Practical
/// path guiding for efficient light-transport simulation", section 3.5, mueller2017guiding); only
/// the Bsdf where the guide is empty. The guide replaces samples of light that is reflected or
/// transmitted here; those of light that leaves elsewhere (BsdfSample::subsurface) keep their
/// fraction, because the guide does not know where it leaves.
class GuidedBsdf {
 public:
  GuidedBsdf(const Bsdf& bsdf, const Frame& frame, const ConeMixture& guide)
      : bsdf_(bsdf),
        frame_(frame),
        guide_(guide),
        share_(bsdf.guided_fraction() * guide.mixture_weight()) {
    if (share_ > 0) here_ = 1 - bsdf.subsurface_fraction();
  }

  /// `direction` is in world space, `in` is the same in the local frame.
  Scattering evaluate(const Vec3f& in, const Vec3f& direction) const {
    Scattering s = bsdf_.evaluate(in);
    if (share_ > 0) s.pdf = mixed_pdf(s.pdf, direction);
    return s;
  }

  /// See Bsdf::glossy.
  bool glossy() const { return bsdf_.glossy(); }

  struct Sample {
    BsdfSample scattered;      ///< Local direction; weight with respect to the mixture's density.
    Vec3f direction{0, 0, 0};  ///< World space.
    Rgb unguided{0, 0, 0};     ///< Weight as if only the Bsdf had been sampled.
  };
  Sample sample(float lobe, const Vec2f& u) const {
    if (!(share_ > 0) || lobe >= here_) return unguided(lobe, u);
    Sample out;
    Vec3f in;
    const Bsdf* body = nullptr;
    if (lobe < share_) {
      out.direction = guide_.sample(u);
      in = frame_.to_local(out.direction);
    } else {
      const float rest = (lobe - share_) / (here_ - share_) * here_;
      const BsdfSample own = bsdf_.sample(std::min(rest, 0x1.fffffep-1f), u);
      if (!(own.pdf > 0) || own.subsurface) return out;  // the latter by rounding only
      in = own.direction;
      body = own.body;
      out.direction = frame_.to_world(in);
    }
    const Scattering s = bsdf_.evaluate(in);
    const float pdf = mixed_pdf(s.pdf, out.direction);
    const Rgb f = s.total();
    if (!(s.pdf > 0 && pdf > 0) || is_black(f)) return out;
    out.scattered = {in, f * (1 / pdf), s.diffuse * (1 / pdf), pdf, body};
    // Unbounded where the Bsdf itself would hardly sample this direction.
    out.unguided = f * (1 / std::fmax(s.pdf, largest(f)));
    return out;
  }

 private:
  Sample unguided(float lobe, const Vec2f& u) const {
    const BsdfSample own = bsdf_.sample(lobe, u);
    return {own, frame_.to_world(own.direction), own.weight};
  }
  /// The density of `sample`, where that of the Bsdf is `own`.
  float mixed_pdf(float own, const Vec3f& direction) const {
    return own + share_ * (guide_.pdf(direction) - own / here_);
  }

  const Bsdf& bsdf_;
  const Frame& frame_;
  const ConeMixture& guide_;
  float share_;     ///< Fraction of the samples that the guide takes.
  float here_ = 1;  ///< Fraction of the samples that do not continue below the surface.
};

}  // namespace vug::render
