// SPDX-License-Identifier: Apache-2.0
// GGX microfacets (Walter et al. 2007, cite walter2007ggx) with height-correlated masking (Heitz
// 2014, cite heitz2014masking), sampled by visible normals (Dupuy and Benyoub 2023, cite
// dupuy2023caps). Directions are local, `out` has z > 0.
#pragma once

#include <vug/render/sampling.h>

namespace vug::render {

/// Unpolarised Fresnel reflectance of a dielectric interface at a cosine in 0..1; `ior` is the
/// index of the far side over that of the near side.
inline float fresnel(float cosine, float ior) {
  const float c = std::clamp(cosine, 0.0f, 1.0f);
  const float gg = ior * ior - 1 + c * c;
  if (!(gg > 0)) return 1;  // total reflection
  const float g = std::sqrt(gg);
  const float a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return std::min(1.0f, 0.5f * a * a * (1 + b * b));
}

/// Smallest roughness that single precision allows; smoother surfaces are clamped to it.
inline constexpr float kMinRoughness = 0.03f;

/// The roughness of an interface whose normals also vary by slopes of that variance per axis: the
/// squared widths of both slope distributions add up (Olano and Baker 2010, cite olano2010lean),
/// up to the limit of Kaplanyan et al. 2016 (cite kaplanyan2016filtering).
inline float filtered_roughness(float roughness, float slope_variance) {
  constexpr float kMost = 0.18f;
  if (!(slope_variance > 0)) return roughness;
  const float width = roughness * roughness;
  return std::sqrt(std::sqrt(width * width + std::min(2 * slope_variance, kMost)));
}

/// Interfaces of a lower roughness are glossy: see Bsdf::glossy.
inline constexpr float kGlossyRoughness = 0.3f;

struct Ggx {
  float a2;  ///< Square of the slope width.
  float a;

  /// Roughness is the square root of the slope width.
  explicit Ggx(float roughness) {
    const float r = std::clamp(roughness, kMinRoughness, 1.0f);
    a = r * r, a2 = a * a;
  }
  /// Whether reflections of small lights are highlights rather than a gradient.
  bool glossy() const { return a < kGlossyRoughness * kGlossyRoughness; }
  /// Distribution of normals D.
  float density(const Vec3f& h) const {
    const float d = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return 1 / (kPif * a2 * d * d);
  }
  float root(const Vec3f& v) const { return std::sqrt(a2 * (v.x * v.x + v.y * v.y) + v.z * v.z); }

  /// Samples a normal with density `visible_density`.
  Vec3f sample(const Vec3f& out, const Vec2f& u) const {
    const Vec3f stretched = normalized(Vec3f(a * out.x, a * out.y, out.z));
    const Vec3f cap = direction_at((1 - u.x) * (1 + stretched.z) - stretched.z, u.y) + stretched;
    return normalized(Vec3f(a * cap.x, a * cap.y, std::max(cap.z, 1e-9f)));
  }
  /// Density of `sample` over the solid angle of normals: the distribution of visible normals.
  float visible_density(const Vec3f& out, const Vec3f& h) const {
    return density(h) * std::max(0.0f, 2 * dot(out, h)) / (out.z + root(out));
  }
  /// G2 / G1, the weight of a sample towards `in` on either side: the fraction that is not
  /// shadowed, given that it is not masked.
  float g2_over_g1(const Vec3f& out, const Vec3f& in) const {
    const float z = std::fabs(in.z), from = root(out);
    return z * (out.z + from) / (z * from + out.z * root(in));
  }

  /// Samples a direction of multiple scattering: diffuse on rough surfaces, and towards grazing
  /// angles on smooth ones, which lose energy only there.
  Vec3f sample_multiple(const Vec2f& u) const {
    const float even = std::sqrt(a);
    if (!(u.x < even)) return direction_at((u.x - even) / (1 - even), u.y);
    return sample_cosine_hemisphere({std::min(u.x / even, 0x1.fffffep-1f), u.y});
  }
  float pdf_multiple(float cosine) const {
    const float even = std::sqrt(a);
    return even * cosine / kPif + (1 - even) / (2 * kPif);
  }
};

}  // namespace vug::render
