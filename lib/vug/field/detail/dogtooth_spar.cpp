// SPDX-License-Identifier: Apache-2.0
// Dog-tooth spar: crystals of calcite that line a wall, whose c axes are nearly normal to it.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/scalenohedron.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct DogtoothSpar : SurfaceScatter {
  static constexpr double kSpread = 0.45;  // Of the logarithm of lengths.

  double length = 0.03;
  double tilt = 20 * kPi / 180;

  DogtoothSpar() { spacing = 0.022; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), length, tilt);
  }

  static void describe(Schema<DogtoothSpar>& s) {
    s.doc(
         "Dog-tooth spar: pointed crystals of calcite on a wall, scalenohedra {21-31} with twelve "
         "faces, of which the half in the air is seen.")
        .cite("dana1892");
    describe_surface_scatter(s)
        .param("length", &DogtoothSpar::length,
               positive_length("mean length of a crystal above the rock, 5 to 100 mm in nature"))
        .param("tilt", &DogtoothSpar::tilt,
               {.doc = "largest angle between the axis of a crystal and the normal of the wall",
                .dimension = Dimension::angle,
                .min = 0,
                .max = kPi / 3});
  }
  double reach() const { return 2.2 * length; }

  Field crystals() const {
    std::vector<Scalenohedron> out;
    for (const SurfacePlace& place : find_surface_places(*this)) {
      RandomStream random(place.key);
      const double half = length * log_uniform(random, kSpread);
      // Uniform over the directions of the cone.
      const double cosine = 1 - random.uniform() * (1 - maths::cos(tilt));
      const double turn = 2 * kPi * random.uniform();
      const Vec3d axis = tilted(place.normal, maths::acos(cosine), turn);
      out.emplace_back(place.at, axis, half, 2 * kPi * random.uniform());
    }
    return element_field("dogtooth_spar", std::move(out), Exactness::bound);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(dogtooth_spar) {
  return field_kind<DogtoothSpar>("dogtooth_spar", "detail", [](const DogtoothSpar& d) {
    return unite(
        {d.field, deferred(
                      surface_traits(d, d.reach()), {"growing spar", d.bytes<Scalenohedron>()},
                      [](const DogtoothSpar& each) { return each.crystals(); }, d)});
  });
}
