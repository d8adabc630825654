#include <vug/paint/kind.h>

namespace vug::paint {

const std::vector<const MaskKind*>& masks() {
#define VUG_KIND(name) &name##_mask(),
  static const std::vector<const MaskKind*> kinds = {
#include <vug/paint/masks_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

const std::vector<const PaintKind*>& paints() {
#define VUG_KIND(name) &name##_paint(),
  static const std::vector<const PaintKind*> kinds = {
#include <vug/paint/paints_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::paint
