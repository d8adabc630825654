// SPDX-License-Identifier: Apache-2.0
// Instances placed by the turtle of an L-system, such as leaves on twigs.
#include <vug/loading/instance_source_kinds.h>
#include <vug/loading/lsystem_binding.h>
#include <vug/shot/lsystem_plan.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

struct Instances {
  shot::LSystemPtr of;
  std::string name;
  double scale = 1;

  static void describe(Schema<Instances>& s) {
    s.doc(
         "Instances placed by the turtle of an L-system under a name: y axis along its heading, x "
         "to its right, z along its up vector, scaled by the first parameter of the symbol.")
        .param("of", &Instances::of, {.doc = "the L-system", .required = true})
        .param("name", &Instances::name,
               {.doc = "name of the symbol, one of its 'instances'", .required = true})
        .param("scale", &Instances::scale,
               {.doc = "factor of the size of each", .min = 0, .above_min = true});
  }
  std::string fault() const {
    if (!of) return "";
    const std::vector<std::string>& names = of->block.instances;
    if (std::find(names.begin(), names.end(), name) != names.end()) return "";
    return fmt::format("the L-system places no instances '{}'", name);
  }
};

std::vector<building::Instance> instances_of(const Instances& wanted, RandomKey key) {
  const lsystem::DrawingPtr drawing = wanted.of->drawing();
  std::vector<building::Instance> places;
  for (size_t i = 0; i < drawing->instances.size(); ++i) {
    const lsystem::Instance& each = drawing->instances[i];
    const double size = each.size * wanted.scale;
    if (drawing->names[each.name] != wanted.name || !(size > 0)) continue;
    places.push_back({Transform(each.frame.normal * -size, each.frame.tangent * size,
                                each.frame.binormal * size, each.position),
                      key.at(i), -1});
  }
  return places;
}

}  // namespace
}  // namespace vug::loading

VUG_INSTANCE_SOURCE_KIND(instances) {
  return instance_source_kind<Instances>(
      "instances", [](const Instances& wanted, building::Builder&, RandomKey key) {
        return instances_of(wanted, key);
      });
}
