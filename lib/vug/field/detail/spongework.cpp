// SPDX-License-Identifier: Apache-2.0
// Spongework: irregular pores that slow water dissolves into a porous rock, with sharp edges where
// they meet.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/modifier.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Spongework {
  Field field;
  double size = 0.25;
  double porosity = 0.4;
  double depth = 0.4;
  int seed = 1;

  static void describe(Schema<Spongework>& s) {
    s.doc(
         "Spongework: interconnected round pores in a rock, down to a depth below its surface. "
         "Thin sharp walls remain between them.")
        .cite("palmer1991")
        .param("field", &Spongework::field, {.doc = "the rock", .required = true})
        .param("size", &Spongework::size,
               positive_length("mean distance between pores, 1 cm to 1 m in caves"))
        .param("porosity", &Spongework::porosity,
               {.doc = "share of the rock that is dissolved, down to the depth",
                .dimension = Dimension::ratio,
                .min = 0.05,
                .max = 0.7})
        .param("depth", &Spongework::depth, positive_length("depth of the pores below the surface"))
        .param("seed", &Spongework::seed, {.doc = "random seed; each seed gives other pores"});
  }
};

/// The solid less balls about the sites of a cellular noise.
class Pores {
 public:
  explicit Pores(const Spongework& s)
      : size_(s.size),
        depth_(s.depth),
        radius_(s.size * radius_of(s.porosity)),
        seed_(RandomStream(RandomKey(static_cast<uint64_t>(s.seed)).at("spongework")).bits()) {}

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return range(value);
    } else {
      const T centre = sqrt(nearest_sites(p * T(1 / size_), seed_).first.squared) * T(size_);
      return max(value, min(T(radius_) - centre, value + T(depth_)));
    }
  }
  Traits traits(const Traits& child) const { return carved_traits(child); }
  Interval range(Interval child) const {
    return {child.lo, std::max(child.hi, std::min(radius_, child.hi + depth_))};
  }

  void add_to(Digester& digester) const { digester(size_, depth_, radius_, seed_); }

 private:
  /// Balls about random places, one per unit of volume, leave exp(-v) of it for their volume v.
  /// There is one in each cell, so they overlap less: exp(-v (1 + kEven v)) fits.
  static double radius_of(double porosity) {
    constexpr double kEven = 0.24;
    const double left = -maths::log(1 - porosity);
    const double volume = (std::sqrt(1 + 4 * kEven * left) - 1) / (2 * kEven);
    return maths::pow(3 * volume / (4 * kPi), 1.0 / 3);
  }
  double size_, depth_;
  double radius_;  ///< The radius of a pore in metres.
  uint32_t seed_;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(spongework) {
  return field_kind<Spongework>("spongework", "detail", [](const Spongework& s) {
    return Field(std::make_shared<ModifierNode<Pores>>("spongework", Pores(s), s.field.node()));
  });
}
