// SPDX-License-Identifier: Apache-2.0
#include <vug/survey/blunders.h>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

constexpr double kSignificant = 3;
constexpr size_t kMost = 5;

/// An error of one reading: the change of the leg's vector for one unit of the reading.
struct Hypothesis {
  const char* reading;
  Eigen::Vector3d change;
  double least, most;  ///< The errors that are possible: an angle is at most half a turn off.
};

/// The errors that a leg can have. A reading in radians changes it in proportion to its length.
std::vector<Hypothesis> hypotheses(const ObservedLeg& leg, const Eigen::Vector3d& misclosure) {
  const Eigen::Vector3d v = as_eigen(leg.vector);
  const double length = v.norm(), flat = std::hypot(v.x(), v.y());
  std::vector<Hypothesis> all;
  if (leg.leg.style == Style::cartesian || leg.leg.style == Style::unknown)
    return {{"vector", misclosure.normalized(), -kInfinity, kInfinity}};
  const bool sloped = leg.leg.style == Style::normal;
  const double along = sloped ? length : flat;
  if (along > 0)
    all.push_back(
        {"tape",
         sloped ? Eigen::Vector3d(v / length) : Eigen::Vector3d(v.x() / flat, v.y() / flat, 0),
         -kInfinity, along});
  if (flat > 0) all.push_back({"compass", {v.y(), -v.x(), 0}, -kPi, kPi});
  if (sloped && flat > 0)
    all.push_back({"clino", {-v.x() * v.z() / flat, -v.y() * v.z() / flat, flat}, -kPi, kPi});
  if (!sloped) all.push_back({"depth", {0, 0, 1}, -kInfinity, kInfinity});
  return all;
}

}  // namespace

std::vector<Blunder> find_blunders(const LegGraph& graph, const Observations& observations,
                                   const TraverseChain& chain, const ClosureTest& test) {
  const Eigen::Matrix3d weight = test.measured.inverse();
  const Eigen::Vector3d weighted = weight * test.misclosure;
  const Eigen::Matrix3d sensitivity = weight * test.residual * weight;
  std::vector<Blunder> all;
  for (size_t i = 0; i < chain.edges.size(); ++i) {
    const int leg = graph.edges[static_cast<size_t>(chain.edges[i])].leg;
    if (leg < 0) continue;
    const ObservedLeg& observed = observations.legs[static_cast<size_t>(leg)];
    for (const Hypothesis& each : hypotheses(observed, test.misclosure)) {
      const double power = each.change.dot(sensitivity * each.change);
      // An error of a reading that the other legs do not control has no effect on the residual.
      if (!(power > 1e-9 * each.change.dot(weight * each.change))) continue;
      const double effect = (chain.forwards[i] ? 1 : -1) * each.change.dot(weighted);
      const double sigmas = std::fabs(effect) / std::sqrt(power), error = effect / power;
      if (sigmas > kSignificant && error >= each.least && error <= each.most)
        all.push_back({leg, each.reading, sigmas, error});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Blunder& a, const Blunder& b) { return a.sigmas > b.sigmas; });
  if (all.size() > kMost) all.resize(kMost);
  return all;
}

}  // namespace vug::survey
