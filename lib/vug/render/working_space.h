// A scene made ready for light in other primaries than those of Rec.709.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/render/scene.h>

namespace vug::render {

/// Parameters of lights, media and materials are linear Rec.709. This is the same scene in another
/// space, in which it then is rendered: lights and media give their colours there, materials
/// reflect as before the light that is white in both. Nothing is wrapped where the space is
/// Rec.709. What steers sampling (importance, noise) goes on weighing channels as Rec.709 does.
Scene in_space(Scene scene, image::WorkingSpace space);

/// The parts of it. Null stays null.
LightPtr in_space(const LightPtr& light, const image::ColourMatrix& way);
MediumPtr in_space(const MediumPtr& medium, const image::ColourMatrix& way);

}  // namespace vug::render
