// SPDX-License-Identifier: Apache-2.0
// Rock that beds and lenses of other materials traverse. The bodies lie over each other from front
// to back, each with the weight of what the bodies before it leave, so the weights are continuous
// and their sum is 1 for any bodies.
#include <vug/field/constant.h>
#include <vug/field/material_node.h>
#include <vug/field/rock_material_kind.h>

#include <algorithm>

namespace vug::field {
namespace {

struct HostRock {
  Field field;
  RockMaterialPtr of;
  std::vector<Field> bodies;
  double contact = 0.1;

  static void describe(Schema<HostRock>& s) {
    s.doc(
         "The same solid, of rock that bodies of other materials traverse: beds, lenses, veins. "
         "Materials change smoothly across their contacts; values do not change.")
        .param("field", &HostRock::field, {.doc = "the solid", .required = true})
        .param(
            "of", &HostRock::of,
            {.doc = "the material outside the bodies: a name or a rock_material", .required = true})
        .param("bodies", &HostRock::bodies,
               {.doc = "solids with materials, e.g. made_of(slab(...), of: \"chert\"); the first "
                       "that contains a point counts"})
        .param("contact", &HostRock::contact,
               {.doc = "width of the contacts, half of it on each side",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::string fault() const {
    if (!of) return {};
    const bool bare = std::any_of(bodies.begin(), bodies.end(),
                                  [](const Field& f) { return materials_of(f).empty(); });
    return bare ? "a body has no material: assign one with made_of(BODY, of: \"chert\")"
                : name_fault(*of);
  }
};

class Partition final : public MaterialRule {
 public:
  explicit Partition(HostRock host) : host_(std::move(host)) {}

  MaterialSample sample(const Node& child, const Vec3d& p) const override {
    MaterialSample out{child.eval(point(p)), MaterialMix(*host_.of)};
    for (size_t i = host_.bodies.size(); i-- > 0;) {  // From the back.
      const MaterialSample body = field::sample_materials(*host_.bodies[i].node(), p);
      out.mix = mixed(out.mix, body.mix, share_inside(body.value, host_.contact));
    }
    return out;
  }
  NearMixes mixes_near(const Node&, const NearPoints& points) const override {
    NearMixes out(points.size(), MaterialMix(*host_.of), true);
    for (size_t i = host_.bodies.size(); i-- > 0;)  // From the back.
      lay_over(out, *host_.bodies[i].node(), host_.contact, points);
    return out;
  }
  std::optional<Field> mean(const Field&, const MaterialNumber& number) const override {
    Field out = constant_field(number.number(*host_.of));
    for (size_t i = host_.bodies.size(); i-- > 0;)
      if (const std::optional<Field> inside = material_mean(host_.bodies[i], number))
        out = contact_mean({host_.bodies[i], *inside}, out, number);
    return out;
  }
  std::vector<RockMaterialPtr> assigned() const override { return {host_.of}; }
  std::vector<NodePtr> bodies() const override {
    std::vector<NodePtr> out;
    for (const Field& body : host_.bodies) out.push_back(body.node());
    return out;
  }

  void add_to(Digester& digester) const override {
    digester(host_.of, host_.bodies, host_.contact);
  }

 private:
  HostRock host_;
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(host_rock) {
  return field_kind<HostRock>("host_rock", "operator", [](const HostRock& h) {
    return with_materials("host_rock", h.field, std::make_shared<Partition>(h));
  });
}
