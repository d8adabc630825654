// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/carve.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>

namespace vug::facade {
namespace {

struct Carve : FacadeParams {
  field::Field field;
  double clear = 0;
  double margin = 0;

  static void describe(Schema<Carve>& s) {
    s.doc("A solid with a carved facade, including its projecting parts: a temple in a cliff.")
        .param("field", &Carve::field, {.doc = "the solid to be carved", .required = true});
    describe_facade(s);
    s.param("clear", &Carve::clear,
            {.doc = "depth in front of the facade's plane in which the solid is removed first",
             .dimension = Dimension::length,
             .min = 0})
        .param("margin", &Carve::margin,
               {.doc = "extent of that removal beyond the facade's sides and top",
                .dimension = Dimension::length,
                .min = 0});
    describe_frame(s);
  }
  std::string fault() const { return facade_fault(); }
};

field::Field carved_field(const Carve& c) {
  const FacadeInstance placed = c.placed();
  const Tree& tree = *placed.tree;
  const Transform frame = placed.frame.transform(tree.width);
  field::Field out = c.field;
  if (c.clear > 0)
    out = field::subtract(
        out,
        {field::transformed(
            block({-c.margin, 0, tree.width + 2 * c.margin, tree.height + c.margin}, 0, c.clear),
            frame)});
  Carving carving = carve(tree);
  for (Carving::Layer& layer : carving.layers) layer.solid = field::transformed(layer.solid, frame);
  return with_facade(placed, carving.applied(out));
}

}  // namespace
}  // namespace vug::facade

VUG_FACADE_SOLID(carve) { return field::field_kind<Carve>("carve", "operator", carved_field); }
