// How much light single scattering on microfacets keeps, tabulated when first asked for: what is
// missing is given back as if it were scattered again (Kulla and Conty 2017, "Revisiting
// physically based shading at Imageworks", cite kulla2017compensation). The tables are sums in
// a fixed order, with the same bits on every machine.
#pragma once

#include <vug/render/vectors.h>

#include <array>

namespace vug::render {

/// Values by cosine and roughness, with the means over even light by roughness.
class AlbedoTable {
 public:
  static constexpr size_t kCosines = 32, kRoughnesses = 28;

  float at(float cosine, float roughness) const;
  float mean(float roughness) const;

  std::array<std::array<float, kCosines>, kRoughnesses> values{};
  std::array<float, kRoughnesses> means{};
};

/// Share of light that perfectly reflecting facets scatter once and out.
const AlbedoTable& facet_albedo();

/// What dielectric facets of one index reflect at once.
class InterfaceTable {
 public:
  /// Made once for each index; may be called by several threads.
  static const InterfaceTable& of(float ior);

  float albedo(float cosine, float roughness) const;
  float mean(float roughness) const { return whole_.mean(roughness); }
  float ior() const { return ior_; }
  float mean_fresnel() const { return mean_fresnel_; }

 private:
  explicit InterfaceTable(float ior);
  float ior_, mean_fresnel_;
  AlbedoTable more_;  ///< Beyond the smooth reflectance times facet_albedo(): small and even.
  AlbedoTable whole_;
};

/// The share that dielectric facets neither reflect nor let through at once, from both sides.
struct DielectricTable {
  static const DielectricTable& of(float ior);

  AlbedoTable outside, inside;
};

/// Part of the even light between facets that comes back at last when a facet reflects
/// `mean_reflectance` of it, of facets that scatter `mean_albedo` out at once.
inline float rescattered(float mean_reflectance, float mean_albedo) {
  return mean_reflectance * mean_reflectance * mean_albedo /
         (1 - mean_reflectance * (1 - mean_albedo));
}

}  // namespace vug::render
