// SPDX-License-Identifier: Apache-2.0
// Random values on the integer lattice and gradient noise between them, over doubles and packs.
// Everything is a hash of (cell, seed): no tables, no state, the same on every machine.
#pragma once

#include <vug/field/point.h>

#include <cstdint>

namespace vug::field {

/// Perlin's gradient noise (perlin1985, perlin2002) with 16 unit gradients whose second moment is
/// isotropic, and a quintic fade. Cells have side 1; |coordinate| < 1e9. Scaled so that its
/// standard deviation is 1/3.
double gradient_noise(const Point<double>& p, uint32_t seed);
Pack gradient_noise(const Point<Pack>& p, uint32_t seed);
/// With the derivatives along the coordinates of p.
Dual<double> gradient_noise_slope(const Point<double>& p, uint32_t seed);
Dual<Pack> gradient_noise_slope(const Point<Pack>& p, uint32_t seed);

/// The maximum of |value|, at the centre of a cell: sqrt(3)/2 before scaling.
inline constexpr double kGradientNoiseBound = 1.512;
/// The maximum slope: 2.691 before scaling, over all positions in a cell, directions and choices of
/// gradients.
inline constexpr double kGradientNoiseSlope = 4.75;

/// Applies the chain rule for a point that is itself differentiated.
template <class S>
Dual<S> gradient_noise(const Point<Dual<S>>& p, uint32_t seed) {
  const Dual<S> n = gradient_noise_slope(Point<S>{p.x.v, p.y.v, p.z.v}, seed);
  return {n.v, n.dx * p.x.dx + n.dy * p.y.dx + n.dz * p.z.dx,
          n.dx * p.x.dy + n.dy * p.y.dy + n.dz * p.z.dy,
          n.dx * p.x.dz + n.dy * p.y.dz + n.dz * p.z.dz};
}

/// Uniform in [0, 1): a hash of the integer `cell` and the seed.
double lattice_random(double cell, uint32_t seed);
Pack lattice_random(Pack cell, uint32_t seed);
template <class S>
Dual<S> lattice_random(const Dual<S>& cell, uint32_t seed) {
  return {lattice_random(cell.v, seed), S(0.0), S(0.0), S(0.0)};
}

/// A feature point of cellular noise: the vector from it to p, and the squared length of the
/// vector.
template <class S>
struct Site {
  Point<S> offset;
  S squared;
};

/// The two nearest feature points of p, with one random point per cell (worley1996); cells have
/// side 1.
template <class S>
struct Sites {
  Site<S> first, second;
};
Sites<double> nearest_sites(const Point<double>& p, uint32_t seed);
Sites<Pack> nearest_sites(const Point<Pack>& p, uint32_t seed);
/// The feature points do not depend on p.
template <class S>
Sites<Dual<S>> nearest_sites(const Point<Dual<S>>& p, uint32_t seed) {
  const Sites<S> plain = nearest_sites(Point<S>{p.x.v, p.y.v, p.z.v}, seed);
  auto lifted = [&](const Site<S>& site) {
    auto moving = [](const S& v, const Dual<S>& c) { return Dual<S>(v, c.dx, c.dy, c.dz); };
    const Point<Dual<S>> offset{moving(site.offset.x, p.x), moving(site.offset.y, p.y),
                                moving(site.offset.z, p.z)};
    return Site<Dual<S>>{offset, dot(offset, offset)};
  };
  return {lifted(plain.first), lifted(plain.second)};
}

}  // namespace vug::field
