// SPDX-License-Identifier: Apache-2.0
// Level sets to be ray traced: smooth, rough, hollow.
#pragma once

#include "scenes.h"

#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/displace.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>
#include <vug/volume/surface_bricks.h>
#include <vug/volume/voxelize.h>

namespace vug::render {

constexpr double kVoxel = 0.05;

inline volume::LevelSet level_set(const field::Field& solid) {
  volume::VoxelizeOptions options;
  options.voxel = kVoxel;
  return volume::voxelize(solid, options);
}

inline field::Field ball(double radius = 1) { return field::make("sphere", {{"radius", radius}}); }

inline field::Field displaced_ball(const field::Noise& noise) {
  field::Displacement how;
  how.amount = 0.3;
  return field::displaced(ball(), noise, how);
}
inline field::Field lump() {
  return displaced_ball(field::make_noise("fbm", {{"scale", 1.0}, {"octaves", 1}}));
}
/// With sharp valleys.
inline field::Field rough() { return displaced_ball(field::make_noise("ridged")); }

inline Object traced(const field::Field& solid) {
  Object out;
  out.name = "traced";
  out.surface = std::make_shared<const volume::SurfaceBricks>(level_set(solid));
  return out;
}

inline Scene only(Object object) {
  Scene scene;
  scene.objects.push_back(std::move(object));
  return scene;
}

inline Vec2f pair(RandomStream& random) {
  const auto x = static_cast<float>(random.uniform());
  return {x, static_cast<float>(random.uniform())};
}

}  // namespace vug::render
