// SPDX-License-Identifier: Apache-2.0
// Reads points from grids of any origin.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/io.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/points.h>

#include <fmt/format.h>
#include <openvdb/points/PointDataGrid.h>

#include <algorithm>

namespace vug::volume {
namespace {

namespace vp = openvdb::points;
using PointLeaf = vp::PointDataTree::LeafNodeType;

const vp::PointDataGrid& point_data(const Grid& grid) {
  if (!is_points(grid))
    throw Error(ErrorCode::bad_input,
                fmt::format("the grid '{}' does not contain points", grid.name()));
  return static_cast<const vp::PointDataGrid&>(*grid.data().grid);
}

/// The leaves of a tree and the number of points before each.
struct PointLeaves {
  explicit PointLeaves(const vp::PointDataGrid& grid) {
    grid.tree().getNodes(leaves);
    for (const PointLeaf* leaf : leaves) {
      leaf->validateOffsets();  // Throws if they exceed the attributes.
      begin.push_back(count);
      count += leaf->pointCount();
    }
  }
  /// Calls work(leaf, index of its first point) in parallel.
  template <class Work>
  void each(const Work& work) const {
    parallel_for(leaves.size(), [&](size_t n) { work(*leaves[n], begin[n]); });
  }

  std::vector<const PointLeaf*> leaves;
  std::vector<size_t> begin;
  size_t count = 0;
};

std::vector<Vec3f> positions(const vp::PointDataGrid& grid, const PointLeaves& leaves) {
  std::vector<Vec3f> out(leaves.count);
  leaves.each([&](const PointLeaf& leaf, size_t begin) {
    if (leaf.pointCount() == 0) return;
    const vp::AttributeHandle<openvdb::Vec3f> from(leaf.constAttributeArray("P"));
    for (auto voxel = leaf.cbeginValueOn(); voxel; ++voxel) {
      const openvdb::Vec3d corner = voxel.getCoord().asVec3d();
      const openvdb::Index first =
          voxel.pos() == 0 ? 0 : static_cast<openvdb::Index>(leaf.getValue(voxel.pos() - 1));
      const openvdb::Index end = leaf.getValue(voxel.pos());
      for (openvdb::Index i = first; i < end; ++i) {
        const openvdb::Vec3d p = grid.indexToWorld(corner + openvdb::Vec3d(from.get(i)));
        out[begin + i] =
            Vec3f(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
      }
    }
  });
  return out;
}

template <class T>
T plain(const T& value) {
  return value;
}
float plain(double value) { return static_cast<float>(value); }
int32_t plain(bool value) { return value ? 1 : 0; }
int32_t plain(int16_t value) { return value; }
int32_t plain(int8_t value) { return value; }
template <class T>
Vec3f plain(const openvdb::math::Vec3<T>& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

template <class From>
PointAttribute::Values values(const PointLeaves& leaves, size_t at) {
  std::vector<decltype(plain(From()))> out(leaves.count);
  leaves.each([&](const PointLeaf& leaf, size_t begin) {
    const vp::AttributeHandle<From> from(leaf.constAttributeArray(at));
    for (openvdb::Index i = 0; i < leaf.pointCount(); ++i) out[begin + i] = plain(from.get(i));
  });
  return out;
}

/// By OpenVDB's type names.
PointAttribute::Values values(const std::string& type, const PointLeaves& leaves, size_t at) {
  if (type == "float") return values<float>(leaves, at);
  if (type == "double") return values<double>(leaves, at);
  if (type == "vec3s") return values<openvdb::Vec3f>(leaves, at);
  if (type == "vec3d") return values<openvdb::Vec3d>(leaves, at);
  if (type == "int32") return values<int32_t>(leaves, at);
  if (type == "int16") return values<int16_t>(leaves, at);
  if (type == "int8") return values<int8_t>(leaves, at);
  if (type == "bool") return values<bool>(leaves, at);
  return {};
}

/// Names and positions in the attribute sets of a grid's leaves, in order of addition.
std::vector<std::pair<std::string, size_t>> slots(const vp::AttributeSet::Descriptor& descriptor) {
  std::vector<std::pair<std::string, size_t>> out(descriptor.map().begin(), descriptor.map().end());
  std::sort(out.begin(), out.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  return out;
}

bool is_group(const vp::AttributeSet::Descriptor& descriptor, size_t at) {
  return descriptor.type(at) == vp::GroupAttributeArray::attributeType();
}

std::vector<uint8_t> members(const PointLeaves& leaves, const std::string& name) {
  std::vector<uint8_t> out(leaves.count);
  leaves.each([&](const PointLeaf& leaf, size_t begin) {
    const vp::GroupHandle from = leaf.groupHandle(name);
    for (openvdb::Index i = 0; i < leaf.pointCount(); ++i) out[begin + i] = from.get(i) ? 1 : 0;
  });
  return out;
}

std::vector<std::string> group_names(const vp::AttributeSet::Descriptor& descriptor) {
  std::vector<std::string> out;
  for (const auto& [name, offset] : descriptor.groupMap()) out.push_back(name);
  std::sort(out.begin(), out.end());
  return out;
}

/// Converts OpenVDB's exceptions about inconsistent grids to our errors.
template <class Work>
auto with_points(const Grid& grid, const Work& work) {
  const vp::PointDataGrid& data = point_data(grid);
  try {
    return work(data, PointLeaves(data));
  } catch (const openvdb::Exception& fault) {
    throw Error(ErrorCode::bad_input,
                fmt::format("the points of '{}' are damaged: {}", grid.name(), fault.what()));
  }
}

Points all_of(const vp::PointDataGrid& data, const PointLeaves& leaves) {
  Points out;
  if (leaves.leaves.empty()) return out;
  out.position = positions(data, leaves);
  const vp::AttributeSet& set = leaves.leaves[0]->attributeSet();
  const vp::AttributeSet::Descriptor& descriptor = set.descriptor();
  for (const auto& [name, at] : slots(descriptor)) {
    if (name == "P" || is_group(descriptor, at) || set.getConst(at)->stride() != 1) continue;
    PointAttribute attribute{name, values(descriptor.type(at).first, leaves, at),
                             descriptor.type(at).second == vp::TruncateCodec::name()};
    if (attribute.size() == leaves.count) out.attributes.push_back(std::move(attribute));
  }
  for (const std::string& name : group_names(descriptor))
    out.groups.push_back({name, members(leaves, name)});
  return out;
}

PointsInfo info_of(const vp::PointDataGrid& data, const PointLeaves& leaves) {
  PointsInfo out;
  out.count = leaves.count;
  if (leaves.leaves.empty()) return out;
  for (const Vec3f& p : positions(data, leaves)) out.bounds.extendBy(Vec3d(p));
  const vp::AttributeSet::Descriptor& descriptor = leaves.leaves[0]->attributeSet().descriptor();
  for (const auto& [name, at] : slots(descriptor))
    if (!is_group(descriptor, at))
      out.attributes.push_back({name, descriptor.type(at).first, descriptor.type(at).second});
  for (const std::string& name : group_names(descriptor)) {
    const std::vector<uint8_t> member = members(leaves, name);
    const auto inside = std::count(member.begin(), member.end(), uint8_t{1});
    out.groups.push_back({name, static_cast<uint64_t>(inside)});
  }
  return out;
}

}  // namespace

bool is_points(const Grid& grid) { return grid.data().grid->isType<vp::PointDataGrid>(); }

Points points(const Grid& grid) { return with_points(grid, all_of); }

Points read_points(const std::filesystem::path& source, const std::string& name) {
  if (!name.empty()) return points(read_grid(source, name));
  for (const Grid& grid : read(source))
    if (is_points(grid)) return points(grid);
  throw Error(ErrorCode::bad_input, fmt::format("'{}' does not contain points", source.string()));
}

PointsInfo points_info(const Grid& grid) { return with_points(grid, info_of); }

}  // namespace vug::volume
