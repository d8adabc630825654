// SPDX-License-Identifier: Apache-2.0
// The stream of a cave: pools, riffles and falls from its sinks to its springs.
#include <vug/passages/water/water_body.h>
#include <vug/shot/passage_params.h>

namespace vug::shot {
namespace {

struct StreamParams : PassageParams {
  std::vector<std::string> from;
  std::vector<std::string> to;
  double discharge = passages::StreamOptions().discharge;
  double roughness = passages::StreamOptions().roughness;
  double depth = 0;
  double fill = 0;
  double fall = passages::StreamOptions().fall;
  double thickness = 0.1;
  double spacing = passages::StreamOptions().spacing;
  double overlap = passages::kOverlap;
  passages::StreamPart part = passages::StreamPart::all;
  int seed = 0;

  static void describe(Schema<StreamParams>& s) {
    s.doc(
         "The water of a stream in the passages of a network: level pools between riffles, falls "
         "at pitches, and backwaters. It extends into the rock on its banks.")
        .cite("leopold1964fluvial");
    describe_network(s);
    s.param("from", &StreamParams::from,
            {.doc = "stations where water enters; by default all sinks, or the highest end"})
        .param("to", &StreamParams::to,
               {.doc = "stations where it leaves; by default all springs, or the lowest end"})
        .param("discharge", &StreamParams::discharge,
               {.doc = "m^3/s of each source", .min = 0, .max = 1000, .above_min = true})
        .param("roughness", &StreamParams::roughness,
               {.doc = "Manning's n of the bed in s/m^(1/3)", .min = 0.01, .max = 0.5});
    describe_bed(s, "sediment", "fill");
    s.param("fall", &StreamParams::fall,
            {.doc = "slope from which water falls",
             .dimension = Dimension::angle,
             .min = 0.2,
             .max = kPi / 2})
        .param("thickness", &StreamParams::thickness, positive_length("of falling water, at least"))
        .param("spacing", &StreamParams::spacing,
               {.doc = "distance between points of the surface, at most",
                .dimension = Dimension::length,
                .min = 0.05,
                .max = 100});
    describe_overlap(s, "water");
    s.choice("part", &StreamParams::part,
             {{"all", passages::StreamPart::all},
              {"surface", passages::StreamPart::surface},
              {"falls", passages::StreamPart::falls}},
             "which water: pools, riffles and backwaters, or falls")
        .param("seed", &StreamParams::seed, {.doc = "of the distances between riffles", .min = 0});
    describe_walls(s);
  }
};

field::Field water(const StreamParams& p) {
  passages::StreamOptions options;
  options.from = stations_named(*p.of, p.from);
  options.to = stations_named(*p.of, p.to);
  options.discharge = p.discharge;
  options.roughness = p.roughness;
  options.fall = p.fall;
  options.spacing = p.spacing;
  options.seed = static_cast<uint64_t>(p.seed);
  options.sediment = {.depth = p.depth, .fill = p.fill};
  return passages::stream_body(*p.of, p.options(), options,
                               {.overlap = p.overlap, .thickness = p.thickness, .part = p.part});
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(stream) {
  return field::field_kind<StreamParams>("stream", "passage", water);
}
