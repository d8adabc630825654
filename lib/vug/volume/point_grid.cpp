// SPDX-License-Identifier: Apache-2.0
// Points with attributes as an OpenVDB grid of points.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/points.h>

#include <fmt/format.h>
#include <openvdb/points/PointAttribute.h>
#include <openvdb/points/PointDataGrid.h>
#include <openvdb/points/PointGroup.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::volume {
namespace {

namespace vp = openvdb::points;
using PointTree = vp::PointDataTree;
using PointLeaf = PointTree::LeafNodeType;
using Stored = vp::FixedPointCodec<false, vp::PositionRange>;

constexpr int kMostVoxels =
    1 << 30;  ///< From the origin, so that sums of indices fit into 32 bits.

/// Sort key of a point: leaf by first voxel, then voxel, then input order.
struct Slot {
  uint64_t leaf_high = 0;  ///< x and y of the leaf.
  uint32_t leaf_low = 0;   ///< z of the leaf.
  uint32_t point = 0;
  uint32_t voxel = 0;

  bool same_leaf(const Slot& o) const { return leaf_high == o.leaf_high && leaf_low == o.leaf_low; }
  bool operator<(const Slot& o) const {
    if (leaf_high != o.leaf_high) return leaf_high < o.leaf_high;
    if (leaf_low != o.leaf_low) return leaf_low < o.leaf_low;
    return voxel != o.voxel ? voxel < o.voxel : point < o.point;
  }
};

void check(const Points& points, double voxel) {
  if (!(voxel > 0) || !std::isfinite(voxel))
    throw Error(ErrorCode::bad_input, "the voxel size of points must be above 0");
  if (points.size() > 0xffffffffu)
    throw Error(ErrorCode::too_large, "too many points for 32-bit indices");
  std::set<std::string> names{"P"}, groups;
  const auto check_one = [&](const std::string& name, size_t size, std::set<std::string>& known,
                             const char* what) {
    if (!vp::AttributeSet::Descriptor::validName(name))
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' is not a valid name for {} of points", name, what), {},
                  "names have letters, digits and _");
    if (!known.insert(name).second)
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' is the name of {} of points twice", name, what));
    if (size != points.size())
      throw Error(ErrorCode::internal, fmt::format("'{}' does not have one value per point", name));
  };
  for (const PointAttribute& each : points.attributes)
    check_one(each.name, each.size(), names, "an attribute");
  for (const PointGroup& each : points.groups)
    check_one(each.name, each.member.size(), groups, "a group");
  const auto bound = static_cast<float>(kMostVoxels * voxel);
  const auto near = [&](float x) { return std::fabs(x) < bound; };  // False for NaN.
  const auto bad = ordered_sum(points.size(), size_t{0}, [&](size_t i) -> size_t {
    const Vec3f& p = points.position[i];
    return near(p.x) && near(p.y) && near(p.z) ? 0 : 1;
  });
  if (bad > 0)
    throw Error(ErrorCode::bad_input,
                fmt::format("{} points are not finite, or too far away for voxels of {:.4g} m", bad,
                            voxel));
}

openvdb::Vec3d index_of(const Vec3f& p, double voxel) {
  return {static_cast<double>(p.x) / voxel, static_cast<double>(p.y) / voxel,
          static_cast<double>(p.z) / voxel};
}

std::vector<Slot> sorted_slots(const Points& points, double voxel) {
  std::vector<Slot> slots(points.size());
  parallel_for(
      points.size(),
      [&](size_t i) {
        const openvdb::Coord at = openvdb::Coord::round(index_of(points.position[i], voxel));
        const auto part = [&](int axis) {  // Increases with the coordinate.
          return static_cast<uint32_t>((at[static_cast<size_t>(axis)] >> PointLeaf::LOG2DIM) +
                                       kMostVoxels);
        };
        slots[i] = {uint64_t{part(0)} << 32 | part(1), part(2), static_cast<uint32_t>(i),
                    PointLeaf::coordToOffset(at)};
      },
      4096);
  parallel_sort(slots.begin(), slots.end());
  return slots;
}

/// A leaf and its points: slots begin .. end - 1.
struct LeafPoints {
  PointLeaf* leaf = nullptr;
  size_t begin = 0, end = 0;
};

