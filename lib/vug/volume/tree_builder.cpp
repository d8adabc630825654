// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/openvdb_values.h>
#include <vug/volume/tree_builder.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <mutex>

namespace vug::volume {
namespace {

using Upper = openvdb::FloatTree::RootNodeType::ChildNodeType;  // 4096^3 voxels
using Lower = Upper::ChildNodeType;                             // 128^3
static_assert(Upper::DIM == 4096 && Lower::DIM == Brick::kSize);

openvdb::Coord coord(const Cell& cell) {
  return {static_cast<int>(cell.origin[0]), static_cast<int>(cell.origin[1]),
          static_cast<int>(cell.origin[2])};
}

}  // namespace

struct Brick::Slots {
  std::array<std::unique_ptr<Lower::ChildNodeType>, 4096> leaf;
  std::array<bool, 4096> inside{};
};

Brick::Brick(const Cell& cell) : cell_(cell), slots_(new Slots) {}

Brick::~Brick() = default;

size_t Brick::slot(const Cell& cell) const {
  size_t n = 0;
  for (int axis = 0; axis < 3; ++axis)
    n = 16 * n + static_cast<size_t>(cell.origin[axis] - cell_.origin[axis]) / 8;
  return n;
}

void Brick::set(const Cell& cell, const Block& block) {
  auto leaf = std::make_unique<Lower::ChildNodeType>(openvdb::PartialCreate(), coord(cell));
  leaf->buffer().allocate();
  std::memcpy(leaf->buffer().data(), block.values, sizeof block.values);
  for (int x = 0; x < 8; ++x)
    leaf->getValueMask().getWord<uint64_t>(static_cast<openvdb::Index>(x)) = block.active[x];
  slots_->leaf[slot(cell)] = std::move(leaf);
}

void Brick::fill_inside(const Cell& cell) {
  const auto count = static_cast<size_t>(cell.size / 8);
  const size_t first = slot(cell);
  for (size_t x = 0; x < count; ++x)
    for (size_t y = 0; y < count; ++y)
      std::fill_n(slots_->inside.begin() + static_cast<ptrdiff_t>(first + 256 * x + 16 * y), count,
                  true);
}

struct TreeBuilder::Impl {
  openvdb::FloatGrid::Ptr grid;
  float background = 0;
  std::mutex mutex;
  std::map<openvdb::Coord, std::unique_ptr<Upper>> uppers;

  Upper& upper(const openvdb::Coord& at) {
    const openvdb::Coord origin = at & ~static_cast<int>(Upper::DIM - 1);
    std::unique_ptr<Upper>& node = uppers[origin];
    if (!node) node = std::make_unique<Upper>(origin, background, false);
    return *node;
  }
};

TreeBuilder::TreeBuilder(double voxel, float background) : impl_(new Impl) {
  initialise_openvdb();
  impl_->background = background;
  impl_->grid = openvdb::FloatGrid::create(background);
  impl_->grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  impl_->grid->setGridClass(openvdb::GRID_LEVEL_SET);
}

TreeBuilder::~TreeBuilder() = default;

void TreeBuilder::add(Brick& brick) {
  auto node = std::make_unique<Lower>(coord(brick.cell_), impl_->background, false);
  bool any = false;
  Brick::Slots& slots = *brick.slots_;
  for (size_t n = 0; n < slots.leaf.size(); ++n) {
    any = any || slots.leaf[n] || slots.inside[n];
    if (slots.inside[n]) node->addTile(static_cast<openvdb::Index>(n), -impl_->background, false);
    if (slots.leaf[n]) node->addChild(slots.leaf[n].release());
  }
  if (!any) return;
  const std::lock_guard lock(impl_->mutex);
  impl_->upper(node->origin()).addChild(node.release());
}

void TreeBuilder::fill_inside(const Cell& cell) {
  const std::lock_guard lock(impl_->mutex);
  const int64_t step = cell.size < Upper::DIM ? Brick::kSize : Upper::DIM;
  for (int64_t x = 0; x < cell.size; x += step)
    for (int64_t y = 0; y < cell.size; y += step)
      for (int64_t z = 0; z < cell.size; z += step) {
        const openvdb::Coord at =
            coord(cell).offsetBy(static_cast<int>(x), static_cast<int>(y), static_cast<int>(z));
        if (step == Upper::DIM)
          impl_->grid->tree().root().addTile(at, -impl_->background, false);
        else
          impl_->upper(at).addTile(Upper::coordToOffset(at), -impl_->background, false);
      }
}

std::shared_ptr<openvdb::GridBase> TreeBuilder::finish() {
  for (auto& [origin, node] : impl_->uppers) impl_->grid->tree().root().addChild(node.release());
  return impl_->grid;
}

}  // namespace vug::volume
