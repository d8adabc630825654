#include <vug/render/guiding/chances.h>

#include <algorithm>

namespace vug::render {
namespace {

/// Glances that the mean over all regions counts for in each.
constexpr float kPrior = 2;

}  // namespace

Chances::Chances(const Box3f& bounds, float edge, size_t things, const std::vector<Glance>& glances)
    : bounds_(bounds), regions_per_metre_(1 / edge), things_(things) {
  size_t regions = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const float size = bounds.size()[axis] * regions_per_metre_;
    const int count = std::max(1, static_cast<int>(std::ceil(size)));
    regions_[static_cast<size_t>(axis)] = count;
    regions *= static_cast<size_t>(count);
  }
  row_of_.assign(regions, 0);
  std::vector<float> reached(things, 0), tried(things, 0);
  for (const Glance& glance : glances) {
    uint32_t& row = row_of_[region(glance.from)];
    if (row == 0) {
      row = static_cast<uint32_t>(reached.size() / things);
      reached.resize(reached.size() + things, 0), tried.resize(tried.size() + things, 0);
    }
    for (const size_t at : {size_t{glance.at}, row * things + glance.at}) {
      tried[at] += 1;
      reached[at] += glance.reached ? 1.0f : 0.0f;
    }
  }
  roots_.resize(reached.size());
  for (size_t thing = 0; thing < things; ++thing) {
    const float usual = (reached[thing] + 1) / (tried[thing] + 2);
    roots_[thing] = std::sqrt(usual);
    for (size_t at = things + thing; at < roots_.size(); at += things)
      roots_[at] = std::sqrt((reached[at] + kPrior * usual) / (tried[at] + kPrior));
  }
}

size_t Chances::region(const Vec3f& point) const {
  size_t index = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const int count = regions_[static_cast<size_t>(axis)];
    const float along = std::floor((point[axis] - bounds_.min[axis]) * regions_per_metre_);
    const float kept = std::clamp(along, 0.0f, static_cast<float>(count - 1));
    index = index * static_cast<size_t>(count) + static_cast<size_t>(kept);
  }
  return index;
}

}  // namespace vug::render
