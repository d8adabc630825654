// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/base/diagnostics.h>
#include <vug/karst/presets.h>

namespace vug::karst {
namespace {

constexpr double kDegree = kPi / 180;

Box3d box(double half_side, double low, double high) {
  return {Vec3d(-half_side, low, -half_side), Vec3d(half_side, high, half_side)};
}

Layer layer(double height, double dip_degrees, double azimuth_degrees) {
  return {.point = Vec3d(0, height, 0),
          .dip = dip_degrees * kDegree,
          .dip_azimuth = azimuth_degrees * kDegree};
}

FractureFamily joints(double azimuth_degrees, double spacing, double spread_degrees) {
  return {
      .azimuth = azimuth_degrees * kDegree, .spacing = spacing, .spread = spread_degrees * kDegree};
}

Preset branchwork() {
  Preset p{"branchwork", "Streams that join like the branches of a tree.", {}, {}};
  p.geology.bounds = box(400, -60, 40);
  p.geology.beds = {layer(-10, 3, 120), layer(15, 3, 120)};
  p.geology.fractures = {joints(35, 25, 12), joints(110, 40, 12)};
  p.geology.water_tables = {layer(-15, 1.5, 120)};
  p.options.samples.count = 6000;
  p.options.growth.sinks = 14;
  p.options.growth.dead_ends = 80;
  p.options.growth.dead_end_length = 8;
  p.options.growth.dead_end_spread = 2;
  p.options.growth.clustering = 0.9;
  p.options.growth.at_junctions = 0.08;
  p.options.growth.loops = 0.11;
  p.options.shape.zigzag = 0.25;
  return p;
}

Preset maze_rectilinear() {
  Preset p{"maze_rectilinear", "Passages along crossing joints of one bed.", {}, {}};
  p.geology.bounds = box(250, -20, 20);
  p.geology.beds = {layer(0, 1, 200)};
  p.geology.fractures = {joints(20, 11, 18), joints(105, 13, 18), joints(65, 30, 18)};
  p.geology.water_tables = {layer(10, 0, 0)};
  p.options.samples = {.on_beds = 0, .on_fractures = 1, .joint_network = true, .in_permeable = 0};
  p.options.cost.fracture = 40;        // The rock between joints is tight,
  p.options.cost.heterogeneity = 0.4;  // and joints are open in parts.
  p.options.growth.sinks = 2;
  p.options.growth.waypoints = 40;
  p.options.growth.gamma = 1.5;
  p.options.growth.dead_end_length = 14;
  p.options.growth.dead_end_spread = 1.4;
  p.options.growth.clustering = 0.92;
  p.options.shape.leg_length = 12;  // Passages are straight from one joint to the next.
  p.options.shape.wander = 0.05;
  p.options.shape.looping = 0;
  return p;
}

Preset maze_anastomotic() {
  Preset p{"maze_anastomotic", "Winding tubes that part and join again on a bed.", {}, {}};
  p.geology.bounds = box(250, -25, 25);
  p.geology.beds = {layer(0, 4, 60)};
  p.geology.fractures = {joints(60, 40, 30)};
  p.geology.water_tables = {layer(12, 2, 60)};
  p.options.samples = {.on_beds = 0.8, .on_fractures = 0, .in_permeable = 0};
  p.options.cost.heterogeneity = 0.4;
  p.options.growth.sinks = 4;
  p.options.growth.waypoints = 34;
  p.options.growth.gamma = 1.6;
  p.options.growth.dead_ends = 80;
  p.options.growth.dead_end_length = 10;
  p.options.growth.dead_end_spread = 1.5;
  p.options.growth.loops = 0.07;
  p.options.growth.at_junctions = 0.04;
  p.options.shape.wander = 0.2;
  return p;
}

Preset spongework() {
  Preset p{"spongework", "Irregular passages in three dimensions in porous rock.", {}, {}};
  p.geology.bounds = box(150, -60, 60);
  p.geology.permeable = {{Vec3d(-50, -10, 20), 90, 1}, {Vec3d(60, 10, -30), 80, 1}};
  p.geology.fractures = {joints(40, 30, 30)};
  p.geology.water_tables = {layer(55, 0, 0)};
  p.options.samples = {.on_beds = 0, .on_fractures = 0, .in_permeable = 0.6};
  p.options.cost.fracture = 1;
  p.options.cost.phreatic = 0;
  p.options.cost.heterogeneity = 0.5;
  p.options.growth.sinks = 0;
  p.options.growth.waypoints = 12;
  p.options.growth.gamma = 1.6;
  p.options.growth.dead_end_length = 10;
  p.options.growth.dead_end_spread = 2.1;
  p.options.growth.cluster_radius = 15;
  p.options.growth.at_junctions = 0.03;
  p.options.growth.loops = 0.04;
  p.options.shape.wander = 0.2;
  return p;
}

Preset conduit() {
  Preset p{"conduit", "One long stream passage with few side passages.", {}, {}};
  p.geology.bounds = box(700, -80, 40);
  p.geology.beds = {layer(-20, 2, 90)};
  p.geology.fractures = {joints(75, 30, 12), joints(150, 50, 12)};
  p.geology.water_tables = {layer(-30, 1, 90)};
  p.options.samples.count = 6000;
  p.options.growth.sinks = 6;
  p.options.growth.dead_ends = 34;
  p.options.growth.dead_end_length = 10;
  p.options.growth.dead_end_spread = 1.4;
  p.options.growth.clustering = 0.85;
  p.options.growth.cluster_radius = 30;
  p.options.growth.loops = 0.13;
  p.options.growth.loop_most = 250;  // Flood routes bypass long reaches of the main passage.
  p.options.growth.at_junctions = 0.12;
  p.options.shape.wander = 0.11;
  p.options.shape.zigzag = 0.25;
  return p;
}

Preset shafts() {
  Preset p{"shafts", "An alpine pothole: pitches and short galleries far above the water.", {}, {}};
  p.geology.bounds = box(180, -350, 40);
  p.geology.beds = {layer(-60, 12, 40), layer(-180, 12, 40), layer(-290, 12, 40)};
  p.geology.fractures = {joints(10, 25, 12), joints(95, 30, 12)};
  p.geology.faults = {{.point = Vec3d(0), .azimuth = 30 * kDegree, .dip = 80 * kDegree}};
  p.geology.water_tables = {layer(-320, 0, 0)};
  p.options.samples = {.count = 8000, .on_beds = 0.3, .on_fractures = 0.1, .in_permeable = 0};
  p.options.cost.bed = 0.5;
  p.options.cost.vadose = 6;
  p.options.cost.heterogeneity = 0.2;
  p.options.growth.sinks = 6;
  p.options.growth.dead_end_length = 11;
  p.options.growth.dead_end_spread = 1.7;
  p.options.growth.loops = 0.1;
  p.options.shape.wander = 0.085;
  p.options.shape.zigzag = 0.2;
  p.options.shape.pitch = 20;
  return p;
}

Preset tiers() {
  Preset p{"tiers", "Levels that former and present water tables left, joined by shafts.", {}, {}};
  p.geology.bounds = box(400, -140, 60);
  p.geology.beds = {layer(-80, 2, 100), layer(-20, 2, 100), layer(30, 2, 100)};
  p.geology.fractures = {joints(30, 30, 12), joints(120, 40, 12)};
  p.geology.water_tables = {layer(-85, 1, 100), layer(-30, 1, 100), layer(20, 1, 100)};
  p.options.samples.count = 8000;
  p.options.growth.sinks = 6;
  p.options.growth.dead_end_spread = 1.5;
  p.options.growth.cluster_radius = 30;
  p.options.growth.loops = 0.05;
  p.options.shape.zigzag = 0.25;
  return p;
}

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> list{branchwork(), maze_rectilinear(), maze_anastomotic(),
                                        spongework(), conduit(),          shafts(),
                                        tiers()};
  return list;
}

const Preset& find_preset(std::string_view name) {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) {
    if (preset.name == name) return preset;
    names.emplace_back(preset.name);
  }
  throw Error(ErrorCode::bad_input, fmt::format("unknown karst preset '{}'", name), {},
              suggestion(std::string(name), names));
}

}  // namespace vug::karst
