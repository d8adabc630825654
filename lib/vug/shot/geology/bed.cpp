// SPDX-License-Identifier: Apache-2.0
// A bedding plane along which passages begin to form.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct InceptionHorizon : LayerFeature {
  static void describe(Schema<InceptionHorizon>& s) {
    s.doc("A bedding plane along which passages begin to form (an inception horizon).");
    LayerFeature::describe(s);
  }
  void add(karst::Geology& geology) const { geology.beds.push_back(layer()); }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(bed) { return geology_kind<InceptionHorizon>("bed"); }
