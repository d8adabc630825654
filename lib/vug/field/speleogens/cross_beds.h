// SPDX-License-Identifier: Apache-2.0
// The geometry of cross-bedding: sets of laminae that dip down the flow and are cut off above.
#pragma once

#include <vug/base/maths.h>
#include <vug/field/bedding.h>

#include <algorithm>
#include <cmath>

namespace vug::field {

struct CrossBedForm {
  double thickness = 0.6;  ///< Mean thickness of a set, metres.
  double lamina = 0.04;    ///< Mean thickness of a lamina, metres.
  Vec3d flow{1, 0, 0};     ///< Not along the normal.
  Vec3d normal{0, 1, 0};   ///< Any length but 0.
  double steep = 0.59;     ///< Dips of laminae at the top of a set are between these, radians.
  double gentle = 0.35;
  double spread = 0.44;  ///< Largest angle between the dip of a set and the flow, radians.
};

/// The set and the lamina at a point.
template <class T>
struct CrossBed {
  Bed<T> lamina;  ///< In mean thicknesses of a lamina.
  T lamina_random, set_random;
  T from_base;  ///< Distance from the nearer boundary of the set in its mean thickness.
};

class CrossBeds {
 public:
  static constexpr double kParting = 0.04;  ///< Width of a parting in thicknesses of a set.

  CrossBeds(const CrossBedForm& form, uint32_t seed) : form_(form), seed_(seed) {
    up_ = form.normal.normalized();
    along_ = (form.flow - up_ * form.flow.dot(up_)).normalized();
    across_ = up_.cross(along_);
  }

  /// Laminae are the surfaces of constant `down`: at the top of a set they fall by tan(dip) down
  /// the flow, at its base by a quarter of that, as the foresets of a dune do.
  template <class T>
  CrossBed<T> at(const Point<T>& p) const {
    const Bed<T> set = bed_at(dot(p, constant<T>(up_)) * T(1 / form_.thickness), seed_);
    const T tangent = T(low_tangent()) + lattice_random(set.index, seed_ ^ 0x3c6ef372u) *
                                             T(high_tangent() - low_tangent());
    const T turn =
        (lattice_random(set.index, seed_ ^ 0x1b873593u) * T(2.0) - T(1.0)) * T(form_.spread);
    const T along =
        dot(p, constant<T>(along_)) * cos(turn) + dot(p, constant<T>(across_)) * sin(turn);
    const T thick = set.below + set.above;
    const T high = set.below / thick;
    // t + 1 - (1 - t)^3: a run of 1 per rise at the top, of 4 at the base.
    const T low = T(1.0) - high;
    const T run = (high + T(1.0) - low * low * low) * thick * T(form_.thickness);
    // Along the normal of the laminae at the top of the set.
    const T down = (along * tangent + run) / sqrt(T(1.0) + square(tangent));
    CrossBed<T> out;
    const T shift = floor(lattice_random(set.index, seed_ ^ 0x7f4a7c15u) * T(256.0));
    out.lamina = bed_at(down * T(1 / form_.lamina) + shift, seed_ ^ 0x68bc21ebu);
    out.lamina_random = lattice_random(out.lamina.index, seed_ ^ 0x2545f491u);
    out.set_random = lattice_random(set.index, seed_ ^ 0x51ed270bu);
    out.from_base = min(set.below, set.above);
    return out;
  }
  /// The maximum slope of the lamina's coordinate, per metre.
  double lamina_slope() const {
    const double t = high_tangent();
    return std::sqrt(t * t + 16) / std::sqrt(1 + low_tangent() * low_tangent()) / form_.lamina;
  }
  /// The slope of from_base, per metre.
  double base_slope() const { return 1 / form_.thickness; }

 private:
  double low_tangent() const { return maths::tan(form_.gentle); }
  double high_tangent() const { return maths::tan(form_.steep); }

  CrossBedForm form_;
  Vec3d up_, along_, across_;
  uint32_t seed_;
};

}  // namespace vug::field
