// SPDX-License-Identifier: Apache-2.0
// Materials by the weights of the rock.
#include <vug/base/error.h>
#include <vug/exchange/look.h>
#include <vug/mesh/shapes.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

MaterialPtr colored(const Vec3d& color) { return make_material("lambert", {{"albedo", color}}); }
Value names(const std::vector<std::string>& of) {
  return ValueTraits<std::vector<std::string>>::write(of);
}
Value list(const std::vector<MaterialPtr>& materials) {
  return ValueTraits<std::vector<MaterialPtr>>::write(materials);
}

/// The colour of a triangle whose corners have these weights.
Vec3d color_with(const MaterialPtr& material,
                 const std::vector<std::pair<std::string, float>>& weights) {
  mesh::Mesh mesh = mesh::box_mesh(Box3d(Vec3d(0), Vec3d(1)));
  for (const auto& [name, weight] : weights)
    mesh.attributes.push_back({name, 1, std::vector<float>(mesh.positions.size(), weight)});
  Surface surface;
  surface.mesh = &mesh;
  surface.u = 0.25f;
  surface.v = 0.25f;
  return material->look(surface).base_color;
}

void expect_color(const Vec3d& got, const Vec3d& want) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 1e-6) << got;
}

MaterialPtr three_rocks() {
  return make_material(
      "by_rock", {{"of", names({"limestone", "calcite", "clay"})},
                  {"materials", list({colored({1, 0, 0}), colored({0, 1, 0}), colored({0, 0, 1})})},
                  {"otherwise", ValueTraits<MaterialPtr>::write(colored({0, 0, 0}))}});
}

TEST(ByRock, EachMaterialHasItsWeight) {
  const MaterialPtr three = three_rocks();
  expect_color(color_with(three, {{"w_limestone", 0.2f}, {"w_calcite", 0.3f}, {"w_clay", 0.5f}}),
               {0.2, 0.3, 0.5});
  expect_color(color_with(three, {{"w_calcite", 1.0f}}), {0, 1, 0});
  // Another rock takes the rest.
  expect_color(color_with(three, {{"w_limestone", 0.2f}, {"w_clay", 0.3f}, {"w_marl", 0.5f}}),
               {0.2, 0, 0.3});
  expect_color(color_with(three, {}), {0, 0, 0});
}

TEST(ByRock, WithoutOtherwiseTheNamedMaterialsShareTheRest) {
  const MaterialPtr two =
      make_material("by_rock", {{"of", names({"limestone", "calcite"})},
                                {"materials", list({colored({1, 0, 0}), colored({0, 1, 0})})}});
  expect_color(color_with(two, {{"w_limestone", 0.1f}, {"w_calcite", 0.3f}}), {0.25, 0.75, 0});
  expect_color(color_with(two, {}), {1, 0, 0});
}

TEST(ByRock, FaultsNameTheProblem) {
  const auto refused = [](const std::vector<std::string>& of, size_t count) {
    EXPECT_THROW(
        make_material("by_rock",
                      {{"of", names(of)},
                       {"materials", list(std::vector<MaterialPtr>(count, colored({1, 1, 1})))}}),
        Error);
  };
  refused({"limestone", "calcite"}, 1);
  refused({"limestone", "limestone"}, 2);
  refused({}, 0);
}

}  // namespace
}  // namespace vug::render
