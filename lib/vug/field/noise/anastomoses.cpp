// SPDX-License-Identifier: Apache-2.0
// Anastomoses: braided half-tubes that slow water dissolves along a bedding plane. The rock that is
// left between deep ones are pendants.
#include <vug/base/rng.h>
#include <vug/field/noise_node.h>
#include <vug/field/speleogens/braid.h>

namespace vug::field {
namespace {

struct Anastomoses {
  double spacing = 0.7;
  double width = 0.2;
  Vec3d normal{0, 1, 0};
  double wander = 0.2;
  int seed = 1;

  static void describe(Schema<Anastomoses>& s) {
    s.doc(
         "Winding half-tubes that part and meet again in a bedding plane: -1 in the middle of a "
         "tube, 0 on the rock between them. Use them on ceilings: an amount of half the width "
         "makes half-tubes, a few widths make pendants of the rock between.")
        .cite("ewers1966")
        .param("spacing", &Anastomoses::spacing,
               positive_length("mean distance between the meshes of the braid"))
        .param("width", &Anastomoses::width,
               positive_length("width of a tube, 5 cm to 50 cm in caves"))
        .param("normal", &Anastomoses::normal,
               {.doc = "perpendicular to the beds, of any length but 0"})
        .param("wander", &Anastomoses::wander,
               {.doc = "sideways deviation of the tubes", .dimension = Dimension::length, .min = 0})
        .param("seed", &Anastomoses::seed, {.doc = "random seed; each seed gives different tubes"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal must not be zero";
    if (!(width < spacing)) return "the width of anastomoses must be below their spacing";
    return wander <= spacing ? "" : "'wander' must not exceed the spacing of the anastomoses";
  }
};

class Tubes {
 public:
  explicit Tubes(const Anastomoses& a)
      : braid_(a.normal, a.spacing, a.wander,
               RandomStream(RandomKey(static_cast<uint64_t>(a.seed)).at("anastomoses"))),
        width_(a.width) {}

  template <class T>
  T at(const Point<T>& p) const {
    return -max(T(1.0) - square(braid_.apart(p) * T(braid_.spacing() / width_)), T(0.0));
  }
  Interval over(const Ball& ball) const { return centred_bounds(*this, ball); }
  Interval range() const { return {-1, 0}; }
  double lipschitz() const { return 2 / width_ * braid_.slope(); }  // A parabola at its rim.

 private:
  Braid braid_;
  double width_;
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(anastomoses) {
  return noise_kind<Anastomoses>("anastomoses", [](const Anastomoses& a) { return Tubes(a); });
}
