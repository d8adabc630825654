#include <vug/render/guiding/visibility_cache.h>

namespace vug::render {
namespace {

/// Glances that the mean over all regions counts for in each.
constexpr float kPrior = 2;

}  // namespace

Chances::Chances(const Box3f& bounds, float edge, size_t things, const std::vector<Glance>& glances)
    : regions_(bounds, edge), things_(things) {
  row_of_.assign(regions_.count(), 0);
  std::vector<float> reached(things, 0), tried(things, 0);
  for (const Glance& glance : glances) {
    uint32_t& row = row_of_[regions_.at(glance.from)];
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

}  // namespace vug::render
