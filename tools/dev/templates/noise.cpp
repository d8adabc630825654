//@ lib/vug/field/noise, name unique in the module
// SPDX-License-Identifier: Apache-2.0
// STUB: the formula and its source.
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct NewKind : OctaveParams {
  static void describe(Schema<NewKind>& s) {
    describe_octaves(s.doc("STUB: its appearance, in one sentence."));
  }
  // Without members of its own, the struct is identified by those of its base.
  void add_to(Digester& digester) const { digester(static_cast<const OctaveParams&>(*this)); }
};

/// Maps the gradient noise n in -1..1 of each octave; kSlope is the maximum slope of `of`.
struct NewKindShape {
  static constexpr double kSlope = 1;
  template <class T>
  static T of(const T& n) {
    return T(0.0) - n;
  }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(new_kind) {
  return noise_kind<NewKind>("new_kind", [](const NewKind& p) { return Fractal<NewKindShape>(p); });
}
