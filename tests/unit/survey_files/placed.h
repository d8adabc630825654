// SPDX-License-Identifier: Apache-2.0
// A small reference solution of the closure of loops: weighted least squares with dense matrices,
// for surveys of at most some hundred stations.
#pragma once

#include <vug/survey/observations.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <numeric>

namespace vug::survey {

/// The coordinates of all stations. Fixes without a covariance hold exactly; without any fix the
/// first station is at the origin. Legs of the style nosurvey only connect.
inline std::vector<Vec3d> placed(const Observations& survey) {
  std::vector<int> same(survey.stations.size());
  std::iota(same.begin(), same.end(), 0);
  const auto find = [&](int i) {
    while (same[static_cast<size_t>(i)] != i) i = same[static_cast<size_t>(i)];
    return i;
  };
  for (const Equate& equate : survey.equates)
    same[static_cast<size_t>(find(equate.b))] = find(equate.a);
  const auto n = static_cast<Eigen::Index>(3 * survey.stations.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto add = [&](int from, int to, const Vec3d& v, const Eigen::Matrix3d& weight) {
    const Eigen::Vector3d vector(v.x, v.y, v.z);
    if (to >= 0) {
      const Eigen::Index t = 3 * find(to);
      normal.block<3, 3>(t, t) += weight;
      right.segment<3>(t) += weight * vector;
      if (from < 0) return;
      const Eigen::Index f = 3 * find(from);
      normal.block<3, 3>(f, f) += weight;
      normal.block<3, 3>(f, t) -= weight;
      normal.block<3, 3>(t, f) -= weight;
      right.segment<3>(f) -= weight * vector;
    }
  };
  const auto weight = [](const Covariance& c) {
    Eigen::Matrix3d m;
    m << c.xx, c.xy, c.zx, c.xy, c.yy, c.yz, c.zx, c.yz, c.zz;
    return Eigen::Matrix3d(m.inverse());
  };
  for (const ObservedLeg& leg : survey.legs)
    if (leg.leg.style != Style::nosurvey)
      add(leg.leg.from, leg.leg.to, leg.vector, weight(leg.covariance));
  const Eigen::Matrix3d exact = Eigen::Matrix3d::Identity() * 1e9;
  for (const Fix& fix : survey.fixes)
    add(-1, fix.station, fix.position, fix.covariance ? weight(*fix.covariance) : exact);
  if (survey.fixes.empty()) add(-1, 0, Vec3d(0.0), exact);
  for (int i = 0; i < static_cast<int>(same.size()); ++i)
    if (find(i) != i) normal.block<3, 3>(3 * i, 3 * i).setIdentity();
  const Eigen::VectorXd solution = normal.ldlt().solve(right);
  std::vector<Vec3d> positions;
  for (int i = 0; i < static_cast<int>(same.size()); ++i) {
    const Eigen::Vector3d p = solution.segment<3>(3 * find(i));
    positions.emplace_back(p.x(), p.y(), p.z());
  }
  return positions;
}

/// Each station of the reference with a name is at its place in the survey, within 1.5 cm, and each
/// leg is between its places with its flags.
inline void expect_same(const Observations& survey, const Survey& reference) {
  const std::vector<Vec3d> positions = placed(survey);
  const auto place = [&](const std::string& name) -> const Vec3d* {
    for (size_t i = 0; i < survey.stations.size(); ++i)
      if (survey.stations[i].name == name) return &positions[i];
    return nullptr;
  };
  constexpr double kTolerance = 0.015;
  for (const Station& station : reference.stations) {
    if (station.anonymous()) continue;
    const Vec3d* found = place(station.name);
    ASSERT_TRUE(found) << station.name;
    EXPECT_LT((*found - station.position).length(), kTolerance)
        << station.name << " " << *found << " instead of " << station.position;
  }
  EXPECT_EQ(survey.legs.size(), reference.legs.size());
  for (const Leg& leg : reference.legs) {
    const Vec3d a = reference.stations[static_cast<size_t>(leg.from)].position;
    const Vec3d b = reference.stations[static_cast<size_t>(leg.to)].position;
    bool found = false;
    for (const ObservedLeg& own : survey.legs) {
      const Vec3d p = positions[static_cast<size_t>(own.leg.from)];
      const Vec3d q = positions[static_cast<size_t>(own.leg.to)];
      const bool same = (p - a).length() < kTolerance && (q - b).length() < kTolerance;
      const bool reversed = (p - b).length() < kTolerance && (q - a).length() < kTolerance;
      found = found || ((same || reversed) && own.leg.surface == leg.surface &&
                        own.leg.duplicate == leg.duplicate && own.leg.splay == leg.splay);
    }
    EXPECT_TRUE(found) << "leg " << a << " - " << b;
  }
}

}  // namespace vug::survey
