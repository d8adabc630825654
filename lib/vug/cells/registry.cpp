// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/kind.h>
#include <vug/cells/rule.h>

namespace vug::cells {

#define VUG_KIND(name) const GridKind& name##_grid();
#include <vug/cells/grids_kinds.inc>
#undef VUG_KIND
#define VUG_KIND(name) const RuleKind& name##_rule();
#include <vug/cells/rules_kinds.inc>
#undef VUG_KIND

const Kinds<Grid>& grids() {
#define VUG_KIND(name) &name##_grid(),
  static const Kinds<Grid> kinds = {
#include <vug/cells/grids_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

const Kinds<RulePtr>& rules() {
#define VUG_KIND(name) &name##_rule(),
  static const Kinds<RulePtr> kinds = {
#include <vug/cells/rules_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

}  // namespace vug::cells
