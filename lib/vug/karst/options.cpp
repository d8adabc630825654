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
  const Range ranges[] = {{"samples.count", double(o.samples.count), 2, 2e6},
                          {"samples.on_beds", o.samples.on_beds, 0, 1},
                          {"samples.on_fractures", o.samples.on_fractures, 0, 1},
                          {"samples.in_permeable", o.samples.in_permeable, 0, 1},
                          {"samples.neighbours", double(o.samples.neighbours), 1, 200},
                          {"cost.bed", o.cost.bed, 0, 1e3},
                          {"cost.bed_reach", o.cost.bed_reach, 1e-3, 1e6},
                          {"cost.fracture", o.cost.fracture, 0, 1e3},
                          {"cost.permeability", o.cost.permeability, 0, 1e3},
                          {"cost.ghost_rock", o.cost.ghost_rock, 0, 1e3},
                          {"cost.vadose", o.cost.vadose, 0, 1e3},
                          {"cost.phreatic", o.cost.phreatic, 0, 1e3},
                          {"cost.table_reach", o.cost.table_reach, 1e-3, 1e6},
                          {"cost.heterogeneity", o.cost.heterogeneity, 0, 3},
                          {"cost.shortness", o.cost.shortness, 0, 3},
                          {"cost.reuse", o.cost.reuse, 0, 1},
                          {"growth.sinks", double(o.growth.sinks), 0, 1e4},
                          {"growth.waypoints", double(o.growth.waypoints), 0, 1e4},
                          {"growth.gamma", o.growth.gamma, 0, 10},
                          {"growth.dead_ends", double(o.growth.dead_ends), 0, 1e5},
                          {"growth.dead_end_length", o.growth.dead_end_length, 1e-3, 1e6},
                          {"growth.dead_end_spread", o.growth.dead_end_spread, 0, 3},
                          {"growth.loops", o.growth.loops, 0, 1},
                          {"growth.loop_least", o.growth.loop_least, 0, 1e6},
                          {"growth.loop_most", o.growth.loop_most, o.growth.loop_least, 1e6},
                          {"growth.at_junctions", o.growth.at_junctions, 0, 1},
                          {"growth.clustering", o.growth.clustering, 0, 1},
                          {"growth.cluster_radius", o.growth.cluster_radius, 0, 1e6},
                          {"shape.leg_length", o.shape.leg_length, 0.1, 1e6},
                          {"shape.wander", o.shape.wander, 0, 0.5},
                          {"shape.zigzag", o.shape.zigzag, 0, 1},
                          {"shape.vadose_slope", o.shape.vadose_slope, 0, 1.5},
                          {"shape.pitch", o.shape.pitch, 0.1, 1e6},
                          {"shape.looping", o.shape.looping, 0, 2}};
  for (const Range& range : ranges)
    if (!(range.value >= range.low && range.value <= range.high))
      throw Error(ErrorCode::bad_input,
                  fmt::format("the karst option {} is {}", range.name, range.value), {},
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
