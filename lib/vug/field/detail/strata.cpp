// Beds laid bare: a displacement by the noise `beds`, with its parameters at hand.
#include <vug/field/displace.h>
#include <vug/field/registry.h>

namespace vug::field {
namespace {

struct Strata {
  Field field;
  double depth = 0.15;
  double thickness = 0.6;
  Vec3d normal{0, 1, 0};
  double ledge = 0.3;
  double laminae = 0.25;
  double wander = 0.1;
  double reach = 8;
  double flat = 0.3;
  int seed = 1;

  static void describe(Schema<Strata>& s) {
    s.doc(
         "Layered hardness along a tilted axis: hard beds stand out as ledges, soft ones are "
         "eaten back as notches.")
        .param("field", &Strata::field, {.doc = "the rock", .required = true})
        .param("depth", &Strata::depth, positive_length("of ledges and notches"))
        .param("thickness", &Strata::thickness, positive_length("mean thickness of a bed"))
        .param("normal", &Strata::normal, {.doc = "across the beds; tilt it to make them dip"})
        .param("ledge", &Strata::ledge,
               {.doc = "part of the mean thickness in which a ledge rises; smaller is sharper",
                .dimension = Dimension::ratio,
                .min = 0.02,
                .max = 1})
        .param("laminae", &Strata::laminae,
               {.doc = "strength of the thin layers within the beds", .min = 0, .max = 1})
        .param("wander", &Strata::wander,
               {.doc = "how far bed surfaces stray from planes",
                .dimension = Dimension::length,
                .min = 0})
        .param("reach", &Strata::reach, positive_length("over which they stray"))
        .param("flat", &Strata::flat,
               {.doc = "factor on the depth where the rock faces up or down, along the beds",
                .min = 0,
                .max = 1})
        .param("seed", &Strata::seed, {.doc = "another seed, other beds"});
  }
  std::string fault() const { return normal.length2() > 0 ? "" : "the normal needs a direction"; }
};

Field layered(const Strata& s) {
  const Noise beds = make_noise("beds", {{"thickness", s.thickness},
                                         {"normal", s.normal},
                                         {"ledge", s.ledge},
                                         {"laminae", s.laminae},
                                         {"wander", s.wander},
                                         {"reach", s.reach},
                                         {"seed", s.seed}});
  Displacement how;
  how.amount = s.depth;
  how.floor = how.ceiling = s.flat;
  how.feel = 0.5 * s.thickness;
  return displaced(s.field, beds, how);
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(strata) {
  return vug::field::field_kind<vug::field::Strata>("strata", "detail", vug::field::layered);
}
