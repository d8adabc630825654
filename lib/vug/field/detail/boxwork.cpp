// SPDX-License-Identifier: Apache-2.0
// Boxwork: veins of calcite along the joints of a rock stay when the rock between them weathers,
// and protrude as thin blades that form boxes.
#include <vug/base/rng.h>
#include <vug/field/bedding.h>
#include <vug/field/modifier.h>

#include <algorithm>
#include <array>
#include <vector>

namespace vug::field {
namespace {

struct Boxwork {
  Field field;
  std::vector<Vec3d> normals{{1, 0.15, 0.1}, {-0.2, 1, 0.25}, {0.1, -0.2, 1}};
  double spacing = 0.08;
  double thickness = 0.004;
  double height = 0.06;
  double ragged = 0.6;
  double wander = 0.25;
  int seed = 1;

  static void describe(Schema<Boxwork>& s) {
    s.doc(
         "Boxwork: thin veins on sets of joints, which protrude from a rock whose surface "
         "weathered back between them.")
        .cite("hill1997")
        .param("field", &Boxwork::field, {.doc = "the rock", .required = true})
        .param("normals", &Boxwork::normals,
               {.doc = "perpendiculars to the sets of joints, of any length but 0"})
        .param("spacing", &Boxwork::spacing,
               positive_length("mean distance between the veins of a set, 2 to 20 cm in caves"))
        .param("thickness", &Boxwork::thickness,
               positive_length("thickness of a vein, 2 to 10 mm in caves; at least two voxels in a "
                               "level set"))
        .param("height", &Boxwork::height,
               positive_length("mean height of the veins above the rock, 1 to 30 cm in caves"))
        .param("ragged", &Boxwork::ragged,
               {.doc = "variation of the height; 0 is even",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("wander", &Boxwork::wander,
               {.doc = "deviation of the veins from planes over their spacing",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 0.5})
        .param("seed", &Boxwork::seed, {.doc = "random seed; each seed gives different veins"});
  }
  std::string fault() const {
    if (normals.empty() || normals.size() > 6) return "boxwork needs one to six sets of joints";
    for (const Vec3d& n : normals)
      if (!(n.length2() > 0)) return "the normal of a set of joints must not be zero";
    return thickness < kThinnestBed * spacing
               ? ""
               : "the thickness of veins must be below a fifth of their spacing";
  }
};

/// The union of a solid and the veins near it. Every value is divided by its slope.
class Veins {
 public:
  explicit Veins(const Boxwork& b)
      : half_(0.5 * b.thickness), height_(b.height), ragged_(b.ragged), wave_(0.5 / b.spacing) {
    RandomStream random(RandomKey(static_cast<uint64_t>(b.seed)).at("boxwork"));
    for (const Vec3d& n : b.normals)
      sets_.push_back(
          {n.normalized(), b.spacing, b.wander * b.spacing, kReach * b.spacing, random.bits()});
    seed_ = random.bits();
  }

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return range(value);
    } else {
      T high(height_);
      if (ragged_ > 0) {
        const T wave = clamp(gradient_noise(p * T(wave_), seed_), T(-1.0), T(1.0));
        high = high * (T(1.0) + T(ragged_) * wave);
      }
      const T above = (value - high) * T(1 / (1 + height_slope()));
      T out = value;
      for (const Layering& set : sets_) {
        const Bed<T> bed = bed_at(set.height(p), set.seed);
        const T apart = min(bed.below, bed.above) * T(1 / set.slope()) - T(half_ / stretch(set));
        out = min(out, max(apart, above));
      }
      return out;
    }
  }
  Traits traits(const Traits& child) const { return layer().traits(child); }
  Interval range(Interval child) const { return layer().range(child); }

  void add_to(Digester& digester) const { digester(half_, height_, ragged_, wave_, sets_); }

 private:
  /// How much closer together surfaces of a bent set can be than planes.
  static double stretch(const Layering& set) { return set.slope() * set.thickness; }
  static constexpr double kReach = 4;  // Wavelength of the bends, in spacings.
  GrownLayer layer() const { return {height_ * (1 + ragged_), height_slope()}; }
  double height_slope() const { return height_ * ragged_ * wave_ * kGradientNoiseSlope; }

  double half_, height_, ragged_, wave_;
  std::vector<Layering> sets_;
  uint32_t seed_ = 0;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(boxwork) {
  return field_kind<Boxwork>("boxwork", "detail", [](const Boxwork& b) {
    return Field(std::make_shared<ModifierNode<Veins>>("boxwork", Veins(b), b.field.node()));
  });
}
