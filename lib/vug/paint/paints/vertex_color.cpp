// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

namespace vug::paint {
namespace {

struct VertexColor {
  std::string name = "Cd";
  Paint otherwise;

  static void describe(Schema<VertexColor>& s) {
    s.doc("The vertex colour of the mesh.")
        .param("name", &VertexColor::name, {.doc = "the attribute's name"})
        .param("otherwise", &VertexColor::otherwise,
               {.doc = "the paint of a mesh without the attribute; grey when not given"});
  }
};

}  // namespace
}  // namespace vug::paint

VUG_PAINT_KIND(vertex_color) {
  return paint_kind<VertexColor>("vertex_color", [](const VertexColor& v) {
    AttributeUses uses;
    uses.refers_to_scene = v.otherwise && v.otherwise->uses().refers_to_scene;
    const auto evaluate = [v](const EvalPoint& point) {
      const auto value = point.attributes ? point.attributes->read(v.name) : std::nullopt;
      if (value) return *value;
      return v.otherwise ? (*v.otherwise)(point) : Vec3d(0.5);
    };
    return make_paint(evaluate, std::move(uses));
  });
}