std::vector<LeafPoints> make_leaves(PointTree& tree, const std::vector<Slot>& slots,
                                    const Points& points, double voxel) {
  std::vector<LeafPoints> parts;
  for (size_t i = 0; i < slots.size(); ++i)
    if (i == 0 || !slots[i].same_leaf(slots[i - 1])) {
      if (i > 0) parts.back().end = i;
      parts.push_back({nullptr, i, slots.size()});
    }
  const auto descriptor = vp::AttributeSet::Descriptor::create(
      vp::TypedAttributeArray<openvdb::Vec3f, Stored>::attributeType());
  std::vector<std::unique_ptr<PointLeaf>> leaves(parts.size());
  {
    const vp::AttributeArray::ScopedRegistryLock lock;
    parallel_for(parts.size(), [&](size_t n) {
      const LeafPoints& part = parts[n];
      const openvdb::Vec3d first = index_of(points.position[slots[part.begin].point], voxel);
      auto leaf = std::make_unique<PointLeaf>(openvdb::Coord::round(first));
      std::vector<PointLeaf::ValueType> ends(PointLeaf::SIZE);
      size_t next = part.begin;
      for (openvdb::Index v = 0; v < PointLeaf::SIZE; ++v) {
        while (next < part.end && slots[next].voxel <= v) ++next;
        ends[v] = static_cast<openvdb::Index32>(next - part.begin);
      }
      const auto count = static_cast<openvdb::Index>(part.end - part.begin);
      leaf->initializeAttributes(descriptor, count, &lock);
      leaf->setOffsets(ends);
      vp::AttributeWriteHandle<openvdb::Vec3f, Stored> to(leaf->attributeArray(0));
      for (openvdb::Index k = 0; k < count; ++k) {
        const openvdb::Vec3d at = index_of(points.position[slots[part.begin + k].point], voxel);
        // The codec truncates; adding half a step makes it round.
        const openvdb::Vec3d half_step(0.5 / 65535);
        to.set(k, openvdb::Vec3f(at - openvdb::Coord::round(at).asVec3d() + half_step));
      }
      leaves[n] = std::move(leaf);
    });
  }
  for (size_t n = 0; n < parts.size(); ++n) {
    parts[n].leaf = leaves[n].get();
    tree.addLeaf(leaves[n].release());
  }
  return parts;
}

bool fits_half(float x) { return std::fabs(x) <= 65504 || !std::isfinite(x); }
bool fits_half(const Vec3f& v) { return fits_half(v.x) && fits_half(v.y) && fits_half(v.z); }

template <class Codec, class T>
void add_attribute(PointTree& tree, const std::vector<LeafPoints>& parts,
                   const std::vector<Slot>& slots, const std::string& name,
                   const std::vector<T>& values) {
  using Value = decltype(stored(values[0]));
  vp::appendAttribute(tree, name, vp::TypedAttributeArray<Value, Codec>::attributeType());
  parallel_for(parts.size(), [&](size_t n) {
    const LeafPoints& part = parts[n];
    vp::AttributeArray& array = part.leaf->attributeArray(name);
    vp::AttributeWriteHandle<Value, Codec> to(array);
    for (size_t k = part.begin; k < part.end; ++k)
      to.set(static_cast<openvdb::Index>(k - part.begin), stored(values[slots[k].point]));
    to.compact();
  });
}

void add_attribute(PointTree& tree, const std::vector<LeafPoints>& parts,
                   const std::vector<Slot>& slots, const PointAttribute& attribute) {
  const std::string& name = attribute.name;
  if (const auto* whole = std::get_if<std::vector<int32_t>>(&attribute.values))
    return add_attribute<vp::NullCodec>(tree, parts, slots, name, *whole);
  const auto add = [&](const auto& values) {
    const auto fits = [](const auto& v) { return fits_half(v); };
    if (attribute.half && std::all_of(values.begin(), values.end(), fits))
      add_attribute<vp::TruncateCodec>(tree, parts, slots, name, values);
    else
      add_attribute<vp::NullCodec>(tree, parts, slots, name, values);
  };
  if (const auto* numbers = std::get_if<std::vector<float>>(&attribute.values))
    add(*numbers);
  else
    add(std::get<std::vector<Vec3f>>(attribute.values));
}

void add_groups(PointTree& tree, const std::vector<LeafPoints>& parts,
                const std::vector<Slot>& slots, const std::vector<PointGroup>& groups) {
  for (const PointGroup& group : groups) vp::appendGroup(tree, group.name);
  parallel_for(parts.size(), [&](size_t n) {
    const LeafPoints& part = parts[n];
    for (const PointGroup& group : groups) {
      vp::GroupWriteHandle to = part.leaf->groupWriteHandle(group.name);
      for (size_t k = part.begin; k < part.end; ++k)
        to.set(static_cast<openvdb::Index>(k - part.begin), group.member[slots[k].point] != 0);
    }
    vp::AttributeSet& set = const_cast<vp::AttributeSet&>(part.leaf->attributeSet());
    for (size_t i = 0; i < set.size(); ++i)
      if (vp::isGroup(*set.getConst(i))) set.get(i)->compact();
  });
}

}  // namespace

Grid point_grid(const Points& points, double voxel) {
  initialise_openvdb();
  check(points, voxel);
  const auto grid = vp::PointDataGrid::create();
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  const std::vector<Slot> slots = sorted_slots(points, voxel);
  const std::vector<LeafPoints> parts = make_leaves(grid->tree(), slots, points, voxel);
  if (!parts.empty()) {
    for (const PointAttribute& each : points.attributes)
      add_attribute(grid->tree(), parts, slots, each);
    add_groups(grid->tree(), parts, slots, points.groups);
  }
  return wrap(grid);
}

}  // namespace vug::volume
