// SPDX-License-Identifier: Apache-2.0
// The list of missing instruction sets.
#include <vug/base/cpu_support.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

std::string missing(const std::vector<CpuFeature>& features) {
  return missing_features(features.data(), static_cast<int>(features.size()));
}

TEST(CpuSupport, ListsMissingFeatures) {
  EXPECT_EQ(missing({}), "");
  EXPECT_EQ(missing({{"AVX2", true}, {"FMA", true}}), "");
  EXPECT_EQ(missing({{"AVX2", true}, {"FMA", false}, {"BMI2", true}}), "FMA");
  EXPECT_EQ(missing({{"AVX2", false}, {"FMA", true}, {"BMI2", false}}), "AVX2, BMI2");
}

TEST(CpuSupport, LongListsAreCut) {
  const std::vector<CpuFeature> many(100, {"AVX-512", false});
  const std::string text = missing(many);
  EXPECT_LT(text.size(), 160U);
  EXPECT_EQ(text.find("AVX-512, AVX-512"), 0U);
}

TEST(CpuSupport, ThisProcessorRunsTheBuild) { EXPECT_STREQ(missing_cpu_features(), ""); }

}  // namespace
}  // namespace vug
