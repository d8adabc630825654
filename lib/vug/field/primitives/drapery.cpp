// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/field/path.h>
#include <vug/field/speleothems/drapery_sheet.h>

namespace vug::field {
namespace {

struct DraperyParams {
  std::vector<Vec3d> path{Vec3d(-0.6, 0, 0), Vec3d(0.6, -0.5, 0)};
  double width = 0.4;
  double thickness = 0.005;
  double root_thickness = 0.015;
  double fold = 0.12;
  double root = 0;
  int seed = 1;

  static void describe(Schema<DraperyParams>& s) {
    const auto length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
    };
    s.doc(
         "A drapery: the thin folded sheet that grows downwards from the path of a film of water "
         "under a sloping roof.")
        .cite("hill1997")
        .param("path", &DraperyParams::path,
               any_length("points of the path along the roof, from the highest on"))
        .param("width", &DraperyParams::width,
               positive_length("greatest height of the sheet below its path"))
        .param(
            "thickness", &DraperyParams::thickness,
            positive_length("thickness at the lower edge: a drop's width, 4 mm to 6 mm; at least "
                            "2.2 voxels in a level set"))
        .param("root_thickness", &DraperyParams::root_thickness,
               positive_length("thickness at the roof, 1 cm to 2 cm"))
        .param("fold", &DraperyParams::fold,
               length("mean distance of the folds along the path, 5 cm to 20 cm; 0 for none"))
        .param("root", &DraperyParams::root,
               length("height by which it continues upwards into the rock"))
        .param("seed", &DraperyParams::seed,
               {.doc = "random seed; each seed gives other folds and layers"});
  }
  std::string fault() const {
    if (const std::string fault = path_fault(path); !fault.empty()) return fault;
    for (size_t i = 1; i < path.size(); ++i)
      if ((path[i] - path[i - 1]).length() > 0) return "";
    return "the points of the path of a drapery are all the same";
  }
  Field make() const {
    const Drapery drapery{path, width, thickness, root_thickness, fold, root};
    return sheet_field(
        "drapery", drapery_sheet(drapery, RandomKey(static_cast<uint64_t>(seed)).at("drapery")));
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(drapery) {
  return field_kind<DraperyParams>("drapery", "primitive",
                                   [](const DraperyParams& d) { return d.make(); });
}
