// SPDX-License-Identifier: Apache-2.0
#include <vug/field/lattice.h>
#include <vug/field/lattice_hash.h>

namespace vug::field {
namespace {

template <class S>
using Int = typename Lanes<S>::Int;

// The four diagonals of a cube, and the same rotated by 45 degrees about z; with both signs they
// are 16 unit vectors g with sum g g^T = 16/3 I.
constexpr float kA = 0.57735027f, kB = 0.81649658f;
alignas(32) constexpr float kGradient[3][8] = {{kA, -kA, kA, -kA, kB, -kB, 0, 0},
                                               {kA, kA, -kA, -kA, 0, 0, kB, -kB},
                                               {kA, kA, kA, kA, kA, kA, kA, kA}};

/// 1 / (3 * 0.190944), the standard deviation of the noise before scaling.
constexpr double kScale = 1.7457;

template <class S>
S fade(const S& t) {
  return t * t * t * (t * (t * S(6.0) - S(15.0)) + S(10.0));
}
template <class S>
S fade_slope(const S& t) {
  const S u = t * (t - S(1.0));
  return S(30.0) * u * u;
}

/// The contribution of one corner of a cell: its gradient, and the product with the vector from the
/// corner.
template <class S>
struct Corner {
  S value, x, y, z;
};

template <class S>
Corner<S> corner(const Int<S>& hash, const S& x, const S& y, const S& z) {
  using L = Lanes<S>;
  const Int<S> h = finish_hash<S>(hash);
  const Int<S> index = L::shift_right(h, 29), turn = L::multiply(h, 8);  // Bit 28 is the sign.
  Corner<S> c;
  c.x = L::flip_sign(L::lookup(kGradient[0], index), turn);
  c.y = L::flip_sign(L::lookup(kGradient[1], index), turn);
  c.z = L::flip_sign(L::lookup(kGradient[2], index), turn);
  c.value = c.x * x + c.y * y + c.z * z;
  return c;
}

template <bool kSlope, class S>
Dual<S> noise(const Point<S>& p, uint32_t seed) {
  using L = Lanes<S>;
  const S fx = floor(p.x), fy = floor(p.y), fz = floor(p.z);
  const S x = p.x - fx, y = p.y - fy, z = p.z - fz;
  const Int<S> hx[2] = {L::multiply(L::to_int(fx), kLatticeAxis[0]),
                        L::add(L::multiply(L::to_int(fx), kLatticeAxis[0]), kLatticeAxis[0])};
  const Int<S> y0 = L::bit_xor(L::multiply(L::to_int(fy), kLatticeAxis[1]), seed, 0);
  const Int<S> hy[2] = {
      y0,
      L::bit_xor(L::add(L::multiply(L::to_int(fy), kLatticeAxis[1]), kLatticeAxis[1]), seed, 0)};
  const Int<S> hz[2] = {L::multiply(L::to_int(fz), kLatticeAxis[2]),
                        L::add(L::multiply(L::to_int(fz), kLatticeAxis[2]), kLatticeAxis[2])};
  const S u = fade(x), v = fade(y), w = fade(z);
  const S one(1.0);

  // Along x first: four edges, each with the difference of its ends.
  Corner<S> edge[4];
  S along[4];
  for (int k = 0; k < 4; ++k) {
    const Int<S> rest = L::bit_xor(hy[k & 1], hz[k >> 1]);
    const S dy = k & 1 ? y - one : y, dz = k >> 1 ? z - one : z;
    const Corner<S> a = corner<S>(L::bit_xor(hx[0], rest), x, dy, dz);
    const Corner<S> b = corner<S>(L::bit_xor(hx[1], rest), x - one, dy, dz);
    along[k] = b.value - a.value;
    edge[k].value = a.value + along[k] * u;
    if constexpr (kSlope) {
      edge[k].x = mix(a.x, b.x, u);
      edge[k].y = mix(a.y, b.y, u);
      edge[k].z = mix(a.z, b.z, u);
    }
  }
  const S low = mix(edge[0].value, edge[1].value, v), high = mix(edge[2].value, edge[3].value, v);
  Dual<S> out;
  out.v = mix(low, high, w) * S(kScale);
  if constexpr (kSlope) {
    auto blend = [&](S Corner<S>::*part) {
      return mix(mix(edge[0].*part, edge[1].*part, v), mix(edge[2].*part, edge[3].*part, v), w);
    };
    const S du = mix(mix(along[0], along[1], v), mix(along[2], along[3], v), w);
    const S dv = mix(edge[1].value - edge[0].value, edge[3].value - edge[2].value, w);
    out.dx = (blend(&Corner<S>::x) + fade_slope(x) * du) * S(kScale);
    out.dy = (blend(&Corner<S>::y) + fade_slope(y) * dv) * S(kScale);
    out.dz = (blend(&Corner<S>::z) + fade_slope(z) * (high - low)) * S(kScale);
  }
  return out;
}

template <class S>
S random(const S& cell, uint32_t seed) {
  using L = Lanes<S>;
  return L::to_unit(
      finish_hash<S>(L::bit_xor(L::multiply(L::to_int(cell), kLatticeAxis[0]), seed, 0)));
}

/// Visits the 27 cells around p from the nearest outwards, and skips those that are farther than
/// the second site of every lane.
template <class S>
Sites<S> sites(const Point<S>& p, uint32_t seed) {
  using L = Lanes<S>;
  const Point<S> base{floor(p.x), floor(p.y), floor(p.z)};
  const Int<S> cx = L::to_int(base.x), cy = L::to_int(base.y), cz = L::to_int(base.z);
  const S zero(0.0), far(1e9);
  Sites<S> best{{{zero, zero, zero}, far}, {{zero, zero, zero}, far}};
  const Point<S> local = p - base;
  auto gap = [&](const S& x, int step) {  // Distance to the cells one step along an axis.
    return step == 0 ? zero : square(step > 0 ? S(1.0) - x : x);
  };
  for (int ring = 0; ring <= 3; ++ring)
    for (int k = 0; k < 27; ++k) {
      const int i = k % 3 - 1, j = k / 3 % 3 - 1, l = k / 9 - 1;
      if (i * i + j * j + l * l != ring) continue;
      const S nearest = gap(local.x, i) + gap(local.y, j) + gap(local.z, l);
      if (!any_lane(nearest < best.second.squared)) continue;
      Int<S> h =
          L::bit_xor(L::multiply(L::add(cx, static_cast<uint32_t>(i)), kLatticeAxis[0]), seed, 0);
      h = L::bit_xor(h, L::multiply(L::add(cy, static_cast<uint32_t>(j)), kLatticeAxis[1]));
      h = L::bit_xor(h, L::multiply(L::add(cz, static_cast<uint32_t>(l)), kLatticeAxis[2]));
      const Int<S> hx = finish_hash<S>(h), hy = finish_hash<S>(L::add(hx, 0x9e3779b9)),
                   hz = finish_hash<S>(L::add(hy, 0x9e3779b9));
      auto offset = [](const S& x, int step, const Int<S>& hash) {
        return x - (S(static_cast<double>(step)) + L::to_unit(hash));
      };
      Site<S> site;
      site.offset = {offset(local.x, i, hx), offset(local.y, j, hy), offset(local.z, l, hz)};
      site.squared = dot(site.offset, site.offset);
      auto keep = [](auto closer, const Site<S>& a, const Site<S>& b) {
        return Site<S>{
            {select(closer, a.offset.x, b.offset.x), select(closer, a.offset.y, b.offset.y),
             select(closer, a.offset.z, b.offset.z)},
            select(closer, a.squared, b.squared)};
      };
      const auto wins = site.squared < best.first.squared;
      const Site<S> loser = keep(wins, best.first, site);
      best.first = keep(wins, site, best.first);
      best.second = keep(loser.squared < best.second.squared, loser, best.second);
    }
  return best;
}

}  // namespace

double gradient_noise(const Point<double>& p, uint32_t seed) { return noise<false>(p, seed).v; }
Pack gradient_noise(const Point<Pack>& p, uint32_t seed) { return noise<false>(p, seed).v; }
Dual<double> gradient_noise_slope(const Point<double>& p, uint32_t seed) {
  return noise<true>(p, seed);
}
Dual<Pack> gradient_noise_slope(const Point<Pack>& p, uint32_t seed) {
  return noise<true>(p, seed);
}

double lattice_random(double cell, uint32_t seed) { return random(cell, seed); }
Pack lattice_random(Pack cell, uint32_t seed) { return random(cell, seed); }

Sites<double> nearest_sites(const Point<double>& p, uint32_t seed) { return sites(p, seed); }
Sites<Pack> nearest_sites(const Point<Pack>& p, uint32_t seed) { return sites(p, seed); }

}  // namespace vug::field
