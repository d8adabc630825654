// SPDX-License-Identifier: Apache-2.0
// Transfer of attributes to vertices: constants are reproduced, linear functions nearly so, and the
// sides of walls do not mix.
#include "run.h"

#include <vug/cells/transfer_to_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::cells {
namespace {

const Vec3d kSlope(0.6, -0.5, 0.3);

double linear(const Vec3f& p) { return kSlope.dot(Vec3d(p)) + 2; }

NetworkPtr network(const mesh::Mesh& mesh, const std::string& grid, double spacing) {
  return std::make_shared<const Network>(
      build(Surface({shared(mesh)}), options(grid, spacing)).network);
}

/// The mesh with "x", a function of the cells' positions.
template <class F>
mesh::Mesh carried_to_mesh(mesh::Mesh mesh, const NetworkPtr& cells, const F& f) {
  Simulation simulation(cells, RandomKey(1));
  std::vector<float>& x = simulation.attributes().column<float>("x").now;
  for (uint32_t i = 0; i < cells->size(); ++i) x[i] = static_cast<float>(f(cells->position[i]));
  transfer_to_mesh(simulation, mesh);
  return mesh;
}

const std::vector<float>& values(const mesh::Mesh& mesh, const std::string& name) {
  return mesh::find_attribute(mesh, name)->values;
}

TEST(TransferToMesh, ConstantsStayExactly) {
  const mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 4);
  for (const double spacing : {0.02, 0.07, 0.5}) {  // Cells finer and coarser than the mesh.
    const mesh::Mesh mesh =
        carried_to_mesh(ball, network(ball, "random", spacing), [](const Vec3f&) { return 0.1f; });
    for (const float v : values(mesh, "x")) ASSERT_EQ(v, 0.1f) << spacing;
    for (const float v : values(mesh, "transparent")) ASSERT_EQ(v, 0);
  }
}

// The error of a mean over the cells around a vertex is the slope times the offset of their
// centroid: always less than the reach. On a surface without edges it is a third of a spacing for
// uniform cells, and twice that at the seams of squares, which do not match.
TEST(TransferToMesh, LinearFunctionsAreReproduced) {
  const mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 5);
  const std::vector<std::pair<const char*, double>> bounds = {
      {"random", 1.0 / 3}, {"triangle", 1.0 / 3}, {"square", 2.0 / 3}};
  for (const auto& [grid, bound] : bounds) {
    const NetworkPtr cells = network(ball, grid, 0.1);
    const mesh::Mesh mesh = carried_to_mesh(ball, cells, linear);
    double worst = 0;
    for (size_t v = 0; v < mesh.positions.size(); ++v)
      worst = std::max(worst, std::fabs(values(mesh, "x")[v] - linear(mesh.positions[v])));
    EXPECT_LT(worst, kSlope.length() * 0.1 * bound) << grid;
    EXPECT_GT(worst, 0);
  }
}

TEST(TransferToMesh, LinearFunctionsAreReproducedWithinTheReachAtABoundary) {
  mesh::Mesh floor = floor_mesh();
  const NetworkPtr cells = network(floor, "triangle", 0.05);
  const mesh::Mesh mesh = carried_to_mesh(floor, cells, linear);
  // Four corners 1 m apart: coarser than the cells, so the mean edge length is the reach.
  const double edge = (4 + 2 * std::sqrt(2.0)) / 6;
  for (size_t v = 0; v < 4; ++v)
    EXPECT_LT(std::fabs(values(mesh, "x")[v] - linear(mesh.positions[v])), kSlope.length() * edge);
}

/// Two sheets 4 mm apart that face away from each other.
mesh::Mesh thin_wall() {
  constexpr uint32_t kSide = 41;
  mesh::Mesh wall;
  for (int side = 0; side < 2; ++side) {
    const auto first = static_cast<uint32_t>(wall.positions.size());
    for (uint32_t i = 0; i < kSide * kSide; ++i) {
      wall.positions.emplace_back(static_cast<float>(i % kSide) / 20 - 1,
                                  static_cast<float>(i / kSide) / 20 - 1, side ? 0.004f : 0.0f);
      wall.normals.emplace_back(0.0f, 0.0f, side ? 1.0f : -1.0f);
    }
    for (uint32_t y = 0; y + 1 < kSide; ++y)
      for (uint32_t x = 0; x + 1 < kSide; ++x) {
        const uint32_t a = first + y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
        for (mesh::Triangle t : {mesh::Triangle{a, b, d}, mesh::Triangle{a, d, c}}) {
          if (side == 0) std::swap(t[1], t[2]);
          wall.triangles.push_back(t);
        }
      }
  }
  return wall;
}

TEST(TransferToMesh, BothSidesOfAWallKeepTheirValues) {
  const mesh::Mesh wall = thin_wall();
  const NetworkPtr cells = network(wall, "random", 0.1);
  const mesh::Mesh mesh =
      carried_to_mesh(wall, cells, [&](const Vec3f& p) { return p.z > 0.002f ? 1.0 : 0.0; });
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    ASSERT_EQ(values(mesh, "x")[v], mesh.positions[v].z > 0.002f ? 1 : 0);
}

TEST(TransferToMesh, CellsWithoutColourShowThePaintBelow) {
  mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 3);
  const NetworkPtr cells = network(ball, "random", 0.2);
  Simulation simulation(cells, RandomKey(1));
  auto& colour = simulation.attributes().column<Vec3f>("Cd").now;
  for (uint32_t i = 0; i < cells->size(); ++i)
    if (cells->position[i].y > 0) colour[i] = Vec3f(1, 0.5f, 0.25f);
  mesh::Attribute paint{"Cd", 3, {}};
  paint.values.assign(3 * ball.positions.size(), 0.125f);
  ball.attributes.push_back(paint);
  transfer_to_mesh(simulation, ball);
  const mesh::Attribute* made = mesh::find_attribute(ball, "Cd", 3);
  for (size_t v = 0; v < ball.positions.size(); ++v) {
    const float y = ball.positions[v].y;
    if (y > 0.4f) {
      ASSERT_EQ(made->values[3 * v + 1], 0.5f);
    }
    if (y < -0.4f) {
      ASSERT_EQ(made->values[3 * v + 1], 0.125f);
    }
  }
  EXPECT_EQ(ball.attributes.size(), 2u);  // Cd once, and transparent.
}

