// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/volume/density.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::volume {
namespace {

using openvdb::Coord;

constexpr float kSteps = 65535;
constexpr int kLargest = 64;  // Voxels along a brick.

/// Range of the values in one brick of a block, including the first values of the next brick.
MajorantGrid::Range range_of(const std::vector<float>& block, int stride, const Vec3i& first,
                             int size) {
  MajorantGrid::Range range{std::numeric_limits<float>::infinity(), 0, 0};
  double sum = 0;
  for (int z = first.z; z <= first.z + size; ++z)
    for (int y = first.y; y <= first.y + size; ++y)
      for (int x = first.x; x <= first.x + size; ++x) {
        const float value = block[static_cast<size_t>((z * stride + y) * stride + x)];
        range.min = std::min(range.min, value);
        range.max = std::max(range.max, value);
        sum += static_cast<double>(value);
      }
  const int side = size + 1;
  range.mean = std::clamp(static_cast<float>(sum / (side * side * side)), range.min, range.max);
  return range;
}

}  // namespace

Density::Density(const Grid& source, int part) {
  const openvdb::GridBase* grid = source.data().grid.get();
  if (const auto* floats = dynamic_cast<const openvdb::FloatGrid*>(grid))
    fill(*floats, source.name(), [](float value) { return value; });
  else if (const auto* vectors = dynamic_cast<const openvdb::Vec3SGrid*>(grid))
    fill(*vectors, source.name(), [part](const openvdb::Vec3s& value) { return value[part]; });
  else
    throw Error(ErrorCode::bad_input,
                fmt::format("the grid '{}' contains {}, not floats or vectors of floats",
                            source.name(), source.value_type()));
}

template <class Source, class Value>
void Density::fill(const Source& grid, const std::string& name, const Value& value_of) {
  background_ = std::max(value_of(grid.background()), 0.0f);
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  bounds_.makeEmpty();
  if (box.empty()) return;
  // By interpolation, a voxel affects the space up to all of its neighbours.
  const Coord origin = box.min() - Coord(1);
  const Coord size = box.max() - origin + Coord(2);
  const Vec3i reach(size.x(), size.y(), size.z());
  size_ = Vec3f(reach);
  const Vec3i blocks = (reach + Vec3i(kSize - 1)) / kSize;
  row_ = static_cast<size_t>(blocks.x) + 1;
  plane_ = row_ * (static_cast<size_t>(blocks.y) + 1);
  blocks_.resize(plane_ * (static_cast<size_t>(blocks.z) + 1));
  const openvdb::Mat4R matrix = grid.transform().baseMap()->getAffineMap()->getMat4().inverse();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) world_to_index_[row][column] = matrix(row, column);
  for (int axis = 0; axis < 3; ++axis)
    world_to_index_[3][axis] -= origin[static_cast<size_t>(axis)];
  const auto accessor = grid.getConstAccessor();
  std::vector<float> own(std::tuple_size_v<Values>);
  MajorantGrid finest(kSize / 2, reach);
  for (int z = 0; z < blocks.z; ++z)
    for (int y = 0; y < blocks.y; ++y)
      for (int x = 0; x < blocks.x; ++x) {
        const Coord first = origin + Coord(x * kSize, y * kSize, z * kSize);
        size_t i = 0;
        for (int k = 0; k < kStride; ++k)
          for (int j = 0; j < kStride; ++j)
            for (int n = 0; n < kStride; ++n) {
              const float value = value_of(accessor.getValue(first + Coord(n, j, k)));
              if (!std::isfinite(value))
                throw Error(ErrorCode::bad_input,
                            fmt::format("the grid '{}' contains values that are not finite", name));
              own[i++] = std::max(value, 0.0f);
            }
        const auto [low, high] = std::minmax_element(own.begin(), own.end());
        if (!(*high > 0)) continue;
        Block& block = blocks_[static_cast<size_t>(x) + row_ * static_cast<size_t>(y) +
                               plane_ * static_cast<size_t>(z)];
        block = {*low, (*high - *low) / kSteps, static_cast<int32_t>(values_.size())};
        Values& values = values_.emplace_back();
        for (i = 0; i < own.size(); ++i) {
          const float steps = block.step > 0 ? (own[i] - block.least) / block.step : 0;
          values[i] = static_cast<uint16_t>(std::min(std::round(steps), kSteps));
          own[i] = block.least + block.step * values[i];
        }
        for (int part = 0; part < 8; ++part) {
          const Vec3i half(part & 1, part >> 1 & 1, part >> 2), brick = Vec3i(x, y, z) * 2 + half;
          const MajorantGrid::Range range = range_of(own, kStride, half * (kSize / 2), kSize / 2);
          if (brick.x >= finest.count().x || brick.y >= finest.count().y ||
              brick.z >= finest.count().z || !(range.max > 0))
            continue;
          finest.set(brick, range);
          for (int corner = 0; corner < 8; ++corner) {
            const Vec3i at = (brick + Vec3i(corner & 1, corner >> 1 & 1, corner >> 2)) * kSize / 2;
            const openvdb::Vec3d world =
                grid.indexToWorld((origin + Coord(std::min(at.x, reach.x), std::min(at.y, reach.y),
                                                  std::min(at.z, reach.z)))
                                      .asVec3d());
            bounds_.extendBy(Vec3f(static_cast<float>(world.x()), static_cast<float>(world.y()),
                                   static_cast<float>(world.z())));
          }
        }
      }
  majorants_.push_back(std::move(finest));
  while (majorants_.back().size() < kLargest) majorants_.push_back(majorants_.back().doubled());
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

bool Density::within(const Vec3f& p) const {
  return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size_.x && p.y < size_.y && p.z < size_.z;
}

float Density::at(const Vec3f& p) const {
  if (!within(p)) return 0;
  const Vec3i cell(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  const Block& b = block(cell / kSize);
  if (b.slot < 0) return 0;
  const uint16_t* v = cell_of(b, cell);
  const Vec3f f = p - Vec3f(cell);
  const auto along_x = [&](const uint16_t* row) {
    const float first = row[0], second = row[1];
    return first + f.x * (second - first);
  };
  const auto in_plane = [&](const uint16_t* plane) {
    const float first = along_x(plane), second = along_x(plane + kStride);
    return first + f.y * (second - first);
  };
  const float first = in_plane(v), second = in_plane(v + kStride * kStride);
  return b.least + b.step * (first + f.z * (second - first));
}

void Density::prefetch(const Vec3f& p) const {
  if (!within(p)) return;
  const Vec3i cell(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  const Block& b = block(cell / kSize);
  if (b.slot < 0) return;
  const uint16_t* v = cell_of(b, cell);
  for (const int row : {0, kStride, kStride * kStride, kStride * kStride + kStride})
    __builtin_prefetch(v + row);
}

float Density::at_world(const Vec3f& world) const {
  const Vec3f p = to_index(world);
  return within(p) ? at(p) : background_;
}

uint64_t Density::bytes() const {
  uint64_t sum = values_.size() * sizeof(Values) + blocks_.size() * sizeof(Block);
  for (const MajorantGrid& bricks : majorants_) sum += bricks.bytes();
  return sum;
}

}  // namespace vug::volume
