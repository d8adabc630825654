// SPDX-License-Identifier: Apache-2.0
// The stems drawn by the turtle of an L-system, as a solid.
#include <vug/flora/cut.h>
#include <vug/flora/sweep_field.h>
#include <vug/loading/lsystem_binding.h>
#include <vug/loading/plants.h>
#include <vug/shot/lsystem_plan.h>

namespace vug::loading {
namespace {

ParamSpec share(std::string doc, double most = 1) {
  return {.doc = std::move(doc), .min = 0, .max = most};
}

struct Stems : flora::SweepOptions, flora::NodeDisplacementOptions {
  shot::LSystemPtr of;
  double thickness = 2e-4;
  std::optional<double> from, to;
  int orders = 1000;

  static void describe(Schema<Stems>& s) {
    s.doc(
         "The drawing of an L-system's turtle: round stems, smooth or folded, with nodes, hollow "
         "if "
         "there is a wall. Widths and heights of rings and grooves are fractions of the stem's "
         "radius.")
        .cite("luo2010bamboo")
        .param("of", &Stems::of, {.doc = "the L-system", .required = true})
        .param("from", &Stems::from,
               any_length("keep only the part above this along stems of order 0"))
        .param("to", &Stems::to, any_length("keep only the part below this along stems of order 0"))
        .param("orders", &Stems::orders, {.doc = "only stems of a lower order", .min = 1})
        .param("thickness", &Stems::thickness,
               positive_length("minimum diameter, also of stems that are only lines"))
        .param("wall", &Stems::wall,
               share("thickness of the wall of a hollow culm; 0: solid", 0.99))
        .param("wall_least", &Stems::min_wall,
               {.doc = "minimum thickness of the wall, as long as a tenth of the radius is hollow",
                .dimension = Dimension::length,
                .min = 0})
        .param("diaphragm", &Stems::diaphragm, share("thickness of the walls across at nodes", 10))
        .param("open", &Stems::open, {.doc = "cut the ends, so that the hollow is visible"})
        .param("smooth", &Stems::smooth,
               {.doc = "maximum bend between two cross-sections",
                .dimension = Dimension::angle,
                .min = 0.001,
                .max = 1})
        .param("fold_order", &Stems::fold_order,
               {.doc = "stems of this order and above keep their bends as folds", .min = 0})
        .param("relief_orders", &Stems::displaced_orders,
               {.doc = "stems of this order and above have no relief", .min = 0});
    s.param("scar", &Stems::scar, share("height of the sheath scar at a node", 0.5))
        .param("scar_width", &Stems::scar_width, share("from its crest to its foot"))
        .param("ridge", &Stems::ridge, share("height of the ridge above the scar", 0.5))
        .param("ridge_width", &Stems::ridge_width, share("from its crest to its foot"))
        .param("ridge_above", &Stems::ridge_above, share("from the scar's crest to the ridge's"))
        .param("groove", &Stems::groove, share("depth of the groove above each branch", 0.3))
        .param("groove_width", &Stems::groove_width,
               {.doc = "from its bed to its rim",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi,
                .above_min = true})
        .param("groove_length", &Stems::groove_length, share("how far up, of the internode"));
  }
  flora::SweepOptions options() const {
    flora::SweepOptions all = *this;
    all.displacement = *this;
    all.min_radius = 0.5 * thickness;
    return all;
  }
  std::string fault() const {
    if (from && to && *from >= *to) return "'to' must be above 'from'";
    if (open && wall == 0 && min_wall == 0)
      return "'open' applies to hollow stems; they need a 'wall'";
    return options().fault();
  }
};

field::Field solid(const Stems& stems) {
  flora::CutOptions cut;
  if (stems.from) cut.from = *stems.from;
  if (stems.to) cut.to = *stems.to;
  cut.orders = stems.orders;
  return flora::swept(flora::tubes(flora::cut(*stems.of->drawing(), cut), stems.options()));
}

}  // namespace
}  // namespace vug::loading

VUG_PLANT_KIND(stems) { return field::field_kind<Stems>("stems", "plant", solid); }
