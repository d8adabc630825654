// SPDX-License-Identifier: Apache-2.0
// The look of a surface in terms of other programs: a base with metallic-roughness shading, a
// dielectric interface and a coat of water. Fractions are 0 to 1, colours linear Rec.709.
#pragma once

#include <vug/base/vec.h>

#include <string>

namespace vug::exchange {

struct Look {
  Vec3d base_color{0.5, 0.5, 0.5};  ///< Albedo of the base.
  double roughness = 1;  ///< Its square is the width of the microfacet slope distribution.
  double specular = 0;   ///< Fraction with a dielectric interface; the rest is matte.
  double ior = 1.5;      ///< Index of refraction of the interface and of transmissive bodies.
  double metallic = 0;
  double transmission = 0;  ///< Fraction that transmits light specularly.
  Vec3d through{0, 0, 0};   ///< Fraction of the light that a thin body transmits diffusely.
  double subsurface = 0;    ///< Fraction with subsurface scattering.
  double wetness = 0;       ///< Fraction covered by a film of water.
  double coat_roughness = 0.1;
  double opacity = 1;       ///< Fraction that is present; the rest is invisible.
  Vec3d emission{0, 0, 0};  ///< Radiance emitted by the outside, W/sr/m^2.
  bool thin = false;        ///< A thin sheet without interior.

  bool operator==(const Look&) const = default;
};

/// The look of the triangles of one rock material of a mesh.
struct RockLook {
  std::string rock;
  Look look;

  bool operator==(const RockLook&) const = default;
};

/// Interpolates between two looks, with weight `share` for the second.
Look blend(const Look& a, const Look& b, double share);

}  // namespace vug::exchange
