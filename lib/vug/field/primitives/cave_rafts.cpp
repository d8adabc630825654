// SPDX-License-Identifier: Apache-2.0
// Cave rafts: thin plates of calcite that float on still water until they grow too heavy.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/kind.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/hex_plate.h>

#include <cmath>

namespace vug::field {
namespace {

struct CaveRafts {
  static constexpr double kMost = 2e5;
  static constexpr double kJitter = 0.15;  // Of the distance between plates.
  static constexpr double kWidest = 0.4;   // Radius, so that neighbours do not touch ...
  static constexpr double kThinnest = 0.2;

  double radius = 0.5;
  double plate = 0.03;
  double thickness = 0.001;
  double cover = 0.8;
  int seed = 1;

  static void describe(Schema<CaveRafts>& s) {
    s.doc(
         "Cave rafts: thin plates that float on the water of a pool. The water is at height 0, the "
         "lower half of each plate in it.")
        .cite("hill1997")
        .param("radius", &CaveRafts::radius, positive_length("radius of the patch of rafts"))
        .param("plate", &CaveRafts::plate, positive_length("mean distance between plates"))
        .param("thickness", &CaveRafts::thickness,
               positive_length("thickness of a plate, 0.1 to 1 mm in caves; at least two voxels in "
                               "a level set"))
        .param("cover", &CaveRafts::cover,
               {.doc = "fraction of the places with a plate",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("seed", &CaveRafts::seed, {.doc = "random seed; each seed gives other plates"});
  }
  std::string fault() const {
    if (!(thickness < kThinnest * plate))
      return "rafts must be thinner than a fifth of their width";
    return radius / plate * (radius / plate) * 4 < kMost
               ? ""
               : "the plates are too small for a patch of this radius";
  }
  Field make() const {
    const RandomKey key = RandomKey(static_cast<uint64_t>(seed)).at("cave_rafts");
    const auto cells = static_cast<int>(std::ceil(radius / plate));
    std::vector<HexPlate> out;
    for (int i = -cells; i <= cells; ++i)
      for (int k = -cells; k <= cells; ++k) {
        RandomStream random(
            key.at(static_cast<uint64_t>(i + cells)).at(static_cast<uint64_t>(k + cells)));
        const double x = random.uniform(-kJitter, kJitter), z = random.uniform(-kJitter, kJitter);
        const Vec3d at((i + x) * plate, 0, (k + z) * plate);
        const bool kept = random.uniform() < cover;
        const double turn = 2 * kPi * random.uniform();
        const double size = plate * random.uniform(kThinnest, kWidest - kJitter) * 0.86602540378;
        if (!kept || at.length() > radius) continue;
        const Vec3d side(maths::cos(turn), 0, maths::sin(turn));
        out.emplace_back(at, Vec3d(0, 1, 0), side, size, 0.5 * thickness);
      }
    return element_field("cave_rafts", std::move(out), Exactness::bound);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cave_rafts) {
  return field_kind<CaveRafts>("cave_rafts", "primitive",
                               [](const CaveRafts& r) { return r.make(); });
}
