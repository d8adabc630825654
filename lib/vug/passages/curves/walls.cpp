// SPDX-License-Identifier: Apache-2.0
#include <vug/passages/curves/walls.h>

#include <algorithm>
#include <optional>

namespace vug::passages {
namespace {

using Distances = std::vector<std::optional<double>>;

/// Fills the gaps of a quantity that is known at some positions along the chain.
std::vector<double> without_gaps(const std::vector<double>& along, const Distances& known,
                                 double fallback) {
  std::vector<double> out(known.size(), fallback);
  size_t before = known.size(), after = 0;
  for (size_t i = 0; i < known.size(); ++i) {
    if (known[i]) {
      before = i;
      out[i] = *known[i];
      continue;
    }
    after = std::max(after, i);
    while (after < known.size() && !known[after]) ++after;
    const bool has_before = before < i, has_after = after < known.size();
    if (has_before && has_after) {
      const double span = along[after] - along[before];
      const double t = span > 0 ? (along[i] - along[before]) / span : 0.5;
      out[i] = *known[before] + (*known[after] - *known[before]) * t;
    } else if (has_before || has_after) {
      out[i] = *known[has_before ? before : after];
    }
  }
  return out;
}

/// Whether the section of the chain's i-th station looks against the chain's direction.
bool reversed(const network::Network& network, const Chain& chain, size_t i) {
  const size_t leg = i < chain.legs.size() ? i : i - 1;
  const network::Leg& l = network.legs[static_cast<size_t>(chain.legs[leg])];
  const Vec3d from = network.stations[static_cast<size_t>(l.from)].position;
  const Vec3d at = network.stations[static_cast<size_t>(chain.stations[leg])].position;
  return from != at;
}

}  // namespace

std::vector<Walls> walls_along(const network::Network& network, const Chain& chain,
                               const DefaultSize& size) {
  const size_t n = chain.stations.size();
  std::vector<double> along(n, 0);
  Distances left(n), right(n), up(n), down(n);
  const auto section = [&](size_t i) {
    return network.stations[static_cast<size_t>(chain.stations[i])].section;
  };
  bool own = false;
  for (size_t i = 0; i < n; ++i) own = own || (!chain.meets_at(i) && section(i));
  for (size_t i = 0; i < n; ++i) {
    const auto position = [&](size_t k) {
      return network.stations[static_cast<size_t>(chain.stations[k])].position;
    };
    if (i > 0) along[i] = along[i - 1] + (position(i) - position(i - 1)).length();
    const auto walls = section(i);
    if (!walls || (own && chain.meets_at(i))) continue;
    const bool back = reversed(network, chain, i);
    left[i] = back ? walls->right : walls->left;
    right[i] = back ? walls->left : walls->right;
    up[i] = walls->up;
    down[i] = walls->down;
  }
  const std::vector<double> l = without_gaps(along, left, 0.5 * size.width),
                            r = without_gaps(along, right, 0.5 * size.width),
                            u = without_gaps(along, up, 0.5 * size.height),
                            d = without_gaps(along, down, 0.5 * size.height);
  std::vector<Walls> out;
  for (size_t i = 0; i < n; ++i) {
    Walls walls{l[i], r[i], u[i], d[i], left[i] || right[i] || up[i] || down[i]};
    const double wider = 0.5 * std::max(0.0, size.least - walls.width());
    const double higher = 0.5 * std::max(0.0, size.least - walls.height());
    walls.left += wider;
    walls.right += wider;
    walls.up += higher;
    walls.down += higher;
    out.push_back(walls);
  }
  return out;
}

}  // namespace vug::passages
