// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/plants.h>

namespace vug::loading {

#define VUG_KIND(name) const Kind<field::Field>& name##_plant();
#include <vug/loading/plants_kinds.inc>
#undef VUG_KIND

const Kinds<field::Field>& plant_kinds() {
#define VUG_KIND(name) &name##_plant(),
  static const Kinds<field::Field> kinds = {
#include <vug/loading/plants_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::loading
