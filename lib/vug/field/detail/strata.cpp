// SPDX-License-Identifier: Apache-2.0
// Exposed beds: a displacement by the noise `beds` with direct access to its parameters.
#include <vug/field/beds.h>
#include <vug/field/displace.h>

#include <optional>

namespace vug::field {
namespace {

struct Strata : BedParams {
  Field field;
  double depth = 0.15;
  double flat = 0.3;
  std::optional<Noise> by;

  static void describe(Schema<Strata>& s) {
    s.doc(
         "Layered hardness along a tilted axis: hard beds protrude as ledges, soft ones recede as "
         "notches.")
        .param("field", &Strata::field, {.doc = "the rock", .required = true})
        .param("depth", &Strata::depth, positive_length("depth of ledges and notches"));
    describe_beds(s)
        .param("flat", &Strata::flat,
               {.doc = "factor on the depth where the rock faces up or down, along the beds",
                .min = 0,
                .max = 1})
        .param("by", &Strata::by,
               {.doc = "a noise as mask: full depth at 1, none at -1; softness(of: ROCK) by the "
                       "hardness of the materials"});
  }
};

Field layered(const Strata& s) {
  Displacement options;
  options.amount = s.depth;
  options.floor = options.ceiling = s.flat;
  options.feel = 0.5 * s.thickness;
  options.by = s.by;
  return displaced(s.field, layered_rock(s), options);
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(strata) { return field_kind<Strata>("strata", "detail", layered); }
