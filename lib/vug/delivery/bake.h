// Looks at the vertices of a mesh: what its material says of each place, as attributes.
#pragma once

#include <vug/exchange/look.h>
#include <vug/render/scene.h>

namespace vug::delivery {

struct BakeResult {
  /// With an attribute for each channel of the look that varies; of a flat object without normals.
  mesh::MeshPtr mesh;
  exchange::Look look;  ///< Elsewhere the mean.
};

/// The object's material, seen from outside in the mesh's own space, or where the object stands if
/// its look depends on that; its "Cd" becomes the body's colour. Of a mesh with holes that part is
/// left which is there (see cut_out.h). An attribute of the mesh that is
/// called like a channel is kept under "raw_NAME".
BakeResult bake(const render::Object& object);

}  // namespace vug::delivery
