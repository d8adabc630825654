// SPDX-License-Identifier: Apache-2.0
// The parameters of rimstone, and the fields of its stone and its water.
#pragma once

#include <vug/field/noise.h>
#include <vug/field/speleothems/rimstone.h>

namespace vug::field {

struct RimstoneParams {
  Field field;
  double height = 0.12;
  double depth = 0.5;
  double lobes = 0.3;
  double lobe_size = 0.6;
  int seed = 1;
};

template <class P>
Schema<P>& describe_rimstone(Schema<P>& s) {
  const auto ratio = [](std::string doc, double most) {
    return ParamSpec{.doc = std::move(doc), .dimension = Dimension::ratio, .min = 0, .max = most};
  };
  s.param("field", &P::field,
          {.doc = "the rock, whose floor slopes by 2 to 30 degrees", .required = true})
      .param("height", &P::height,
             positive_length("height of the dams: 5 mm for microgours, 5 cm to 2 m for gours. They "
                             "are height / tan(slope) apart"))
      .param("depth", &P::depth, ratio("depth of the pools in heights", 0.9))
      .param("lobes", &P::lobes,
             ratio("how far the crests swing, in heights of the floor; they are convex downstream",
                   0.6))
      .param("lobe_size", &P::lobe_size, positive_length("size of these lobes"))
      .param("seed", &P::seed, {.doc = "random seed; each seed gives other lobes"});
  return s;
}

/// The rock with its terraces, and the region below the water of its pools, without the rock taken
/// away: it continues inside the stone.
Field rimstone(const RimstoneParams& params);
Field rimstone_water(const RimstoneParams& params);

}  // namespace vug::field
