// Where the sky shines in: openings of a scene, found before the picture begins.
#pragma once

#include <vug/base/progress.h>
#include <vug/render/integrator.h>
#include <vug/render/light.h>

#include <vector>

namespace vug::render {

/// Portals for an even sky, which no light samples: rays from places that the camera's paths come
/// to are let out, and rectangles are laid around where they cross the scene's box. None where
/// there are portals already, where the sky is found well enough without (a good part of the rays
/// gets out), or where nothing gets out. They may miss part of the sky, which paths then find as
/// they would without: the picture's mean does not depend on them. Error(cancelled).
std::vector<LightPtr> find_automatic_portals(const TrainingContext& context, Progress& progress);

}  // namespace vug::render
