// What a scene has placed many times, as one mesh: so that a grove can place the whole scene.
#pragma once

#include <vug/render/scene.h>

#include <vector>

namespace vug::building {

/// The objects, with those that are instances of one mesh, under one name and of one material, made
/// one object whose mesh is all of them; its material sees the space that they stand in, and the
/// attribute "copy" tells them apart. What moves, shines, sees its place, or has a level set that
/// masks may ask about stays as it is. In the order of first appearance. Error(too_large).
std::vector<render::Object> merge_copies(const std::vector<render::Object>& objects);

}  // namespace vug::building
