// SPDX-License-Identifier: Apache-2.0
// Pendants: the rock that stays between channels which water above sediment dissolved upwards from
// a ceiling or a bedding plane.
#include <vug/base/rng.h>
#include <vug/field/modifier.h>
#include <vug/field/speleogens/braid.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Pendants {
  Field field;
  double spacing = 0.5;
  double width = 0.2;
  double height = 0.4;
  double level = -1000;
  Vec3d normal{0, 1, 0};
  double wander = 0.12;
  int seed = 1;

  static void describe(Schema<Pendants>& s) {
    s.doc(
         "Pendants of a ceiling: pillars of rock between braided channels, which are cut into it "
         "along the normal of the beds.")
        .cite("ewers1966")
        .param("field", &Pendants::field, {.doc = "the rock", .required = true})
        .param("spacing", &Pendants::spacing, positive_length("mean distance between pendants"))
        .param("width", &Pendants::width,
               positive_length("width of a channel, 5 cm to 50 cm in caves"))
        .param("height", &Pendants::height,
               positive_length("length of the pendants, 10 cm to 1 m in caves: depth of the "
                               "channels below the surface of the rock"))
        .param("level", &Pendants::level,
               any_length("height along the normal above which there are channels, such as the "
                          "middle of a passage: the floor below stays whole"))
        .param("normal", &Pendants::normal,
               {.doc = "perpendicular to the beds, of any length but 0"})
        .param(
            "wander", &Pendants::wander,
            {.doc = "sideways deviation of the channels", .dimension = Dimension::length, .min = 0})
        .param("seed", &Pendants::seed, {.doc = "random seed; each seed gives other channels"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal of the beds must not be zero";
    if (!(width < spacing)) return "the width of channels must be below their spacing";
    return wander <= spacing ? "" : "'wander' must not exceed the spacing of the pendants";
  }
};

/// max(rock, -channels); the distance to a channel is divided by its slope.
class PendantChannels {
 public:
  explicit PendantChannels(const Pendants& p)
      : braid_(p.normal, p.spacing, p.wander,
               RandomStream(RandomKey(static_cast<uint64_t>(p.seed)).at("pendants"))),
        up_(p.normal.normalized()),
        width_(p.width),
        height_(p.height),
        level_(p.level) {}

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    if constexpr (std::is_same_v<T, Interval>) {
      return range(value);
    } else {
      const T beside = (T(width_) - braid_.apart(p) * T(braid_.spacing())) * T(1 / braid_.slope());
      const T above = dot(p, constant<T>(up_)) - T(level_);
      return max(value, min(min(beside, above), value + T(height_)));
    }
  }
  Traits traits(const Traits& child) const { return carved_traits(child); }
  Interval range(Interval child) const {
    return {child.lo, std::max(child.hi, std::min(width_ / braid_.slope(), child.hi + height_))};
  }

  void add_to(Digester& digester) const { digester(braid_, up_, width_, height_, level_); }

 private:
  Braid braid_;
  Vec3d up_;
  double width_, height_, level_;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(pendants) {
  return field_kind<Pendants>("pendants", "detail", [](const Pendants& p) {
    return Field(std::make_shared<ModifierNode<PendantChannels>>("pendants", PendantChannels(p),
                                                                 p.field.node()));
  });
}
