// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/camera.h>
#include <vug/loading/placement/checks.h>
#include <vug/loading/placement/nearest_air.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::loading {
namespace {

/// A camera or a light.
struct Placed {
  std::string name;  ///< "the camera 'main'"
  const char* key;   ///< The parameter of its position, as it is written.
  SourceLocation where;
  Vec3d position;
  IsOpen is_open;
};

/// Adds the error that it is in rock.
void report_in_rock(const Placed& one, const Set& set, Accuracy accuracy,
                    Diagnostics& diagnostics) {
  const std::string rock = rock_at(set, one.position, one.is_open, accuracy)->name;
  const std::optional<NearestAir> air = nearest_air(set, one.position, one.is_open, accuracy);
  const std::string depth = air ? fmt::format("{:.2f} m", air->distance) : "far";
  diagnostics.error(one.where,
                    fmt::format("{} at {} is in rock, {} inside '{}'", one.name,
                                position_text(one.position), depth, rock),
                    air ? fmt::format("the nearest air is {:.2f} m {}: {} {}", air->distance,
                                      air->side, one.key, position_text(air->position))
                        : "");
}

/// Adds a warning if the voxels of a solid close the air around a camera, as large ones do in a
/// narrow passage.
void report_closed_air(const shot::CameraPlan& plan, const Set& set, Accuracy accuracy,
                       Diagnostics& diagnostics) {
  const Vec3d eye(plan.camera->position());
  for (const SetPiece& piece : set.pieces)
    for (const Solid& solid : piece.solids) {
      if (!solid.voxels_contain(eye, accuracy) || solid.is_clear(eye)) continue;
      diagnostics.warning(
          plan.where,
          fmt::format("the voxels of '{}' ({:.3g} m) close the air around the camera '{}'",
                      solid.name, solid.voxel, plan.name),
          "choose smaller voxels, or move the camera away from the wall");
      return;
    }
}

}  // namespace

std::string position_text(const Vec3d& p) {
  const auto rounded = [](double x) { return std::round(x * 100) / 100 + 0.0; };  // no -0
  return fmt::format("({}, {}, {})", rounded(p.x), rounded(p.y), rounded(p.z));
}

void check_cameras(const Loaded& scene, const Set& set, const PlacementOptions& options,
                   Diagnostics& diagnostics) {
  for (const shot::CameraPlan& plan : scene.shot.cameras) {
    if (!options.camera.empty() && plan.name != options.camera) continue;
    exchange::Camera data;
    if (plan.camera->as_data(data) && data.orthographic) continue;
    const Vec3d eye(plan.camera->position());
    if (rock_at(set, eye, &Solid::is_clear, options.accuracy))
      report_in_rock(
          {fmt::format("the camera '{}'", plan.name), "eye", plan.where, eye, &Solid::is_clear},
          set, options.accuracy, diagnostics);
    else
      report_closed_air(plan, set, options.accuracy, diagnostics);
  }
}

void check_lights(const Set& set, Accuracy accuracy, Diagnostics& diagnostics) {
  const auto in_rock = [&](const Vec3d& p) {
    return rock_at(set, p, &Solid::is_translucent, accuracy) != nullptr;
  };
  for (const SetLight& light : set.lights)
    if (std::all_of(light.points.begin(), light.points.end(), in_rock))
      report_in_rock({fmt::format("the light '{}'", light.name), "center:", light.where,
                      light.points.front(), &Solid::is_translucent},
                     set, accuracy, diagnostics);
}

void check_placement(const Loaded& scene, const PlacementOptions& options,
                     Diagnostics& diagnostics) {
  const shot::Shot& part = options.part ? *options.part : scene.shot;
  const Set set = set_of(scene, part);
  check_cameras(scene, set, options, diagnostics);
  check_lights(set, options.accuracy, diagnostics);
  check_props(set, options.accuracy, diagnostics);
  check_voids(scene, part, options.accuracy, diagnostics);
  check_ground(scene, part, diagnostics);
}

}  // namespace vug::loading
