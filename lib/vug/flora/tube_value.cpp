// SPDX-License-Identifier: Apache-2.0
// Value of a tube and its gradient by the chain rule through coordinates().
#include <vug/flora/tube.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

/// Derivative of an interpolated frame between two cross-sections with respect to the fraction u:
/// the differential of Frame::orthonormalized.
struct FrameSlope {
  Vec3d normal, binormal;
};
FrameSlope frame_slope(const Frame& a, const Frame& b, double u, const Frame& at) {
  const Vec3d tangent = a.tangent * (1 - u) + b.tangent * u, ahead = b.tangent - a.tangent;
  const Vec3d normal = a.normal * (1 - u) + b.normal * u, turned = b.normal - a.normal;
  const Vec3d &t = at.tangent, &n = at.normal;
  const Vec3d dt = (ahead - t * t.dot(ahead)) / tangent.length();
  const double lean = t.dot(normal);
  const Vec3d flat = normal - t * lean;
  const Vec3d dflat = turned - dt * lean - t * (dt.dot(normal) + t.dot(turned));
  const Vec3d dn = (dflat - n * n.dot(dflat)) / flat.length();
  return {dn, dt.cross(n) + t.cross(dn)};
}

}  // namespace

double Tube::value(const Coordinates& coords) const {
  const double smooth = radius(coords.along),
               full = smooth + displacement_.rings(coords.along).height;
  const double in =
      std::clamp((coords.radial / smooth - kGroovesFrom) / (kGroovesTo - kGroovesFrom), 0.0, 1.0);
  const double groove = in > 0 ? in * displacement_.grooves(coords.along, coords.angle).height : 0;
  double value =
      std::max({coords.radial - full + groove, start() - coords.along, coords.along - end()});
  if (chambers_.empty()) return value;
  const auto next = std::upper_bound(chambers_.begin(), chambers_.end(), coords.along,
                                     [](double s, const Chamber& c) { return s < c.from; });
  const double inner = coords.radial - hollow_of(smooth).height;
  const auto carve = [&](const Chamber& c) {
    value = std::max(value, -std::max({inner, c.from - coords.along, coords.along - c.to}));
  };
  if (next != chambers_.end()) carve(*next);
  if (next != chambers_.begin()) carve(*(next - 1));
  return value;
}

Tube::CoordinateGradients Tube::coordinate_gradients(const Vec3d& p,
                                                     const Coordinates& coords) const {
  const Ring &a = rings_[coords.segment], &b = rings_[coords.segment + 1];
  const double before = (p - a.center).dot(a.frame.tangent);
  const double after = (b.center - p).dot(b.frame.tangent);
  const Ring ring = at(coords.along);
  const Frame& f = ring.frame;
  CoordinateGradients out;
  Vec3d x = f.normal, y = f.binormal, off = p - ring.center;
  if (coords.along < start() || coords.along > end() || !(before + after > 0)) {
    off -= f.tangent * off.dot(f.tangent);
    out.along = f.tangent;
  } else {
    // u is the fraction between both planes; the middle line moves with it.
    const double u = before / (before + after), whole = b.along - a.along;
    const Vec3d chord = b.center - a.center, ahead = chord.normalized();
    const double from = ahead.dot(a.frame.tangent), to = ahead.dot(b.frame.tangent);
    const double mixed = (1 - u) * from + u * to;
    const Vec3d center = chord * (from * to / (mixed * mixed));
    const FrameSlope turn = frame_slope(a.frame, b.frame, u, f);
    // Clamped between the planes: no movement along the axis.
    const Vec3d du = before < 0 || after < 0
                         ? Vec3d(0)
                         : (a.frame.tangent * after + b.frame.tangent * before) /
                               ((before + after) * (before + after));
    out.along = du * whole;
    x += du * (off.dot(turn.normal) - center.dot(f.normal));
    y += du * (off.dot(turn.binormal) - center.dot(f.binormal));
  }
  const double cosine = off.dot(f.normal), sine = off.dot(f.binormal);
  if (!(coords.radial > 0)) {
    out.radial = x, out.angle = Vec3d(0);
    return out;
  }
  out.radial = (x * cosine + y * sine) / coords.radial;
  out.angle = (y * cosine - x * sine) / (coords.radial * coords.radial);
  return out;
}

field::Gradient Tube::radial_value(const Coordinates& coords, const CoordinateGradients& d) const {
  const double smooth = radius(coords.along), slim = taper(coords.along);
  const DisplacementSample rings = displacement_.rings(coords.along);
  field::Gradient out{coords.radial - (smooth + rings.height),
                      d.radial - d.along * (slim + rings.along)};
  const double share = coords.radial / smooth, span = kGroovesTo - kGroovesFrom;
  const double in = std::clamp((share - kGroovesFrom) / span, 0.0, 1.0);
  if (!(in > 0)) return out;
  const DisplacementSample groove = displacement_.grooves(coords.along, coords.angle);
  out.value += in * groove.height;
  out.gradient += (d.along * groove.along + d.angle * groove.around) * in;
  if (in < 1)
    out.gradient += (d.radial - d.along * (share * slim)) * (groove.height / (smooth * span));
  return out;
}

field::Gradient Tube::gradient(const Vec3d& p, const Coordinates& coords) const {
  const CoordinateGradients d = coordinate_gradients(p, coords);
  const auto higher = [](const field::Gradient& a, double value, const Vec3d& gradient) {
    return value > a.value ? field::Gradient{value, gradient} : a;
  };
  field::Gradient out = radial_value(coords, d);
  out = higher(out, start() - coords.along, -d.along);
  out = higher(out, coords.along - end(), d.along);
  if (chambers_.empty()) return out;
  const auto next = std::upper_bound(chambers_.begin(), chambers_.end(), coords.along,
                                     [](double s, const Chamber& c) { return s < c.from; });
  const auto carve = [&](const Chamber& c) {
    const DisplacementSample inner = hollow_of(radius(coords.along));
    field::Gradient hollow{coords.radial - inner.height,
                           d.radial - d.along * (taper(coords.along) * inner.along)};
    hollow = higher(hollow, c.from - coords.along, -d.along);
    hollow = higher(hollow, coords.along - c.to, d.along);
    out = higher(out, -hollow.value, -hollow.gradient);
  };
  if (next != chambers_.end()) carve(*next);
  if (next != chambers_.begin()) carve(*(next - 1));
  return out;
}

}  // namespace vug::flora
