// SPDX-License-Identifier: Apache-2.0
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct Billow : OctaveParams {
  static void describe(Schema<Billow>& s) {
    describe_octaves(s.doc("Round bumps that meet in sharp hollows, like boulders or clouds.")
                         .cite("musgrave1989"));
  }
  void add_to(Digester& digester) const { digester(static_cast<const OctaveParams&>(*this)); }
};

/// 2 |n|, minus its mean.
struct BillowShape {
  static constexpr double kSlope = 2;
  template <class T>
  static T of(const T& n) {
    return abs(n) * T(2.0) - T(0.53);
  }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(billow) {
  return noise_kind<Billow>("billow", [](const Billow& p) { return Fractal<BillowShape>(p); });
}
