// SPDX-License-Identifier: Apache-2.0
// A cubic Bezier curve by its control points.
#include <vug/shot/curves.h>

namespace vug::shot {
namespace {

struct BezierPoints {
  Vec3d a{0, 0, 0};
  Vec3d b{0, 1, 0};
  Vec3d c{0, 2, 0};
  Vec3d d{0, 3, 0};

  static void describe(Schema<BezierPoints>& s) {
    s.doc(
         "A curve from a to d that leaves a towards b and comes to d from c. A turtle follows it "
         "from where it stands: x is its right, y ahead, z its up.")
        .cite("luo2010bamboo")
        .param("a", &BezierPoints::a, any_length("where it begins"))
        .param("b", &BezierPoints::b, any_length("what it leaves for"))
        .param("c", &BezierPoints::c, any_length("what it comes from"))
        .param("d", &BezierPoints::d, any_length("where it ends"));
  }
  std::string fault() const {
    return a == b && b == c && c == d ? "all points of the curve are in one place" : "";
  }
};

}  // namespace
}  // namespace vug::shot

VUG_CURVE_KIND(bezier) {
  return make_kind<Bezier, BezierPoints>("bezier", "curve", [](const BezierPoints& p) {
    return Bezier{{p.a, p.b, p.c, p.d}};
  });
}
