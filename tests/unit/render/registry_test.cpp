// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace vug::render {
namespace {

template <class Product>
void check_infos(const Kinds<Product>& kinds, const std::string& category) {
  EXPECT_FALSE(kinds.empty());
  std::set<std::string> names;
  for (const auto* kind : kinds) {
    SCOPED_TRACE(category + " " + kind->info.name);
    EXPECT_TRUE(names.insert(kind->info.name).second);
    EXPECT_EQ(kind->info.category, category);
    EXPECT_FALSE(kind->info.doc.empty());
    for (const ParamInfo& p : kind->info.params) EXPECT_FALSE(p.doc.empty()) << p.name;
  }
}

TEST(Kinds, AreDocumented) {
  check_infos(cameras(), "camera");
  check_infos(samplers(), "sampler");
  check_infos(materials(), "material");
  check_infos(lights(), "light");
  check_infos(media(), "medium");
  check_infos(integrators(), "integrator");
}

std::string refusal(const std::string& kind, const NamedValues& parameters) {
  try {
    make_light(kind, parameters);
  } catch (const Error& error) {
    return std::string(error.what()) + " / " + error.hint();
  }
  return "accepted";
}

TEST(Kinds, ReportInvalidParameters) {
  EXPECT_NE(refusal("rekt", {}).find("rect"), std::string::npos);
  EXPECT_NE(refusal("rect", {{"wdth", 1.0}}).find("width"), std::string::npos);
  EXPECT_NE(refusal("rect", {{"width", 0.0}}).find("width"), std::string::npos);
  EXPECT_NE(refusal("rect", {{"normal", Vec3d(0, 0, 0)}}).find("normal"), std::string::npos);
  EXPECT_NE(refusal("sphere", {{"radius", -1.0}}).find("radius"), std::string::npos);
  EXPECT_NE(refusal("sphere", {{"radiance", Vec3d(1, -1, 1)}}).find("radiance"), std::string::npos);
  EXPECT_NE(refusal("sky_image", {}).find("file"), std::string::npos);
  EXPECT_NE(refusal("sky_image", {{"file", "no/such.exr"}}).find("no/such.exr"), std::string::npos);
}

}  // namespace
}  // namespace vug::render
