// SPDX-License-Identifier: Apache-2.0
// Lobes: the components of surface materials. A lobe is a plain value, built for one viewing
// direction `out` (local, z > 0). It has the functions below, conserves energy where its colours
// are white, and is reciprocal, so that mixtures with fixed weights have both properties, too.
//   Scattering evaluate(const Vec3f& in) const;
//   Vec3f sample(float lobe, const Vec2f& u) const;   z = 0: no sample, and no other lobe may
//                                                     sample that direction
//   Rgb albedo() const;                               approximate reflected fraction
//   bool glossy() const;                              lobes with microfacets only: see Bsdf::glossy
// Radiance that crosses an interface is divided by the square of the index, which makes it
// invariant under refraction.
#pragma once

#include <vug/render/bsdf.h>
#include <vug/render/lobes/microfacet.h>

namespace vug::render {

/// See Bsdf::glossy.
template <class Lobe>
bool is_glossy(const Lobe& lobe) {
  if constexpr (requires { lobe.glossy(); })
    return lobe.glossy();
  else
    return false;
}

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
  bool glossy() const override { return is_glossy(lobe_); }

 private:
  Lobe lobe_;
};

}  // namespace vug::render
