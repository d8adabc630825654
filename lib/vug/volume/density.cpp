#include <vug/base/error.h>
#include <vug/volume/density.h>
#include <vug/volume/grid_access.h>

#include <fmt/format.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::volume {
namespace {

using openvdb::Coord;

}  // namespace

Density::Density(const Grid& source, int part) {
  const openvdb::GridBase* grid = source.data().grid.get();
  if (const auto* floats = dynamic_cast<const openvdb::FloatGrid*>(grid))
    fill(*floats, source.name(), [](float value) { return value; });
  else if (const auto* vectors = dynamic_cast<const openvdb::Vec3SGrid*>(grid))
    fill(*vectors, source.name(), [part](const openvdb::Vec3s& value) { return value[part]; });
  else
    throw Error(ErrorCode::bad_input,
                fmt::format("the grid '{}' holds {}, not floats or vectors of floats",
                            source.name(), source.value_type()));
}

template <class Source, class Value>
void Density::fill(const Source& grid, const std::string& name, const Value& value_of) {
  background_ = std::max(value_of(grid.background()), 0.0f);
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  bounds_.makeEmpty();
  if (box.empty()) return;
  // A voxel reaches half-way, by interpolation, to all of its neighbours.
  const Coord origin = box.min() - Coord(1);
  const Coord size = box.max() - origin + Coord(2);
  bricks_ = {(size.x() + kSize - 1) / kSize, (size.y() + kSize - 1) / kSize,
             (size.z() + kSize - 1) / kSize};
  size_ = Vec3f(bricks_ * kSize);
  row_ = static_cast<size_t>(bricks_.x) + 2;
  plane_ = row_ * (static_cast<size_t>(bricks_.y) + 2);
  slots_.assign(plane_ * (static_cast<size_t>(bricks_.z) + 2), -1);
  ranges_.assign(slots_.size(), Range{});
  const openvdb::Mat4R matrix = grid.transform().baseMap()->getAffineMap()->getMat4().inverse();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) world_to_index_[row][column] = matrix(row, column);
  for (int axis = 0; axis < 3; ++axis)
    world_to_index_[3][axis] -= origin[static_cast<size_t>(axis)];
  const auto accessor = grid.getConstAccessor();
  for (int z = 0; z < bricks_.z; ++z)
    for (int y = 0; y < bricks_.y; ++y)
      for (int x = 0; x < bricks_.x; ++x) {
        const Coord first = origin + Coord(x * kSize, y * kSize, z * kSize);
        Brick brick;
        Range range{std::numeric_limits<float>::infinity(), 0, 0};
        size_t i = 0;
        for (int k = 0; k < kStride; ++k)
          for (int j = 0; j < kStride; ++j)
            for (int n = 0; n < kStride; ++n) {
              const float value = value_of(accessor.getValue(first + Coord(n, j, k)));
              if (!std::isfinite(value))
                throw Error(ErrorCode::bad_input,
                            fmt::format("the grid '{}' holds values that are not finite", name));
              brick[i] = std::max(value, 0.0f);
              range.least = std::min(range.least, brick[i]);
              range.mean += brick[i] / static_cast<float>(brick.size());
              range.most = std::max(range.most, brick[i++]);
            }
        if (!(range.most > 0)) continue;
        range.mean = std::clamp(range.mean, range.least, range.most);
        slots_[brick_index({x, y, z})] = static_cast<int32_t>(values_.size());
        ranges_[brick_index({x, y, z})] = range;
        values_.push_back(brick);
        for (int corner = 0; corner < 8; ++corner) {
          const openvdb::Vec3d at = grid.indexToWorld(openvdb::Vec3d(
              first.x() + (corner & 1 ? kSize : 0), first.y() + (corner & 2 ? kSize : 0),
              first.z() + (corner & 4 ? kSize : 0)));
          bounds_.extendBy(Vec3f(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                 static_cast<float>(at.z())));
        }
      }
}

Vec3f Density::to_index(const Vec3f& world) const {
  Vec3d out(world_to_index_[3][0], world_to_index_[3][1], world_to_index_[3][2]);
  for (int axis = 0; axis < 3; ++axis)
    for (int from = 0; from < 3; ++from)
      out[axis] += static_cast<double>(world[from]) * world_to_index_[from][axis];
  return Vec3f(out);
}

Vec3f Density::direction_to_index(const Vec3f& world) const {
  Vec3d out;
  world_to_index_.multDirMatrix(Vec3d(world), out);
  return Vec3f(out);
}

float Density::at(const Vec3f& p) const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= 0 && p[axis] < size_[axis])) return 0;
  const Vec3i cell(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  const Vec3i brick(cell.x / kSize, cell.y / kSize, cell.z / kSize);
  const int32_t slot = slots_[brick_index(brick)];
  if (slot < 0) return 0;
  const Vec3i in = cell - brick * kSize;
  const float* v =
      values_[static_cast<size_t>(slot)].data() + (in.z * kStride + in.y) * kStride + in.x;
  const Vec3f f = p - Vec3f(cell);
  const auto along_x = [&](const float* row) { return row[0] + f.x * (row[1] - row[0]); };
  const auto in_plane = [&](const float* plane) {
    const float a = along_x(plane), b = along_x(plane + kStride);
    return a + f.y * (b - a);
  };
  const float a = in_plane(v), b = in_plane(v + kStride * kStride);
  return a + f.z * (b - a);
}

float Density::anywhere(const Vec3f& world) const {
  const Vec3f p = to_index(world);
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= 0 && p[axis] < size_[axis])) return background_;
  return at(p);
}

uint64_t Density::bytes() const {
  return values_.size() * sizeof(Brick) + slots_.size() * (sizeof(int32_t) + sizeof(Range));
}

}  // namespace vug::volume
