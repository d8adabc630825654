// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

struct Sleep {
  static constexpr bool kSingleStep = true;
  static void describe(Schema<Sleep>& s) {
    s.doc("Cells fall asleep: they keep their values, are invisible to others and cost nothing.")
        .cite("gobron2006");
  }

  void step(Pass& pass) const {
    const auto state = pass.writes_states();
    pass.run([=](const auto&, uint32_t i) { state.set(i, CellState::sleeping); });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(sleep) { return rule_kind<Sleep>("sleep"); }
