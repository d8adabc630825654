// SPDX-License-Identifier: Apache-2.0
// A union whose blend radius depends on the materials that meet: k(p) = a^T K b for the weights a
// and b of both solids at the point and the table K. The derivative of the smooth minimum by its
// radius is at most 1/4, so the slope of k adds at most a quarter of it to the Lipschitz constant.
#include <vug/field/material_pair_kind.h>
#include <vug/field/material_source.h>
#include <vug/field/variable_blend.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::field {
namespace {

struct UnionByMaterial {
  Field a;
  Field b;
  std::vector<MaterialPair> radii;
  double radius = 0;
  std::optional<double> contact;

  static void describe(Schema<UnionByMaterial>& s) {
    s.doc(
         "Two solids together, with a smooth blend whose radius depends on the materials that "
         "meet: sand runs into rock, chert stays sharp.")
        .cite("quilez2013smin")
        .param("a", &UnionByMaterial::a, {.doc = "a solid with materials", .required = true})
        .param("b", &UnionByMaterial::b, {.doc = "another one", .required = true})
        .param(
            "radii", &UnionByMaterial::radii,
            {.doc = "pair(of: [NAME, NAME], radius: ...) for pairs of materials", .required = true})
        .param("radius", &UnionByMaterial::radius,
               {.doc = "the radius for all other pairs", .dimension = Dimension::length, .min = 0})
        .param("contact", &UnionByMaterial::contact,
               {.doc = "width over which the radius changes at contacts; default: twice the "
                       "difference of the smallest and the largest radius",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true});
  }
  std::string fault() const {
    const std::vector<RockMaterialPtr> of_a = materials_of(a), of_b = materials_of(b);
    if (of_a.empty() || of_b.empty())
      return fmt::format("'{}' has no materials: assign them with made_of(...) or host_rock(...)",
                         of_a.empty() ? "a" : "b");
    const auto known = [&](const std::string& name) {
      const auto same = [&](const RockMaterialPtr& each) { return each->name == name; };
      return std::any_of(of_a.begin(), of_a.end(), same) ||
             std::any_of(of_b.begin(), of_b.end(), same);
    };
    for (const MaterialPair& pair : radii)
      for (const std::string& name : pair.of)
        if (!known(name)) return fmt::format("neither solid is made of '{}'", name);
    return {};
  }
  double radius_of(const std::string& x, const std::string& y) const {
    for (const MaterialPair& pair : radii)
      if ((pair.of[0] == x && pair.of[1] == y) || (pair.of[0] == y && pair.of[1] == x))
        return pair.radius;
    return radius;
  }
};

Field united_by_material(const UnionByMaterial& u) {
  const std::vector<RockMaterialPtr> of_a = materials_of(u.a), of_b = materials_of(u.b);
  Interval range(kInfinity, -kInfinity);
  for (const RockMaterialPtr& x : of_a)
    for (const RockMaterialPtr& y : of_b) {
      const double own = u.radius_of(x->name, y->name);
      range = {std::min(range.lo, own), std::max(range.hi, own)};
    }
  if (!(range.width() > 0)) return variable_blend(u.a, u.b, {{}, range});
  MaterialNumber number;
  number.contact = u.contact.value_or(2 * range.width());
  std::vector<RadiusTerm> terms;
  for (const RockMaterialPtr& x : of_a) {
    number.range = {0, 1};
    number.number = [&](const RockMaterial& m) { return m.name == x->name ? 1.0 : 0.0; };
    const Field weight = material_mean(u.a, number).value();
    number.range = range;
    number.number = [&](const RockMaterial& m) { return u.radius_of(x->name, m.name); };
    terms.push_back({weight, material_mean(u.b, number).value()});
  }
  return variable_blend(u.a, u.b, {std::move(terms), range});
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(union_by_material) {
  return field_kind<UnionByMaterial>("union_by_material", "operator", united_by_material);
}
