// SPDX-License-Identifier: Apache-2.0
// The water table of the present, or of a former time.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct WaterTable : LayerFeature {
  static void describe(Schema<WaterTable>& s) {
    s.doc(
        "A water table, above which passages are vadose and below which they are phreatic. The "
        "first one is the present one; each further one is older and lies above it.");
    LayerFeature::describe(s);
  }
  void add(karst::Geology& geology) const { geology.water_tables.push_back(layer()); }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(water_table) { return geology_kind<WaterTable>("water_table"); }
