// SPDX-License-Identifier: Apache-2.0
// The water table of the present, or of a former time.
#include <vug/shot/geology.h>

namespace vug::shot {
namespace {

struct WaterTable {
  Vec3d at{0, 0, 0};
  double dip = 0;
  double towards = 0;

  static void describe(Schema<WaterTable>& s) {
    s.doc(
         "A water table, above which passages are vadose and below which they are phreatic. The "
         "first one is the present one; each further one is older and lies above it.")
        .param("at", &WaterTable::at, any_length("a point of the plane"))
        .param("dip", &WaterTable::dip, dip_angle("steepness of the plane", 1.5))
        .param("towards", &WaterTable::towards, compass("direction in which it falls"));
  }
  void add(karst::Geology& geology) const {
    geology.water_tables.push_back({.point = at, .dip = dip, .dip_azimuth = towards});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_GEOLOGY_KIND(water_table) { return geology_kind<WaterTable>("water_table"); }
