// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/opaque.h>
#include <vug/field/sampled.h>

#include <algorithm>

namespace vug::field {
namespace {

struct GridSource {
  std::shared_ptr<const SampledGrid> grid;
  Box3d bounds;

  /// max(band's value, distance to the bounds): both are lower bounds of the distance to the
  /// surface.
  Gradient sample(const Vec3d& p) const {
    Vec3d off;
    for (int axis = 0; axis < 3; ++axis)
      off[axis] = p[axis] - std::clamp(p[axis], bounds.min[axis], bounds.max[axis]);
    const double away = off.length();
    Gradient g = grid->sample(p);
    if (away > 0 && away > g.value) g = {away, off / away};
    return g;
  }
};

GridLoader& loader() {
  static GridLoader instance;
  return instance;
}

}  // namespace

Field sampled(std::shared_ptr<const SampledGrid> grid) {
  Traits traits;
  traits.bounds = grid->bounds();
  traits.lipschitz = std::max(1.0, grid->lipschitz());
  traits.exactness = traits.lipschitz > 1 + 1e-6 ? Exactness::sign : Exactness::bound;
  traits.growth = 1;
  if (traits.bounds.isEmpty())
    throw Error(ErrorCode::bad_input, "a level set without voxels does not bound a solid");
  const Box3d bounds = traits.bounds;
  return Field(std::make_shared<OpaqueNode<GridSource>>("grid", std::move(traits),
                                                        GridSource{std::move(grid), bounds}));
}

void set_grid_loader(GridLoader next) { loader() = std::move(next); }

std::shared_ptr<const SampledGrid> load_grid(const std::string& file, const std::string& name) {
  if (!loader()) throw Error(ErrorCode::bad_input, "this program cannot read .vdb files");
  return loader()(file, name);
}

}  // namespace vug::field
