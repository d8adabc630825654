// SPDX-License-Identifier: Apache-2.0
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace vug::render {
namespace {

SampleId sample_id(uint32_t x, uint32_t y, uint32_t index, uint32_t spp) {
  SampleId id;
  id.x = x, id.y = y, id.index = index, id.spp = spp, id.seed = 3;
  return id;
}

TEST(Samplers, GiveTheSameBitsInAnyOrder) {
  for (const auto* kind : samplers()) {
    SCOPED_TRACE(kind->info.name);
    const SamplerPtr a = make_sampler(kind->info.name), b = make_sampler(kind->info.name);
    std::vector<Vec2f> first;
    for (uint32_t i = 0; i < 64; ++i)
      for (uint32_t d = 0; d < 10; ++d) first.push_back(a->pair(sample_id(5, 9, i, 64), d));
    for (uint32_t i = 64; i-- > 0;)
      for (uint32_t d = 10; d-- > 0;)
        EXPECT_EQ(b->pair(sample_id(5, 9, i, 64), d), first[i * 10 + d]);
  }
}

TEST(Samplers, FourPairsEqualFourDimensions) {
  for (const auto* kind : samplers()) {
    SCOPED_TRACE(kind->info.name);
    const SamplerPtr sampler = make_sampler(kind->info.name);
    for (uint32_t i = 0; i < 64; ++i)
      for (const uint32_t first : {0u, 2u, 1001u, 0xfffffff0u}) {
        const SampleId id = sample_id(60000 + i, 3 * i, i, 100);
        const FourPairs four = sampler->four_pairs(id, first);
        for (uint32_t d = 0; d < 4; ++d) EXPECT_EQ(four[d], sampler->pair(id, first + d));
      }
  }
}

TEST(Samplers, LieInTheUnitSquareWithTheRightMoments) {
  for (const auto* kind : samplers()) {
    SCOPED_TRACE(kind->info.name);
    const SamplerPtr sampler = make_sampler(kind->info.name);
    constexpr int kCount = 1 << 16;
    double mean = 0, squares = 0, product = 0;
    for (uint32_t i = 0; i < kCount; ++i) {
      const Vec2f p = sampler->pair(sample_id(i % 16, i / 16 % 16, i / 256, 256), 7);
      ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
      mean += static_cast<double>(p.x) / kCount;
      squares += static_cast<double>(p.x * p.x) / kCount;
      product += static_cast<double>(p.x * p.y) / kCount;
    }
    EXPECT_NEAR(mean, 0.5, 4 * 0.289 / 256);
    EXPECT_NEAR(squares, 1.0 / 3, 4 * 0.298 / 256);
    EXPECT_NEAR(product, 0.25, 4 * 0.22 / 256);
  }
}

TEST(Samplers, PixelsSeedsAndDimensionsDiffer) {
  for (const auto* kind : samplers()) {
    SCOPED_TRACE(kind->info.name);
    const SamplerPtr sampler = make_sampler(kind->info.name);
    std::set<float> seen;
    for (uint32_t pixel = 0; pixel < 32; ++pixel)
      for (uint32_t d = 0; d < 32; ++d) seen.insert(sampler->pair(sample_id(pixel, 2, 0, 4), d).x);
    EXPECT_GT(seen.size(), 1020u);  // of 1024; 24-bit numbers occasionally coincide
    SampleId other = sample_id(1, 2, 0, 4);
    other.seed = 4;
    EXPECT_NE(sampler->pair(other, 0), sampler->pair(sample_id(1, 2, 0, 4), 0));
  }
}

// A (0,k,2)-net has exactly one of its 2^k points in each elementary interval.
TEST(Sobol, EveryPixelHoldsANetInEveryDimensionPair) {
  const SamplerPtr sampler = make_sampler("sobol");
  for (const uint32_t bits : {2u, 4u, 6u})
    for (const uint32_t d : {0u, 1u, 5u, 40u})
      for (uint32_t across = 0; across <= bits; ++across) {
        const uint32_t count = 1u << bits;
        std::set<uint32_t> cells;
        for (uint32_t i = 0; i < count; ++i) {
          const Vec2f p = sampler->pair(sample_id(13, 7, i, count), d);
          const auto x = static_cast<uint32_t>(p.x * static_cast<float>(1u << across));
          const auto y = static_cast<uint32_t>(p.y * static_cast<float>(1u << (bits - across)));
          cells.insert(x << 16 | y);
        }
        EXPECT_EQ(cells.size(), count) << bits << " bits, dimension " << d << ", split " << across;
      }
}

// The whole picture is a net: with one sample per pixel, an aligned block of 8 x 8 pixels is a net,
// too, which makes the error blue noise.
TEST(Sobol, BlocksOfPixelsFormANet) {
  const SamplerPtr sampler = make_sampler("sobol");
  for (uint32_t across = 0; across <= 6; ++across) {
    std::set<uint32_t> cells;
    for (uint32_t y = 0; y < 8; ++y)
      for (uint32_t x = 0; x < 8; ++x) {
        const Vec2f p = sampler->pair(sample_id(16 + x, 40 + y, 0, 1), 3);
        cells.insert(static_cast<uint32_t>(p.x * static_cast<float>(1u << across)) << 16 |
                     static_cast<uint32_t>(p.y * static_cast<float>(1u << (6 - across))));
      }
    EXPECT_EQ(cells.size(), 64u) << across;
  }
}

// Compares the error of a mean over a pixel's samples, for many pixels, of Sobol and independent
// samples.
TEST(Sobol, IntegratesSmoothFunctionsMuchBetter) {
  const auto error = [](const char* kind) {
    const SamplerPtr sampler = make_sampler(kind);
    double squares = 0;
    for (uint32_t pixel = 0; pixel < 256; ++pixel) {
      double mean = 0;
      for (uint32_t i = 0; i < 64; ++i) {
        const Vec2f p = sampler->pair(sample_id(pixel % 16, pixel / 16, i, 64), 2);
        mean += static_cast<double>(p.x * p.y) / 64;
      }
      squares += (mean - 0.25) * (mean - 0.25) / 256;
    }
    return std::sqrt(squares);
  };
  EXPECT_NEAR(error("independent"), 0.2205 / 8, 0.004);  // sigma of x y is sqrt(7) / 12
  EXPECT_LT(error("sobol"), 0.2 * error("independent"));
}

}  // namespace
}  // namespace vug::render
