// SPDX-License-Identifier: Apache-2.0
// Automatic portals: openings to the sky, found before rendering.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/integrator.h>
#include <vug/render/light.h>
#include <vug/render/lighting/rectangle_shape.h>

#include <vector>

namespace vug::render {

/// Finds portals for the skies, which sample directions without regard to the rock around the
/// openings, or none at all: rays are traced from points on camera paths, and rectangles are fitted
/// to their hits on the scene's bounding box. Returns no portals if the scene has some already, if
/// enough rays escape for the sky to be found without them, or if no ray escapes. Portals may miss
/// part of the sky, which paths then find as before: the expected image is the same.
/// Error(cancelled).
std::vector<RectangleParams> find_automatic_portals(const TrainingContext& context,
                                                    Progress& progress);
/// The portals as lights.
std::vector<LightPtr> portal_lights(const std::vector<RectangleParams>& portals);

}  // namespace vug::render
