// SPDX-License-Identifier: Apache-2.0
// Capsules in single precision: their bounds are below those in double precision at any distance
// from the origin, and lists keep what is appended.
#include "passage_samples.h"

#include <vug/passages/sweep/capsule_list.h>

#include <gtest/gtest.h>

namespace vug::passages {
namespace {

Capsule random_capsule(RandomStream& random, const Vec3d& middle) {
  return {middle + random_vector(random, 20), random_vector(random, 1).normalized(),
          random.uniform(0.01, 30), random.uniform(0.1, 5), random.uniform(0.3, 1)};
}

std::vector<double> least(const CapsuleList& list, const Vec3d& p) {
  std::vector<double> out;
  for (size_t k = 0; k < list.packs(); ++k) {
    const CapsulePack capsule = list.pack(k);
    float lanes[Pack::kLanes];
    capsule.least_at(field::length(capsule.offset(field::constant<Pack>(p)))).store(lanes);
    for (const float lane : lanes)
      out.push_back(static_cast<double>(lane) - CapsulePack::kRounding * p.length());
  }
  return out;
}

TEST(CapsuleList, BoundsAreBelowThoseInDoublePrecision) {
  RandomStream random(RandomKey(1));
  for (const double far : {0.0, 100.0, 1e4, 5e6}) {
    const Vec3d middle(far, 0.5 * far, -far);
    CapsuleList list;
    std::vector<Capsule> capsules;
    for (int i = 0; i < 500; ++i) {
      capsules.push_back(random_capsule(random, middle));
      list.append(capsules.back(), 0);
    }
    for (int i = 0; i < 50; ++i) {
      const Vec3d p = middle + random_vector(random, 40);
      const std::vector<double> bounds = least(list, p);
      for (size_t k = 0; k < capsules.size(); ++k) {
        const double exact = capsules[k].least(p);
        ASSERT_LE(bounds[k], exact) << far;
        ASSERT_GE(bounds[k], exact - 1e-5 * (30 + p.length())) << far;
      }
    }
  }
}

TEST(CapsuleList, UnusedLanesAreNeverNearest) {
  RandomStream random(RandomKey(2));
  CapsuleList list;
  for (size_t count = 1; count < 30; ++count) {
    list.append(random_capsule(random, Vec3d(0.0)), 1);
    ASSERT_EQ(list.size(), count);
    const std::vector<double> bounds = least(list, {1, 2, 3});
    for (size_t i = 0; i < bounds.size(); ++i) EXPECT_EQ(bounds[i] > 1e20, i >= count);
    float fillets[Pack::kLanes];
    list.fillets(list.packs() - 1).store(fillets);
    for (size_t i = 0; i < Pack::kLanes; ++i)
      EXPECT_EQ(fillets[i], Pack::kLanes * (list.packs() - 1) + i < count ? 1 : 0);
  }
}

TEST(CapsuleList, AppendsTheLanesThatAreSet) {
  RandomStream random(RandomKey(3));
  CapsuleList all;
  for (int i = 0; i < 50; ++i) all.append(random_capsule(random, Vec3d(0.0)), 0);
  const std::vector<double> bounds = least(all, Vec3d(0.0));
  for (int round = 0; round < 200; ++round) {
    CapsuleList some;
    std::vector<double> expected;
    for (size_t k = 0; k < all.packs(); ++k) {
      const unsigned used = k + 1 < all.packs() ? 255u : 3u;
      const unsigned lanes = random.below(256) & used;
      some.append(all, k, lanes);
      for (size_t lane = 0; lane < Pack::kLanes; ++lane)
        if (lanes >> lane & 1) expected.push_back(bounds[Pack::kLanes * k + lane]);
    }
    std::vector<double> found = least(some, Vec3d(0.0));
    found.resize(some.size());
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace vug::passages
