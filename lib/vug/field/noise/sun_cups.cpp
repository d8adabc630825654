// SPDX-License-Identifier: Apache-2.0
// Sun cups: bowls that the sun melts into snow and ice, with sharp rims between them.
#include <vug/base/rng.h>
#include <vug/field/speleogens/plan_pits.h>

namespace vug::field {
namespace {

struct SunCups {
  double width = 0.4;
  Vec3d sun{0, 1, 0};
  int seed = 1;

  static void describe(Schema<SunCups>& s) {
    s.doc(
         "Bowls in snow and ice with sharp rims: about -1 at their deepest points, rims near 0. "
         "Use them on ground; real ones are a quarter to a half as deep as wide.")
        .cite("betterton2001")
        .param("width", &SunCups::width,
               positive_length("mean width of a bowl, 20 cm to 60 cm on old snow"))
        .param("sun", &SunCups::sun,
               {.doc = "direction towards the sun, of any length but 0; the bowls point there"})
        .param("seed", &SunCups::seed, {.doc = "random seed; each seed gives different bowls"});
  }
  std::string fault() const { return sun.length2() > 0 ? "" : "the sun must have a direction"; }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(sun_cups) {
  return noise_kind<SunCups>("sun_cups", [](const SunCups& s) {
    RandomStream random(RandomKey(static_cast<uint64_t>(s.seed)).at("sun_cups"));
    return PlanPits(s.width, s.sun, random.bits());
  });
}
