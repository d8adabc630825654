// Microfacets with the GGX distribution of slopes (Walter et al. 2007, cite walter2007ggx), masked
// as heights are correlated (Heitz 2014, cite heitz2014masking) and sampled by the normals that
// the viewer sees (Dupuy and Benyoub 2023, cite dupuy2023caps). Directions are local, `out` has z >
// 0.
#pragma once

#include <vug/render/sampling.h>

namespace vug::render {

/// Reflectance of an unpolarised dielectric face at a cosine in 0..1; `ior`: the index of the far
/// side over that of the near side.
inline float fresnel(float cosine, float ior) {
  const float c = std::clamp(cosine, 0.0f, 1.0f);
  const float gg = ior * ior - 1 + c * c;
  if (!(gg > 0)) return 1;  // total reflection
  const float g = std::sqrt(gg);
  const float a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return std::min(1.0f, 0.5f * a * a * (1 + b * b));
}

/// The smallest roughness that single precision bears; smoother faces are this rough.
inline constexpr float kMinRoughness = 0.03f;

struct Ggx {
  float a2;  ///< Square of the width of the slopes.
  float a;

  /// Roughness is the square root of the width.
  explicit Ggx(float roughness) {
    const float r = std::clamp(roughness, kMinRoughness, 1.0f);
    a = r * r, a2 = a * a;
  }
  /// Density of facet normals.
  float density(const Vec3f& h) const {
    const float d = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return 1 / (kPif * a2 * d * d);
  }
  float root(const Vec3f& v) const { return std::sqrt(a2 * (v.x * v.x + v.y * v.y) + v.z * v.z); }

  /// A facet's normal with density `seen`.
  Vec3f sample(const Vec3f& out, const Vec2f& u) const {
    const Vec3f stretched = normalized(Vec3f(a * out.x, a * out.y, out.z));
    const Vec3f cap = direction_at((1 - u.x) * (1 + stretched.z) - stretched.z, u.y) + stretched;
    return normalized(Vec3f(a * cap.x, a * cap.y, std::max(cap.z, 1e-9f)));
  }
  /// Density of `sample`, over the solid angle of normals.
  float visible_density(const Vec3f& out, const Vec3f& h) const {
    return density(h) * std::max(0.0f, 2 * dot(out, h)) / (out.z + root(out));
  }
  /// What neither masks nor shadows of what the viewer's masking leaves: the weight of a sample
  /// towards `in`, on either side.
  float g2_over_g1(const Vec3f& out, const Vec3f& in) const {
    const float z = std::fabs(in.z), from = root(out);
    return z * (out.z + from) / (z * from + out.z * root(in));
  }

  /// Directions of what facets scatter among themselves: even light on rough faces, and towards
  /// grazing angles on smooth ones, which lose light there only.
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
