// SPDX-License-Identifier: Apache-2.0
#include <vug/field/constant.h>
#include <vug/field/material_node.h>
#include <vug/field/rock_material_kind.h>

namespace vug::field {
namespace {

struct MadeOf {
  Field field;
  RockMaterialPtr of;

  static void describe(Schema<MadeOf>& s) {
    s.doc(
         "The same solid, made of one material. It replaces the materials that the field had; "
         "values do not change.")
        .param("field", &MadeOf::field, {.doc = "the solid", .required = true})
        .param("of", &MadeOf::of,
               {.doc = "its material: a name such as \"calcite\", or a rock_material",
                .required = true});
  }
  std::string fault() const { return of ? name_fault(*of) : ""; }
};

class OneMaterial final : public MaterialRule {
 public:
  explicit OneMaterial(RockMaterialPtr material) : material_(std::move(material)) {}
  MaterialSample sample(const Node& child, const Vec3d& p) const override {
    return {child.eval(point(p)), MaterialMix(*material_)};
  }
  NearMixes mixes_near(const Node&, const NearPoints& points) const override {
    return {points.size(), MaterialMix(*material_), true};
  }
  std::optional<Field> mean(const Field&, const MaterialNumber& number) const override {
    return constant_field(number.number(*material_));
  }
  std::vector<RockMaterialPtr> assigned() const override { return {material_}; }

  void add_to(Digester& digester) const override { digester(material_); }

 private:
  RockMaterialPtr material_;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(made_of) {
  return field_kind<MadeOf>("made_of", "operator", [](const MadeOf& m) {
    return with_materials("made_of", m.field, std::make_shared<OneMaterial>(m.of));
  });
}
