// SPDX-License-Identifier: Apache-2.0
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct Perlin {
  Factors scale;
  int seed = 1;

  static void describe(Schema<Perlin>& s) {
    s.doc("Gradient noise with a single feature size.")
        .cite("perlin2002")
        .param("scale", &Perlin::scale,
               {.doc = "size of the features; a vector stretches them along the axes",
                .dimension = Dimension::length,
                .min = 0,
                .above_min = true})
        .param("seed", &Perlin::seed, {.doc = "random seed; each seed gives a different noise"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(perlin) {
  return noise_kind<Perlin>("perlin", [](const Perlin& p) {
    OctaveParams one;
    one.scale = p.scale;
    one.octaves = 1;
    one.seed = p.seed;
    return Fractal<PlainShape>(one);
  });
}
