#include <vug/render/guiding/guide.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace vug::render {
namespace {

/// A region is halved when so many paths came by: half of them still tell where light comes from.
constexpr uint64_t kManyRecords = 500;
constexpr uint64_t kFewRecords = 64;
constexpr int kDeepestRegion = 30, kDeepestSquare = 10;
/// Squares that hold more of a region's light than this are cut further.
constexpr double kShare = 0.01;

/// Worth is counted in steps of 2^-32 and cut at 2^16: what is brighter is no better known.
constexpr float kStep = 0x1p32f, kMostWorth = 0x1p16f;

/// A number in [0, 1) from the bits of a point, different for each `salt`.
float jitter(const Vec3f& point, uint64_t salt) {
  uint64_t bits = salt;
  for (int axis = 0; axis < 3; ++axis) {
    bits = (bits ^ std::bit_cast<uint32_t>(point[axis])) * 0xbf58476d1ce4e5b9ull;
    bits ^= bits >> 29;
  }
  return static_cast<float>(bits >> 40) * 0x1p-24f;
}

}  // namespace

Guide::Guide(const Box3f& bounds) : bounds_(bounds), nodes_(1), regions_(1) {
  if (bounds_.isEmpty()) bounds_ = Box3f(Vec3f(-1.0f), Vec3f(1.0f));
}

Guide::Place Guide::locate(const Vec3f& point) const {
  Vec3f size = bounds_.size(), within;
  for (int axis = 0; axis < 3; ++axis) {
    const float part = size[axis] > 0 ? (point[axis] - bounds_.min[axis]) / size[axis] : 0;
    within[axis] = std::clamp(part, 0.0f, 0.99999994f);
  }
  uint32_t node = 0;
  for (int axis = 0; nodes_[node].child; axis = axis == 2 ? 0 : axis + 1) {
    const bool upper = within[axis] >= 0.5f;
    within[axis] = 2 * within[axis] - (upper ? 1.0f : 0.0f);
    size[axis] *= 0.5f;
    node = nodes_[node].child + (upper ? 1u : 0u);
  }
  return {nodes_[node].region, size};
}

const DirectionTree* Guide::at(const Vec3f& point) const {
  const Region& region = regions_[locate(point).region];
  return region.known ? &region.directions : nullptr;
}

size_t Guide::bytes() const {
  size_t leaves = 0;
  for (const Region& region : regions_) leaves += region.directions.leaf_count();
  return nodes_.size() * sizeof(Node) + leaves * 8;
}

/// Halves the region of a leaf until each part expects few enough records; all begin with a copy.
void Guide::halve(uint32_t node, uint64_t records, int depth) {
  if (records <= kManyRecords || depth >= kDeepestRegion) return;
  const auto child = static_cast<uint32_t>(nodes_.size());
  const uint32_t region = nodes_[node].region;
  nodes_[node].child = child;
  nodes_.push_back({0, region});
  nodes_.push_back({0, static_cast<uint32_t>(regions_.size())});
  regions_.push_back(Region(regions_[region]));
  halve(child, records / 2, depth + 1);
  halve(child + 1, records / 2, depth + 1);
}

GuideTraining::GuideTraining(const Guide& last) : structure_(last) {
  size_t leaves = 0;
  for (Guide::Region& region : structure_.regions_) {
    if (region.known) region.directions = region.directions.recut(kShare, kDeepestSquare);
    first_.push_back(leaves);
    leaves += region.directions.leaf_count();
  }
  gathered_ = std::make_unique<std::atomic<int64_t>[]>(leaves);
  records_ = std::make_unique<std::atomic<uint64_t>[]>(first_.size());
}

void GuideTraining::record(const Vec3f& point, const Vec3f& direction, float worth) {
  // Moved by up to half a region, so that neighbours agree along their borders.
  const Vec3f size = structure_.locate(point).size;
  const Vec3f moved =
      point + Vec3f((jitter(point, 1) - 0.5f) * size.x, (jitter(point, 2) - 0.5f) * size.y,
                    (jitter(point, 3) - 0.5f) * size.z);
  const uint32_t region = structure_.locate(moved).region;
  records_[region].fetch_add(1, std::memory_order_relaxed);
  if (!(worth > 0)) return;
  const auto steps = static_cast<int64_t>(std::min(worth, kMostWorth) * kStep);
  const size_t leaf = structure_.regions_[region].directions.leaf(direction);
  gathered_[first_[region] + leaf].fetch_add(steps, std::memory_order_relaxed);
}

Guide GuideTraining::finish() const {
  Guide out = structure_;
  for (size_t i = 0; i < out.regions_.size(); ++i) {
    Guide::Region& region = out.regions_[i];
    std::vector<double> gathered(region.directions.leaf_count());
    double all = 0;
    for (size_t leaf = 0; leaf < gathered.size(); ++leaf)
      all += gathered[leaf] = static_cast<double>(gathered_[first_[i] + leaf].load());
    region.known = all > 0 && records_[i].load() >= kFewRecords;
    region.directions = region.directions.weighed(gathered);
  }
  const size_t nodes = out.nodes_.size();
  for (uint32_t node = 0; node < nodes; ++node)
    if (out.nodes_[node].child == 0) out.halve(node, records_[out.nodes_[node].region].load(), 0);
  return out;
}

}  // namespace vug::render
