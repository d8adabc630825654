// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// The cascades of the paper: cells whose attribute has reached a threshold keep their state, and
/// later rules work with them or on the rest.
struct Freeze {
  std::string attribute;
  double above = 0.5;
  std::optional<double> below;
  CellState as = CellState::sleeping;

  static void describe(Schema<Freeze>& s) {
    s.doc(
         "Cells in which an attribute has reached a threshold are frozen: they sleep, or remain "
         "visible to their neighbours. `wake` releases them.")
        .cite("gobron2006")
        .param("attribute", &Freeze::attribute, {.doc = "name of the attribute", .required = true})
        .param("above", &Freeze::above, {.doc = "minimum value of a cell to freeze"})
        .param("below", &Freeze::below, {.doc = "maximum value, if any"})
        .choice("as", &Freeze::as,
                {{"sleeping", CellState::sleeping},
                 {"distributing", CellState::distributing},
                 {"receiving", CellState::receiving},
                 {"transparent", CellState::transparent}},
                "state of frozen cells: distributing ones are visible, receiving ones updated, "
                "sleeping ones neither, transparent ones removed");
  }
  std::string fault() const {
    return below && *below < above ? "'below' must not be less than 'above'" : "";
  }

  void step(Pass& pass) const {
    const auto state = pass.writes_states();
    const NumericReader value = pass.reads_as_numbers(attribute);
    const auto least = static_cast<float>(above);
    const auto most = static_cast<float>(below.value_or(kInfinity));
    pass.run([=, then = as](const auto&, uint32_t i) {
      const bool frozen = value[i] >= least && value[i] <= most;
      state.set(i, frozen ? then : state[i]);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(freeze) { return rule_kind<Freeze>("freeze"); }
