// SPDX-License-Identifier: Apache-2.0
// Converts an opacity mask to holes in a mesh.
#pragma once

#include <vug/render/scene.h>

#include <optional>

namespace vug::delivery {

/// The opaque part of the object's mesh if its material's opacity is binary, such as the outline of
/// a leaf on a card, so that every program that reads meshes gets the holes. A coarse mesh is
/// refined first, so that outlines are smooth and baked attributes follow the material. Nothing if
/// the opacity is 1 everywhere or continuous; see Look::opacity.
std::optional<mesh::Mesh> cutout_mesh(const render::Object& object);

}  // namespace vug::delivery
