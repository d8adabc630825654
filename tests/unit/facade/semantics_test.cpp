// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

#include <vug/base/parallel.h>
#include <vug/facade/semantics.h>
#include <vug/field/boolean.h>

#include <cmath>

namespace vug::facade {
namespace {

FacadeInstance placed(const Sample& s, FacadeFrame frame = {}) {
  EXPECT_EQ(s.said, "");
  return {std::make_shared<const Tree>(s.tree), frame};
}

/// The kind of the element at a point of the facade of 12 m x 9 m, x from its middle; the symbol if
/// there is no element, "" for nothing.
std::string at(const Semantics& semantics, const Vec3d& p) {
  const int node = semantics.node_at(p);
  if (node < 0) return "";
  const Node& found = semantics.tree().nodes[static_cast<size_t>(node)];
  return found.element ? found.element->kind() : found.symbol;
}

const Sample& front() {
  static const Sample s = facade_of(
      "axiom A\n A -> columns(4m, Bay, 4m, wall(relief: 30cm), 4m, recess(1m, Back, front: "
      "column(diameter: 80cm)))\n Bay -> inset(1m, window(reveal: 20cm, sill: 10cm))\n"
      "Back -> inset(1m, 1m, 0m, 1m, doorway(depth: 2m))");
  return s;
}

TEST(Semantics, SurfacesBelongToTheirElements) {
  const Semantics s(placed(front()));
  EXPECT_EQ(at(s, {-4, 1, -0.1}), "window") << "the lower reveal";
  EXPECT_EQ(at(s, {-4, 0.97, 0.1}), "window") << "the sill's front, below its rectangle";
  EXPECT_EQ(at(s, {-5.5, 4, 0}), "Bay") << "plain wall next to it";
  EXPECT_EQ(at(s, {0, 4, 0.3}), "wall") << "the raised face";
  EXPECT_EQ(at(s, {2, 4, 0.15}), "wall") << "its side";
  EXPECT_EQ(at(s, {4, 4, 0.4}), "column") << "the shaft";
  EXPECT_EQ(at(s, {5.5, 4, -1}), "Back") << "the face behind the column";
  EXPECT_EQ(at(s, {6, 4, -0.6}), "Back") << "the side of the recess";
  EXPECT_EQ(at(s, {3, 3, -2}), "doorway") << "inside the passage";
}

TEST(Semantics, WeatheredSurfacesAreFoundAndDistantOnesAreNot) {
  const Semantics s(placed(front()));
  EXPECT_EQ(at(s, {-5.5, 4, 0.05}), "Bay");
  EXPECT_EQ(at(s, {0, 4, 0.37}), "wall");
  EXPECT_EQ(at(s, {0, 4, 0.3 + 1.01 * kMaxWeathering}), "");
  EXPECT_EQ(at(s, {0, 10, 0}), "");
  EXPECT_EQ(at(s, {-4, 4.5, -2}), "") << "far behind the window";
}

TEST(Semantics, CornersBesideAnArchAreWall) {
  const Semantics s(
      placed(facade_of("axiom A\n A -> inset(3m, 3m, 0m, 3m, doorway(head: round))")));
  EXPECT_EQ(at(s, {0, 3, -0.5}), "") << "in the air of the passage";
  EXPECT_EQ(at(s, {3, 2, -0.5}), "doorway") << "the jamb";
  EXPECT_EQ(at(s, {2.95, 5.95, 0}), "A") << "next to the arch";
}

TEST(Semantics, FollowTheFrameAndCopies) {
  const Sample two =
      facade_of("axiom A\n A -> repeat(x, 6m, columns(1, wall, 2m, inset(50cm, door)))");
  const Semantics s(placed(two, {{5, 1, 2}, kPi / 2}));
  // Rotated to the left it faces +x; its left end is at z = 8.
  for (const double x : {5.0, 11.0}) {
    const Vec3d jamb(5 - 0.1, 1 + 4, 8 - (x - 0.5));
    EXPECT_EQ(at(s, jamb), "door") << x;
    EXPECT_EQ(at(s, {5, 1 + 4, 8 - (x - 3)}), "wall") << x;
  }
  EXPECT_EQ(s.node_at({4.9, 5, 3.5}), s.node_at({4.9, 5, -2.5})) << "copies are one node";
}

TEST(Semantics, MeshesCarryKindsAndNodes) {
  const auto first = std::make_shared<const FacadeInstance>(placed(front()));
  const auto second = std::make_shared<const FacadeInstance>(placed(front(), {{20, 0, 0}, 0}));
  mesh::Mesh mesh;
  for (const double x : {0.0, 20.0})
    for (const Vec3f& p :
         {Vec3f(-4, 1, -0.1f), Vec3f(0, 4, 0.3f), Vec3f(-5.5f, 4, 0), Vec3f(0, 0, 5)})
      mesh.positions.push_back(p + Vec3f(static_cast<float>(x), 0, 0));
  mesh::Mesh one_thread = mesh;
  add_semantics(mesh, {first, second});
  {
    with_threads(1, [&] { add_semantics(one_thread, {first, second}); });
  }
  EXPECT_EQ(mesh, one_thread);
  std::vector<std::string> names;
  for (const mesh::Attribute& each : mesh.attributes) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"column", "doorway", "wall", "window", "node"}));
  EXPECT_EQ(names, semantic_names({first, second}));
  const auto values = [&](const char* name) { return mesh::find_attribute(mesh, name)->values; };
  EXPECT_EQ(values("window"), (std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(values("wall"), (std::vector<float>{0, 1, 1, 0, 0, 1, 1, 0}))
      << "surfaces without an element are wall";
  const std::vector<float> node = values("node");
  EXPECT_EQ(node[3], -1);
  const auto nodes = static_cast<float>(first->tree->nodes.size());
  for (const size_t i : {0U, 1U, 2U}) {
    EXPECT_GE(node[i], 0);
    EXPECT_EQ(node[i + 4], node[i] + nodes);
  }
}

TEST(Semantics, CarvedFieldsStoreTheirFacade) {
  const FacadeInstance here = placed(front(), {{1, 2, 3}, 0.5});
  const field::Field f = with_facade(here, field::empty());
  ASSERT_TRUE(find_facade(f));
  EXPECT_EQ(find_facade(f)->tree, here.tree);
  EXPECT_EQ(find_facade(f)->frame.yaw, 0.5);
  EXPECT_FALSE(find_facade(field::empty()));
}

}  // namespace
}  // namespace vug::facade
