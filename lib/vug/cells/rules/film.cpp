// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/film_flow.h>
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// The flow does not depend on earlier steps: one step suffices while the surface rests.
struct Film : FilmParams {
  static constexpr bool kSingleStep = true;

  static void describe(Schema<Film>& s) {
    s.doc(
         "The steady film of water. It enters at `source`, or at all cells if they lack this "
         "attribute, runs down to the edges and drips off overhangs. Hollows fill to level pools "
         "that overflow at their lowest crests. Provides film (thickness), pool (depth), discharge "
         "(m3/s) and outlet (1 where water leaves).")
        .cite("nusselt1916")
        .cite("barnes2014");
    describe_film(s);
  }

  void step(Pass& pass) const {
    const FilmFlow flow(pass, *this);
    std::vector<Load> load = flow.sources();
    const auto pass_on = [](uint32_t, const Load& all) { return all; };
    flow.drainage().route(load, pass_on, pass_on);
    write_film(pass, flow, load);
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(film) { return rule_kind<Film>("film"); }
