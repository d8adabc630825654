// Lobes: the parts that surfaces are mixed of. Each is a plain value, made for one viewer `out`
// (local, z > 0), has the functions below, keeps all energy where its colours are white, and is
// reciprocal, so that any mix with fixed weights is and does, too.
//   Scattering evaluate(const Vec3f& in) const;
//   Vec3f sample(float lobe, const Vec2f& u) const;   z = 0: nothing was sampled, and what would
//                                                     have been may not be found by other lobes
//   Rgb albedo() const;                               share of light that comes back, about
// Light that passes a face between media of different index is counted as radiance over the
// square of the index, which refraction leaves unchanged.
#pragma once

#include <vug/render/bsdf.h>
#include <vug/render/lobes/microfacet.h>

namespace vug::render {

/// A Bsdf of one lobe.
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
