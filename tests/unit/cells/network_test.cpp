// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/cells/network.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

TEST(FlatTorus, LinksReachTheNearestCellsOnly) {
  struct Case {
    uint32_t full;
    double least, most;  // Lengths of links, in spacings.
  };
  const double root2 = std::sqrt(2.0);
  for (const Case& c : {Case{3, 1, 1}, Case{4, 1, 1}, Case{6, 1, 1}, Case{8, 1, root2}}) {
    const Network n = flat_torus(12, 10, c.full, 0.25);
    validate(n);
    double area = 0;
    for (uint32_t i = 0; i < n.size(); ++i) {
      EXPECT_EQ(n.links.degree(i), c.full);
      area += static_cast<double>(n.area[i]);
      const uint32_t x = i % 12, z = i / 12;
      if (x < 1 || x > 9 || z < 1 || z > 8) continue;
      for (const uint32_t to : n.links.of(i)) {
        const float d = (n.position[i] - n.position[to]).length() / 0.25f;
        EXPECT_GE(d, static_cast<float>(c.least) - 1e-5f);
        EXPECT_LE(d, static_cast<float>(c.most) + 1e-5f);
      }
    }
    const std::vector<uint32_t> piece = components(n.links);
    EXPECT_EQ(*std::max_element(piece.begin(), piece.end()), 0u);
    // Periods of the four grids, in spacings.
    const double root3 = std::sqrt(3.0);
    const double width = c.full == 3 ? 12 * root3 / 2 : 12;
    const double depth = c.full == 3 ? 15 : c.full == 6 ? 5 * root3 : 10;
    EXPECT_NEAR(area, width * depth / 16, 1e-4);
  }
  EXPECT_THROW(flat_torus(12, 10, 5), Error);
  EXPECT_THROW(flat_torus(12, 9, 6), Error);
  EXPECT_THROW(flat_torus(3, 9, 4), Error);
}

TEST(Network, ValidateFindsBrokenPromises) {
  const Network good = flat_torus(6, 6, 4);
  validate(good);
  Network n = good;
  n.links.to[0] = 9;  // Missing in the other row.
  EXPECT_THROW(validate(n), Error);
  n = good;
  n.normal[3] = Vec3f(0, 2, 0);
  EXPECT_THROW(validate(n), Error);
  n = good;
  n.right[3] = Vec3f(0, 1, 0);
  EXPECT_THROW(validate(n), Error);
  n = good;
  n.area.pop_back();
  EXPECT_THROW(validate(n), Error);
  n = good;
  n.full = 3;
  EXPECT_THROW(validate(n), Error);
}

TEST(Network, ComponentsAreCountedAndDigestsDiffer) {
  Network n = flat_torus(6, 6, 4);
  const Network before = n;
  n.links = make_links(36, [](uint32_t i, const auto& add) {
    if (i % 2 == 0) add(i + 1);
    if (i % 2 == 1) add(i - 1);
  });
  validate(n);
  const std::vector<uint32_t> piece = components(n.links);
  for (uint32_t i = 0; i < 36; ++i) EXPECT_EQ(piece[i], i / 2);
  EXPECT_NE(digest(n), digest(before));
  EXPECT_EQ(digest(before), digest(flat_torus(6, 6, 4)));
}

TEST(Network, PlacesDiffer) {
  std::vector<uint64_t> seen;
  for (int i = 0; i < 20000; ++i)
    seen.push_back(
        position_key({static_cast<float>(i % 100) * 0.01f, static_cast<float>(i / 100), 0}));
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
  EXPECT_EQ(position_key({0, 1, 0}), position_key({-0.0f, 1, 0}));
}

}  // namespace
}  // namespace vug::cells
