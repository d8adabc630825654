// Directional albedo of single scattering on microfacets, tabulated on first use. The missing
// energy is returned as multiple scattering (Kulla and Conty 2017, "Revisiting physically based
// shading at Imageworks", cite kulla2017compensation). The tables are sums in a fixed order, with
// the same bits on every machine.
#pragma once

#include <vug/render/vectors.h>

#include <array>

namespace vug::render {

/// Values by cosine and roughness, with cosine-weighted means by roughness.
class AlbedoTable {
 public:
  static constexpr size_t kCosines = 32, kRoughnesses = 28;

  float at(float cosine, float roughness) const;
  float mean(float roughness) const;

  std::array<std::array<float, kCosines>, kRoughnesses> values{};
  std::array<float, kRoughnesses> means{};
};

/// Directional albedo of single scattering for perfectly reflecting facets.
const AlbedoTable& facet_albedo();

/// Single-scattering reflection of a rough dielectric interface of one index.
class InterfaceTable {
 public:
  /// Built once for each index; thread-safe.
  static const InterfaceTable& of(float ior);

  float albedo(float cosine, float roughness) const;
  float mean(float roughness) const { return whole_.mean(roughness); }
  float ior() const { return ior_; }
  float mean_fresnel() const { return mean_fresnel_; }

 private:
  explicit InterfaceTable(float ior);
  float ior_, mean_fresnel_;
  AlbedoTable
      more_;  ///< Excess over the smooth reflectance times facet_albedo(): small and smooth.
  AlbedoTable whole_;
};

/// Fraction of light that a rough dielectric interface neither reflects nor transmits in single
/// scattering, from both sides.
struct DielectricTable {
  static const DielectricTable& of(float ior);

  AlbedoTable outside, inside;
};

/// Albedo of multiple scattering: the fraction of diffuse light between facets that finally leaves,
/// if a facet reflects `mean_reflectance` and a fraction `mean_albedo` leaves in each scattering.
inline float rescattered(float mean_reflectance, float mean_albedo) {
  return mean_reflectance * mean_reflectance * mean_albedo /
         (1 - mean_reflectance * (1 - mean_albedo));
}

}  // namespace vug::render
