#include <vug/volume/grid_access.h>
#include <vug/volume/placed.h>

#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/ValueTransformer.h>

namespace vug::volume {
namespace {

openvdb::Mat4d matrix(const Transform& way) {
  openvdb::Mat4d m = openvdb::Mat4d::identity();
  for (int i = 0; i < 3; ++i) {
    const Vec3d& column = way.column(i);
    m.setRow(i, openvdb::Vec4d(column.x, column.y, column.z, 0));  // points are rows
  }
  const Vec3d& o = way.origin();
  m.setRow(3, openvdb::Vec4d(o.x, o.y, o.z, 1));
  return m;
}

void scale_distances(openvdb::FloatGrid& grid, float by) {
  grid.setTree(grid.tree().copy());
  openvdb::tools::foreach (grid.beginValueAll(), [by](const auto& it) { it.setValue(*it * by); });
  // Inactive values have grown already: the background alone is left.
  grid.tree().root().setBackground(grid.background() * by, false);
}

}  // namespace

Grid placed(const Grid& grid, const Transform& way) {
  initialise_openvdb();
  const auto copy = openvdb::ConstPtrCast<openvdb::GridBase>(grid.data().grid->copyGrid());
  const openvdb::Mat4d before = copy->transform().baseMap()->getAffineMap()->getMat4();
  copy->setTransform(openvdb::math::Transform::createLinearTransform(before * matrix(way)));
  const double scale = way.max_stretch();
  if (copy->getGridClass() == openvdb::GRID_LEVEL_SET && copy->isType<openvdb::FloatGrid>() &&
      std::fabs(scale - 1) > 1e-12)
    scale_distances(static_cast<openvdb::FloatGrid&>(*copy), static_cast<float>(scale));
  return wrap(copy);
}

}  // namespace vug::volume
