// SPDX-License-Identifier: Apache-2.0
// Materials by the weights of the rock, as nested mixtures of two: each takes its part of the
// weight that it has together with those before it.
#include <vug/mesh/rock_weights.h>
#include <vug/paint/kind.h>
#include <vug/render/kind.h>

#include <algorithm>

namespace vug::render {
namespace {

struct ByRock {
  std::vector<std::string> of;
  std::vector<MaterialPtr> materials;
  MaterialPtr otherwise;

  static void describe(Schema<ByRock>& s) {
    s.doc(
         "The material of each rock, layered by the weights that the mesh has from made_of, "
         "host_rock and coat. Scenes write it as a table: by rock { limestone -> grey }.")
        .param("of", &ByRock::of, {.doc = "the names of the rock materials", .required = true})
        .param("materials", &ByRock::materials,
               {.doc = "for each name the material of its surface", .required = true})
        .param("otherwise", &ByRock::otherwise,
               {.doc = "the material for other rocks and for meshes without weights; default: the "
                       "named ones share the weight of other rocks"});
  }
  std::string fault() const {
    if (of.empty()) return "'of' needs the name of a rock material";
    for (size_t i = 0; i < of.size(); ++i)
      if (std::find(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(i), of[i]) !=
          of.begin() + static_cast<std::ptrdiff_t>(i))
        return "'of' names a rock material twice";
    return of.size() == materials.size()
               ? ""
               : "'materials' needs one material for each name in 'of', in the same order";
  }
};

/// The weight of the last name relative to all names and the rest; 0 without any weight.
double share_of_last(const std::vector<std::string>& attributes, size_t count, bool with_rest,
                     const paint::EvalPoint& point) {
  const auto weight = [&](size_t i) {
    const auto read = point.attributes ? point.attributes->read(attributes[i]) : std::nullopt;
    return read ? std::max(read->x, 0.0) : 0.0;
  };
  double before = 0, all = 0, last = 0;
  for (size_t i = 0; i < attributes.size(); ++i) {
    const double own = weight(i);
    all += own;
    if (i + 1 < count) before += own;
    if (i + 1 == count) last = own;
  }
  if (with_rest) before += std::max(0.0, 1 - all);
  return last > 0 ? last / (before + last) : 0;
}

MaterialPtr mixture(const ByRock& params) {
  std::vector<std::string> attributes;
  paint::AttributeUses uses;
  for (const std::string& name : params.of) {
    attributes.push_back(mesh::weight_attribute(name));
    uses.push_back({attributes.back(), {}});
  }
  const bool with_rest = params.otherwise != nullptr;
  MaterialPtr made = with_rest ? params.otherwise : params.materials[0];
  for (size_t i = with_rest ? 0 : 1; i < attributes.size(); ++i) {
    const auto share = [attributes, count = i + 1, with_rest](const paint::EvalPoint& point) {
      return share_of_last(attributes, count, with_rest, point);
    };
    made = make_material(
        "mix", {{"a", ValueTraits<MaterialPtr>::write(made)},
                {"b", ValueTraits<MaterialPtr>::write(params.materials[i])},
                {"mask", ValueTraits<paint::Mask>::write(paint::make_mask(share, uses))}});
  }
  return made;
}

}  // namespace

const Kind<MaterialPtr>& by_rock_material() {
  static const auto kind = make_kind<MaterialPtr, ByRock>("by_rock", "material", mixture);
  return kind;
}

}  // namespace vug::render
