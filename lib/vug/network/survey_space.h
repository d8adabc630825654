// SPDX-License-Identifier: Apache-2.0
// The change between survey space (x east, y north, z up) and scene space (x east, y up, z south).
#pragma once

#include <vug/network/network.h>

namespace vug::network {

/// The scene-space vector of a survey-space vector.
inline Vec3d to_scene(const Vec3d& survey) { return {survey.x, survey.z, -survey.y}; }

/// The survey-space vector of a scene-space vector; the inverse of to_scene.
inline Vec3d to_survey(const Vec3d& scene) { return {scene.x, -scene.z, scene.y}; }

/// The middle of the points' bounding box, rounded to metres; 0 without points. All points must be
/// finite.
Vec3d rounded_middle(const std::vector<Vec3d>& points);

}  // namespace vug::network
