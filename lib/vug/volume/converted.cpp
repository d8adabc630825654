// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/converted.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/ValueTransformer.h>

namespace vug::volume {
namespace {

openvdb::Mat4d matrix(const Transform& to_target) {
  openvdb::Mat4d m = openvdb::Mat4d::identity();
  for (int i = 0; i < 3; ++i) {
    const Vec3d& column = to_target.column(i);
    m.setRow(i, openvdb::Vec4d(column.x, column.y, column.z, 0));  // OpenVDB uses row vectors.
  }
  const Vec3d& o = to_target.origin();
  m.setRow(3, openvdb::Vec4d(o.x, o.y, o.z, 1));
  return m;
}

void scale_distances(openvdb::FloatGrid& grid, float by) {
  grid.setTree(grid.tree().copy());
  openvdb::tools::foreach (grid.beginValueAll(), [by](const auto& it) { it.setValue(*it * by); });
  // Inactive values are already scaled; only the background remains.
  grid.tree().root().setBackground(grid.background() * by, false);
}

}  // namespace

Grid converted(const Grid& grid, const Transform& to_target) {
  initialise_openvdb();
  const auto copy = openvdb::ConstPtrCast<openvdb::GridBase>(grid.data().grid->copyGrid());
  const openvdb::Mat4d before = copy->transform().baseMap()->getAffineMap()->getMat4();
  copy->setTransform(openvdb::math::Transform::createLinearTransform(before * matrix(to_target)));
  const double scale = to_target.max_stretch();
  if (copy->getGridClass() == openvdb::GRID_LEVEL_SET && copy->isType<openvdb::FloatGrid>() &&
      std::fabs(scale - 1) > 1e-12)
    scale_distances(static_cast<openvdb::FloatGrid&>(*copy), static_cast<float>(scale));
  return wrap(copy);
}

}  // namespace vug::volume
