// SPDX-License-Identifier: Apache-2.0
// The Bezier curve of a stem that gravity bends.
#include <vug/shot/curves.h>

namespace vug::shot {
namespace {

struct Drooping {
  double length = 1;
  double lean = 0;
  double tip = 0;
  double towards = 0;
  double stiff = 0.5;

  static void describe(Schema<Drooping>& s) {
    const ParamSpec angle_spec = {.doc = "", .dimension = Dimension::angle};
    const auto angle = [&](const char* doc) {
      ParamSpec spec = angle_spec;
      spec.doc = doc;
      return spec;
    };
    s.doc("The Bezier curve of a stem that leaves its foot upright and hangs over at its tip.")
        .cite("luo2010bamboo")
        .param("length", &Drooping::length, positive_length("along the curve"))
        .param("lean", &Drooping::lean, angle("of the foot, from the plumb"))
        .param("tip", &Drooping::tip, angle("of the tip, from the plumb; above 90deg it hangs"))
        .param("towards", &Drooping::towards, angle("where it leans: 0 is +x, 90deg -z"))
        .param("stiff", &Drooping::stiff,
               {.doc = "share of the curve's polygon that stays as it left the foot",
                .min = 0.01,
                .max = 0.99});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_CURVE_KIND(drooping) {
  return make_kind<Bezier, Drooping>("drooping", "curve", [](const Drooping& d) {
    return drooping(d.length, d.lean, d.tip, d.towards, d.stiff);
  });
}
