// SPDX-License-Identifier: Apache-2.0
// Rings where drops fall into still water.
#include <vug/passages/water/drop_rings.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct DropRings {
  std::vector<Vec3d> at;
  double wavelength = passages::DropRingsOptions().wavelength;
  double reach = passages::DropRingsOptions().reach;
  int seed = 0;

  static void describe(Schema<DropRings>& s) {
    s.doc(
         "Rings on still water around the places where drops fall: use it as the bump of the "
         "water, "
         "with 1 mm to 3 mm.")
        .param("at", &DropRings::at,
               {.doc = "where drops fall, such as drip_points(of: drips, only: landings)",
                .dimension = Dimension::length,
                .required = true})
        .param("wavelength", &DropRings::wavelength,
               positive_length("distance of the crests; 17 mm to 5 cm"))
        .param("reach", &DropRings::reach, positive_length("largest radius of the rings"))
        .param("seed", &DropRings::seed, {.doc = "seed of the radii"});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_NOISE_KIND(drop_rings) {
  return make_kind<field::Noise, DropRings>("drop_rings", "noise", [](const DropRings& p) {
    return passages::drop_rings({.points = p.at,
                                 .wavelength = p.wavelength,
                                 .reach = p.reach,
                                 .seed = static_cast<uint64_t>(p.seed)});
  });
}
