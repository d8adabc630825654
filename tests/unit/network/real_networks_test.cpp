// SPDX-License-Identifier: Apache-2.0
// Measures of real and published networks, which are not part of the project.
#include "../scan/external_data.h"

#include <gtest/gtest.h>
#include <vug/network/dat.h>
#include <vug/network/metrics.h>

namespace vug::network {
namespace {

std::filesystem::path karst_data() {
  const std::filesystem::path folder = external_data() / "surveys" / "karst";
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

#define SKIP_WITHOUT_DATA()                                                 \
  if (karst_data().empty()) {                                               \
    GTEST_SKIP() << "set VUG_EXTERNAL_DATA to a folder with surveys/karst"; \
  }

TEST(RealNetworks, SakanyHasThePublishedMeasures) {
  SKIP_WITHOUT_DATA();
  const Metrics metrics = measure(read_dat(karst_data() / "Sakany_nodes.dat"));
  EXPECT_EQ(metrics.stations, 1716);
  EXPECT_EQ(metrics.legs, 1784);
  EXPECT_EQ(metrics.components, 1);
  EXPECT_EQ(metrics.cycles, 69);
  EXPECT_NEAR(metrics.length, 7474.8, 0.05);
  EXPECT_EQ(metrics.nodes, 344);
  EXPECT_EQ(metrics.edges, 412);
  EXPECT_NEAR(metrics.orientation_entropy, 0.992, 5e-4);
  EXPECT_NEAR(metrics.branch_length, 20.71, 5e-3);
  EXPECT_NEAR(metrics.length_entropy, 0.377, 5e-4);
  EXPECT_NEAR(metrics.length_variation, 0.915, 5e-4);
  EXPECT_NEAR(metrics.tortuosity, 1.401, 5e-4);
  EXPECT_NEAR(metrics.degree, 2.395, 5e-4);
  EXPECT_NEAR(metrics.degree_variation, 0.471, 5e-4);
  EXPECT_NEAR(metrics.degree_correlation, -0.168, 5e-4);
  EXPECT_NEAR(metrics.path_length, 12.62, 5e-3);
  EXPECT_NEAR(metrics.dominance, 0.268, 5e-4);
}

TEST(RealNetworks, HuttesIsARingWithArms) {
  SKIP_WITHOUT_DATA();
  const Metrics metrics = measure(read_dat(karst_data() / "Huttes_links.dat"));
  EXPECT_EQ(metrics.stations, 41);
  EXPECT_EQ(metrics.legs, 41);
  EXPECT_EQ(metrics.cycles, 1);
  EXPECT_NEAR(metrics.length, 190.5, 0.05);
}

TEST(RealNetworks, PublishedNetworksHaveTheirCycles) {
  SKIP_WITHOUT_DATA();
  const struct {
    const char* name;
    int legs;
    int cycles;
  } cases[] = {{"gorge", 34, 0}, {"permeability", 44, 0}, {"superimposed", 63, 4}};
  for (const auto& c : cases) {
    const Metrics metrics = measure(read_dat(karst_data() / (std::string(c.name) + "_nodes.dat")));
    EXPECT_EQ(metrics.legs, c.legs) << c.name;
    EXPECT_EQ(metrics.cycles, c.cycles) << c.name;
    EXPECT_EQ(metrics.components, 1) << c.name;
  }
}

// Monachou's files are not available; its published measures are in docs/explanation/karst.md.

}  // namespace
}  // namespace vug::network
