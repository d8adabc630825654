// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

struct Wake {
  static constexpr bool kSingleStep = true;
  static void describe(Schema<Wake>& s) {
    s.doc("All cells become active, whatever their state.").cite("gobron2006");
  }

  void step(Pass& pass) const {
    const auto state = pass.writes_states();
    pass.run_everywhere([=](const auto&, uint32_t i) { state.set(i, CellState::active); });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(wake) { return rule_kind<Wake>("wake"); }
