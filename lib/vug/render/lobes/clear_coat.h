// A clear dielectric face over even diffuse reflection: polished rock, and rock under a film of
// water. What the face reflects, at once and after scattering between its facets, is missing
// below it; the two are coupled so that nothing is lost and both directions count alike (Kelemen
// and Szirmay-Kalos 2001, "A microfacet based coupled specular-matte BRDF model with importance
// sampling", cite kelemen2001coupled).
#pragma once

#include <vug/render/lobes/albedo.h>
#include <vug/render/lobes/lobe.h>

namespace vug::render {

/// A face between air and a clear body, for one viewer.
struct InterfaceLayer {
  const InterfaceTable* table;
  float roughness;
  float mean;         ///< Share of even light that it reflects.
  float clear;        ///< Share of the viewer's light that it lets in.
  float missing_out;  ///< Share that single scattering loses towards the viewer,
  float missing;      ///< and of even light.
  float again;        ///< Part of what is lost that comes back after all.

  InterfaceLayer(float roughness, const InterfaceTable& face, const Vec3f& out);
  /// Share of light from a cosine that goes in below the face.
  float transmittance(float cosine) const;
};

/// What is below the face: rock of a colour as it is seen when dry and polished; `wet` rock is
/// darker, since a film throws its light back upon it (Jensen, Legakis, Dorsey 1999, "Rendering
/// of wet materials", cite jensen1999wet). With `open`, light goes in and on below, and this
/// lobe has the face alone.
class ClearCoatLobe {
 public:
  enum class Base { polished, wet, open };
  ClearCoatLobe(const Rgb& color, Base below, float roughness, const InterfaceTable& face,
                const Vec3f& out);

  Scattering evaluate(const Vec3f& in) const;
  Vec3f sample(float lobe, const Vec2f& u) const;
  Rgb albedo() const { return Rgb(1 - face_.clear) + below_ * face_.clear; }
  /// Share of the viewer's light that goes in; see Below::open.
  float clear() const { return face_.clear; }

 private:
  InterfaceLayer face_;
  Ggx ggx_;
  Rgb below_;
  Vec3f out_;
  float specular_probability_;  ///< Odds of sampling a facet.
};

}  // namespace vug::render
