// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {

#define VUG_KIND(name) const MaskKind& name##_mask();
#include <vug/paint/masks_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const PaintKind& name##_paint();
#include <vug/paint/paints_kinds.inc>
#undef VUG_KIND

const Kinds<Mask>& masks() {
#define VUG_KIND(name) &name##_mask(),
  static const Kinds<Mask> kinds = {
#include <vug/paint/masks_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

const Kinds<Paint>& paints() {
#define VUG_KIND(name) &name##_paint(),
  static const Kinds<Paint> kinds = {
#include <vug/paint/paints_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::paint
