// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/shape.h>

namespace vug::flora {

#define VUG_KIND(name) const ShapeKind& name##_shape();
#include <vug/flora/shapes_kinds.inc>
#undef VUG_KIND

const Kinds<Shape>& shapes() {
#define VUG_KIND(name) &name##_shape(),
  static const Kinds<Shape> kinds = {
#include <vug/flora/shapes_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::flora
