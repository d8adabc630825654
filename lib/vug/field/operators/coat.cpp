// SPDX-License-Identifier: Apache-2.0
#include <vug/field/material_node.h>
#include <vug/field/rock_material_kind.h>

namespace vug::field {
namespace {

struct Coating {
  Field field;
  RockMaterialPtr of;
  double thickness = 0.02;

  static void describe(Schema<Coating>& s) {
    s.doc(
         "The same solid, which coats the rock from which it is cut: the walls of "
         "difference(rock, [coat(cave, of: \"calcite\")]) are of calcite up to a depth. Without a "
         "coat a cut exposes the rock. Values do not change.")
        .param("field", &Coating::field,
               {.doc = "the solid, e.g. the air of a cave", .required = true})
        .param("of", &Coating::of,
               {.doc = "the material of the coat: a name or a rock_material", .required = true})
        .param("thickness", &Coating::thickness,
               positive_length("depth below the cut at which half of the coat remains"));
  }
  std::string fault() const { return of ? name_fault(*of) : ""; }
};

class CoatRule final : public MaterialRule {
 public:
  explicit CoatRule(Coating coating) : coating_(std::move(coating)) {}

  MaterialSample sample(const Node& child, const Vec3d& p) const override {
    return field::sample_materials(child, p);
  }
  NearMixes mixes_near(const Node& child, const NearPoints& points) const override {
    return field::mixes_near(child, points);
  }
  Coat coat(const Node& child, const Vec3d& p) const override {
    const double depth = child.eval(point(p)), t = coating_.thickness;
    return {MaterialMix(*coating_.of), share_inside(depth - t, t)};
  }
  std::vector<RockMaterialPtr> assigned() const override { return {coating_.of}; }
  bool keeps_child() const override { return true; }

  void add_to(Digester& digester) const override { digester(coating_.of, coating_.thickness); }

 private:
  Coating coating_;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(coat) {
  return field_kind<Coating>("coat", "operator", [](const Coating& c) {
    return with_materials("coat", c.field, std::make_shared<CoatRule>(c));
  });
}
