// Holes by opacity, as meshes have them.
#pragma once

#include <vug/render/scene.h>

#include <optional>

namespace vug::delivery {

/// The part of the object's mesh that its material's opacity leaves, where that is a matter of yes
/// or no, such as the outline of a leaf on a card: whatever reads meshes has the holes then. A mesh
/// of few triangles is made finer first, so that outlines are smooth and what is baked at vertices
/// follows the look. Nothing where the opacity is 1 or in between: see Look::opacity.
std::optional<mesh::Mesh> cutout_mesh(const render::Object& object);

}  // namespace vug::delivery
