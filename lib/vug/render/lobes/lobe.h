// SPDX-License-Identifier: Apache-2.0
// Lobes: the components of surface materials. A lobe is a plain value, built for one viewing
// direction `out` (local, z > 0). It has the functions below, conserves energy where its colours
// are white, and is reciprocal, so that mixtures with fixed weights have both properties, too.
//   Scattering evaluate(const Vec3f& in) const;
//   Vec3f sample(float lobe, const Vec2f& u) const;   z = 0: no sample, and no other lobe may
//                                                     sample that direction
//   Rgb albedo() const;                               approximate reflected fraction
// Radiance that crosses an interface is divided by the square of the index, which makes it
// invariant under refraction.
#pragma once

#include <vug/render/bsdf.h>
#include <vug/render/lobes/microfacet.h>

namespace vug::render {

/// A Bsdf with a single lobe.
template <class Lobe>
class LobeBsdf final : public Bsdf {
 public:
  explicit LobeBsdf(const Lobe& lobe) : lobe_(lobe) {}

  Scattering evaluate(const Vec3f& in) const override { return lobe_.evaluate(in); }
  BsdfSample sample(float lobe, const Vec2f& u) const override {
    const Vec3f in = lobe_.sample(lobe, u);
    if (in.z == 0) return {};
    const Scattering s = lobe_.evaluate(in);
    if (!(s.pdf > 0)) return {};
    return {in, s.total() * (1 / s.pdf), s.diffuse * (1 / s.pdf), s.pdf};
  }
  Rgb albedo() const override { return lobe_.albedo(); }

 private:
  Lobe lobe_;
};

}  // namespace vug::render
