// The counterpart of cavity: the field is read a step inside, where less depth is left near edges.
#include <vug/paint/kind.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Edge {
  field::Field field;
  double reach = 0.1;

  static void describe(Schema<Edge>& s) {
    s.doc("0 on flat and hollow rock, rising to 1 on edges and spikes that weather first.")
        .param("field", &Edge::field, {.doc = "the solid whose surface it is", .required = true})
        .param("reach", &Edge::reach, positive_length("size of the edges that count"));
  }
};

}  // namespace

const MaskKind& edge_mask() {
  static const MaskKind kind = mask_kind<Edge>("edge", [](const Edge& e) {
    return make_mask([e](const Spot& spot) {
      const double depth = -e.field.value(spot.position - spot.normal * e.reach);
      return std::clamp(1 - depth / e.reach, 0.0, 1.0);
    });
  });
  return kind;
}

}  // namespace vug::paint
