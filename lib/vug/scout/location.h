// SPDX-License-Identifier: Apache-2.0
// A scene that is prepared for the search of shots.
#pragma once

#include <vug/picture/picture.h>
#include <vug/render/prepared_scene.h>
#include <vug/scout/candidates.h>
#include <vug/scout/score.h>

#include <memory>

namespace vug::scout {

struct Location {
  render::Scene scene;
  std::shared_ptr<const render::PreparedScene> world;
  std::vector<Vec3d> starts;  ///< Points in the air: those of cameras and networks.
  bool lit = false;           ///< It has lights or emissive objects of its own.
  bool sky_shines = false;    ///< One of its lights is infinite.
};

/// Builds the objects that the plan shows, without micro-displacement, which depends on the camera.
/// A scene without lights has none here. `relight`: finite lights are left out, too.
Location prepare_location(building::Builder& builder, const picture::PicturePlan& plan,
                          bool relight = false);

/// The places to stand: those below the starts, or below any point in the air. If enough places
/// have a roof, places in the open are left out. Throws Error(bad_input) if the scene has no floor.
std::vector<Stand> places_to_stand(const Location& location);

/// The objects that are rare enough to be landmarks, judged by views from the floor: an object that
/// covers a share s of all pictures has the weight 1 - 5 s. The sky is a landmark under a roof. A
/// body that is 1.4 to 2.2 m high and less than 1.2 m wide is a figure.
Landmarks find_landmarks(const Location& location, const std::vector<View>& views);

/// The middles of the landmarks that are smaller than 12 m.
std::vector<Subject> find_subjects(const Location& location, const Landmarks& landmarks);

}  // namespace vug::scout
