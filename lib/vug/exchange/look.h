// What a surface looks like, in terms that other programs know: a body with metallic-roughness
// shading, a clear face, a coat of water. Shares are 0 to 1, colours linear Rec.709.
#pragma once

#include <vug/base/vec.h>

namespace vug::exchange {

struct Look {
  Vec3d base_color{0.5, 0.5, 0.5};  ///< Share of the light that the body reflects.
  double roughness = 1;             ///< Its square is the width of the slopes of microfacets.
  double specular = 0;              ///< Share that has a clear face; the rest is matte.
  double ior = 1.5;                 ///< Of that face, and of what is clear.
  double metallic = 0;
  double transmission = 0;  ///< Share that is clear.
  Vec3d through{0, 0, 0};  ///< Share of the light that a thin body lets out at its back, scattered.
  double subsurface = 0;   ///< Share in whose body light wanders.
  double wetness = 0;      ///< Share that a film of water covers.
  double coat_roughness = 0.1;
  double opacity = 1;  ///< Share that is there at all; through the rest one looks as if into air.
  Vec3d emission{0, 0, 0};  ///< Radiance that the outside sends out, W/sr/m^2.
  bool thin = false;        ///< A sheet without a body.

  bool operator==(const Look&) const = default;
};

/// In between two looks: `share` of the second.
Look blend(const Look& a, const Look& b, double share);

}  // namespace vug::exchange