TEST(TransferToMesh, RemovedCellsAreTransparent) {
  mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 3);
  const NetworkPtr cells = network(ball, "random", 0.2);
  Simulation simulation(cells, RandomKey(1));
  simulation.set_states(std::vector<CellState>(cells->size(), CellState::transparent));
  transfer_to_mesh(simulation, ball);
  for (const float v : values(ball, "transparent")) ASSERT_EQ(v, 1);
}

// With wrong normals, vertices have no cells nearby with a similar normal.
TEST(TransferToMesh, VerticesFarFromCellsUseTheNearestWithASimilarNormal) {
  const mesh::Mesh ball = mesh::sphere_mesh(Vec3d(0), 1, 4);
  const NetworkPtr cells = network(ball, "random", 0.1);
  mesh::Mesh inverted = ball;
  inverted.normals.clear();
  for (const Vec3f& p : inverted.positions) inverted.normals.push_back(-p);
  const mesh::Mesh mesh = carried_to_mesh(inverted, cells, [](const Vec3f& p) { return p.y; });
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    ASSERT_TRUE(std::isfinite(values(mesh, "x")[v]));
    if (mesh.positions[v].y > 0.5f) {
      ASSERT_LT(values(mesh, "x")[v], 0.2f);
    }
  }
}

mesh::Mesh with_normals(mesh::Mesh mesh) {
  for (const Vec3f& p : mesh.positions) mesh.normals.push_back(p.normalized());
  return mesh;
}

TransferOptions moving() {
  TransferOptions options;
  options.move = true;
  return options;
}

TEST(TransferToMesh, HeightMovesASurfaceAlongItsNormal) {
  const mesh::Mesh ball = with_normals(mesh::sphere_mesh(Vec3d(0), 1, 4));
  Simulation simulation(network(ball, "random", 0.1), RandomKey(1));
  for (float& h : simulation.attributes().column<float>("height").now) h = -0.05F;
  mesh::Mesh moved = ball, still = ball;
  transfer_to_mesh(simulation, moved, moving());
  transfer_to_mesh(simulation, still);
  EXPECT_EQ(still.positions, ball.positions);
  for (size_t v = 0; v < ball.positions.size(); ++v) {
    ASSERT_NEAR(moved.positions[v].length(), 0.95, 1e-6);
    ASSERT_NEAR((moved.normals[v] - ball.normals[v]).length(), 0, 1e-5);
    ASSERT_EQ(values(moved, "height")[v], -0.05F);
  }
  // A tilt that raises one side and lowers the other rotates the normals.
  auto& height = simulation.attributes().column<float>("height").now;
  for (size_t i = 0; i < height.size(); ++i) height[i] = 0.2F * simulation.network().position[i].x;
  moved = ball;
  transfer_to_mesh(simulation, moved, moving());
  // The surface r = 1 + 0.2 x has the slope dr/dx = 0.2 at (0, 1, 0).
  for (size_t v = 0; v < ball.positions.size(); ++v)
    if (ball.positions[v].y > 0.999F) {
      EXPECT_NEAR(moved.normals[v].x / moved.normals[v].y - ball.positions[v].x, -0.2F, 0.03F);
    }
}

TEST(TransferToMesh, TheDisplacementIsAStage) {
  const mesh::Mesh ball = with_normals(mesh::sphere_mesh(Vec3d(0), 1, 3));
  Simulation simulation(network(ball, "random", 0.2), RandomKey(1));
  for (float& h : simulation.attributes().column<float>("height").now) h = -0.05F;
  mesh::Mesh moved = ball;
  std::vector<bool> is_moved;  // when the stage begins and when it ends
  Progress progress([&](const std::string& stage, double) {
    if (stage == "displacement by the cells") is_moved.push_back(moved.positions != ball.positions);
  });
  transfer_to_mesh(simulation, moved, moving(), progress);
  EXPECT_EQ(is_moved, std::vector<bool>({false, true}));
}

TEST(TransferToMesh, VerticesFollowTheirCells) {
  const mesh::Mesh ball = with_normals(mesh::sphere_mesh(Vec3d(0), 1, 3));
  Simulation simulation(network(ball, "random", 0.2), RandomKey(1));
  auto& place = simulation.attributes().column<Vec3f>("P").now;
  const Vec3f way(0.25F, -0.5F, 0.125F);
  for (size_t i = 0; i < place.size(); ++i) place[i] = simulation.network().position[i] + way;
  mesh::Mesh moved = ball;
  transfer_to_mesh(simulation, moved, moving());
  for (size_t v = 0; v < ball.positions.size(); ++v) {
    EXPECT_NEAR((moved.positions[v] - ball.positions[v] - way).length(), 0, 1e-6F);
    EXPECT_NEAR((moved.normals[v] - ball.normals[v]).length(), 0, 1e-5F);
  }
  EXPECT_FALSE(mesh::find_attribute(moved, "P"));
  EXPECT_FALSE(mesh::find_attribute(moved, ""));
  place[0].x = std::numeric_limits<float>::infinity();
  EXPECT_THROW(transfer_to_mesh(simulation, moved, moving()), Error);
}

}  // namespace
}  // namespace vug::cells
