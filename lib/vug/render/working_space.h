// SPDX-License-Identifier: Apache-2.0
// Converts a scene to a working colour space with primaries other than those of Rec.709.
#pragma once

#include <vug/image/colour_space.h>
#include <vug/render/scene.h>

namespace vug::render {

/// Parameters of lights, media and materials are linear Rec.709. This returns the scene converted
/// to another space for rendering: lights and media give their colours in that space, and materials
/// reflect it such that white stays white. Nothing is wrapped if the space is Rec.709. Sampling
/// decisions (importance, noise) still weight the channels as in Rec.709.
Scene in_space(Scene scene, image::WorkingSpace space);

/// Converts a single light or medium; null stays null.
LightPtr in_space(const LightPtr& light, const image::ColourMatrix& from_rec709);
MediumPtr in_space(const MediumPtr& medium, const image::ColourMatrix& from_rec709);

}  // namespace vug::render
