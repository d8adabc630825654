// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/karst/options.h>

namespace vug::karst {
namespace {

struct Range {
  const char* name;
  double value;
  double low, high;
};

}  // namespace

void require_valid(const KarstOptions& o) {
  const Range ranges[] = {
      {"number of samples", double(o.samples.count), 2, 2e5},
      {"fraction of samples on beds", o.samples.on_beds, 0, 1},
      {"fraction of samples on fractures", o.samples.on_fractures, 0, 1},
      {"fraction of samples in permeable rock", o.samples.in_permeable, 0, 1},
      {"number of neighbours of a sample", double(o.samples.neighbours), 1, 200},
      {"separation of passages", o.samples.separation, 0.01, 1e3},
      {"weight of beds", o.cost.bed, 0, 1e3},
      {"reach of beds", o.cost.bed_reach, 1e-3, 1e6},
      {"weight of fractures", o.cost.fracture, 0, 1e3},
      {"weight of permeability", o.cost.permeability, 0, 1e3},
      {"weight of ghost rock", o.cost.ghost_rock, 0, 1e3},
      {"weight of the vadose zone", o.cost.vadose, 0, 1e3},
      {"weight of the phreatic zone", o.cost.phreatic, 0, 1e3},
      {"reach of the water table", o.cost.table_reach, 1e-3, 1e6},
      {"heterogeneity", o.cost.heterogeneity, 0, 3},
      {"exponent of the length of legs", o.cost.shortness, 0, 3},
      {"factor of passages that exist", o.cost.reuse, 0, 1},
      {"number of sinks", double(o.growth.sinks), 0, 1e3},
      {"number of waypoints", double(o.growth.waypoints), 0, 1e3},
      {"exponent gamma", o.growth.gamma, 0, 10},
      {"number of dead ends", double(o.growth.dead_ends), 0, 1e4},
      {"length of dead ends", o.growth.dead_end_length, 1e-3, 1e6},
      {"spread of the lengths of dead ends", o.growth.dead_end_spread, 0, 3},
      {"number of loops for each junction or end", o.growth.loops, 0, 1},
      {"least size of loops", o.growth.loop_least, 0, 1e6},
      {"largest size of loops", o.growth.loop_most, o.growth.loop_least, 1e6},
      {"fraction of passages at junctions", o.growth.at_junctions, 0, 1},
      {"clustering of passages", o.growth.clustering, 0, 1},
      {"radius of clusters", o.growth.cluster_radius, 0, 1e6},
      {"longest leg", o.shape.leg_length, 0.1, 1e6},
      {"wander of passages", o.shape.wander, 0, 0.5},
      {"fraction of legs in steps", o.shape.zigzag, 0, 1},
      {"slope of vadose passages", o.shape.vadose_slope, 0, 1.5},
      {"height of pitches", o.shape.pitch, 0.1, 1e6},
      {"depth of phreatic loops", o.shape.looping, 0, 2}};
  for (const Range& range : ranges)
    if (!(range.value >= range.low && range.value <= range.high))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the {} of a karst network is {}", range.name, range.value), {},
                  fmt::format("it must be between {} and {}", range.low, range.high));
  const double shares = o.samples.on_beds + o.samples.on_fractures + o.samples.in_permeable;
  if (shares > 1 + 1e-9)
    throw Error(ErrorCode::bad_input,
                fmt::format("the fractions of samples on beds, on fractures and in permeable rock "
                            "sum to {}",
                            shares),
                {}, "their sum must be at most 1; the rest is distributed in the whole rock");
}

}  // namespace vug::karst
