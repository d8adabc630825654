// SPDX-License-Identifier: Apache-2.0
// A clear dielectric interface over a diffuse base: polished rock, and rock under a film of water.
// The light that the interface reflects, in single and multiple scattering, is missing from the
// base; both are coupled such that the lobe conserves energy and is reciprocal (Kelemen and
// Szirmay-Kalos 2001, "A microfacet based coupled specular-matte BRDF model with importance
// sampling", cite kelemen2001coupled).
#pragma once

#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/lobe.h>

namespace vug::render {

/// An interface between air and a clear body, for one viewing direction.
struct InterfaceLayer {
  const InterfaceTable* table;
  float roughness;
  float mean;         ///< Reflected fraction of diffuse light.
  float transmitted;  ///< Fraction of the viewer's light that is transmitted.
  float missing_out;  ///< Fraction of the viewer's light missing from single scattering.
  float missing;      ///< The same for diffuse light.
  float multiple;     ///< Fraction of the missing light that multiple scattering returns.

  InterfaceLayer(float roughness, const InterfaceTable& face, const Vec3f& out);
  /// Transmitted fraction of light from a cosine.
  float transmittance(float cosine) const;
};

/// The base under the interface. `polished`: rock with the colour that it has when dry and
/// polished. `wet`: darker rock, since the film reflects the base's light back to it (Jensen,
/// Legakis, Dorsey 1999, "Rendering of wet materials", cite jensen1999wet). `open`: light continues
/// into the body, and this lobe is the interface alone.
class ClearCoatLobe {
 public:
  enum class Base { polished, wet, open };
  ClearCoatLobe(const Rgb& color, Base below, float roughness, const InterfaceTable& face,
                const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1 - face_.transmitted) + below_ * face_.transmitted; }
  /// Transmitted fraction of the viewer's light; see Base::open.
  float transmitted() const { return face_.transmitted; }
  bool glossy() const { return ggx_.glossy(); }

 private:
  InterfaceLayer face_;
  Ggx ggx_;
  Rgb below_;
  Vec3f out_;
  float specular_probability_;  ///< Probability of sampling the interface.
};

}  // namespace vug::render
