// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/curves.h>

namespace vug::shot {

#define VUG_KIND(name) const Kind<Bezier>& name##_curve();
#include <vug/shot/curves_kinds.inc>
#undef VUG_KIND

const Kinds<Bezier>& curve_kinds() {
#define VUG_KIND(name) &name##_curve(),
  static const Kinds<Bezier> kinds = {
#include <vug/shot/curves_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::shot
