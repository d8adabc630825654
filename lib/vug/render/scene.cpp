// SPDX-License-Identifier: Apache-2.0
#include <vug/render/scene.h>

namespace vug::render {

Box3d object_bounds(const Object& object) {
  const Affine to = object.instance ? object.instance->at(0) : Affine();
  Box3f box;
  if (object.mesh)
    for (const Vec3f& p : object.mesh->positions) box.extendBy(to.point(p));
  else if (const Box3d own = object.surface->bounds(); !own.isEmpty())
    box = to.box({Vec3f(own.min), Vec3f(own.max)});
  return box.isEmpty() ? Box3d() : Box3d(Vec3d(box.min), Vec3d(box.max));
}

}  // namespace vug::render
