#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// The cascades of the paper: what one rule has brought far enough stays as it is, and those that
/// follow work with it or on the rest.
struct Freeze {
  std::string attribute;
  double above = 0.5;
  std::optional<double> below;
  CellState as = CellState::sleeping;

  static void describe(Schema<Freeze>& s) {
    s.doc(
         "Cells in which an attribute has come far enough stay as they are: they sleep, or still "
         "show their neighbours what they have. `wake` frees them.")
        .cite("gobron2006")
        .param("attribute", &Freeze::attribute, {.doc = "its name", .required = true})
        .param("above", &Freeze::above, {.doc = "the least value of a cell that freezes"})
        .param("below", &Freeze::below, {.doc = "the greatest, if there is one"})
        .choice("as", &Freeze::as,
                {{"sleeping", CellState::sleeping},
                 {"distributing", CellState::distributing},
                 {"receiving", CellState::receiving},
                 {"transparent", CellState::transparent}},
                "what they become: distributing ones are seen, receiving ones rewritten, sleeping "
                "ones neither, transparent ones are gone");
  }
  std::string fault() const { return below && *below < above ? "below is less than above" : ""; }

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
