// SPDX-License-Identifier: Apache-2.0
// The species of data/bamboo compared with measurements, for many seeds.
#include <vug/building/flat_scene.h>
#include <vug/flora/sweep_field.h>
#include <vug/flora/sweep_mesh.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>
#include <vug/shot/lsystem_plan.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace vug::loading {
namespace {

/// The plant of a seed, by default without leaves.
lsystem::DrawingPtr grown(const std::string& species, uint64_t seed, bool leaves = false) {
  LoadOptions options;
  options.seed = seed;
  options.include_folders = {std::filesystem::path(VUG_DATA)};
  if (!leaves) options.overrides = {{"LEAVES", "0"}};
  const Loaded loaded =
      load_text(fmt::format("include \"bamboo/{}_growth.vug\"\n", species), "test.vug", options);
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  EXPECT_EQ(loaded.shot.lsystems.size(), 1u);
  return loaded.shot.lsystems.at(0)->drawing();
}

/// Lengths of a culm's internodes, from node to node and to its end.
std::vector<double> internodes(const lsystem::Axis& culm) {
  std::vector<double> lengths;
  for (size_t i = 0; i < culm.nodes.size(); ++i)
    lengths.push_back((i + 1 < culm.nodes.size() ? culm.nodes[i + 1].along : culm.length()) -
                      culm.nodes[i].along);
  return lengths;
}

double middle(const lsystem::Axis& culm, size_t internode) {
  return culm.nodes[internode].along + 0.5 * internodes(culm)[internode];
}

struct Line {
  double slope = 0, share = 0;  ///< share: R^2, of the variance that the line explains
};
Line fitted(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double my = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, xy = 0, yy = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
    yy += (y[i] - my) * (y[i] - my);
  }
  return {xy / xx, xy * xy / (xx * yy)};
}

/// The angle of a branch about the culm, relative to the culm's frame at its node.
double azimuth(const lsystem::Axis& culm, const lsystem::Node& node, const Vec3d& way) {
  const Frame frame = lsystem::station_at(culm, node.along).frame;
  return std::atan2(way.dot(frame.binormal), way.dot(frame.normal));
}

double apart(double a, double b) { return std::fabs(std::remainder(a - b, 2 * kPi)); }

constexpr double kDegree = kPi / 180;

class Moso : public testing::TestWithParam<uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Moso, testing::Values(1, 1000, 77000));

TEST_P(Moso, GrowsAsMeasuredOverTwoHundredSeeds) {
  double nodes = 0;
  for (uint64_t seed = GetParam(); seed < GetParam() + 200; ++seed) {
    const lsystem::DrawingPtr plant = grown("moso", seed);
    const lsystem::Axis& culm = plant->axes.at(0);
    const std::vector<double> lengths = internodes(culm);
    ASSERT_GE(culm.nodes.size(), 53u);
    ASSERT_LE(culm.nodes.size(), 67u);
    nodes += static_cast<double>(culm.nodes.size()) / 200;
    ASSERT_NEAR(std::accumulate(lengths.begin(), lengths.end(), 0.0), culm.length(), 1e-6);
    const auto longest =
        static_cast<size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    ASSERT_GE(middle(culm, longest) / culm.length(), 0.47);
    ASSERT_LE(middle(culm, longest) / culm.length(), 0.52);
    std::vector<double> heights, diameters;
    for (size_t i = 0; i < lengths.size(); ++i) {
      const double at = middle(culm, i);
      if (at < 0.1 * culm.length()) continue;  // the butt swells
      heights.push_back(at / culm.length());
      diameters.push_back(2 * lsystem::station_at(culm, at).radius);
    }
    ASSERT_GT(fitted(heights, diameters).share, 0.98);
    std::vector<double> sides;
    for (const lsystem::Node& node : culm.nodes) {
      if (node.along < 0.4 * culm.length()) {
        ASSERT_TRUE(node.branches.empty()) << seed;
      }
      if (node.branches.empty()) continue;
      ASSERT_EQ(node.branches.size(), 2u);
      const double a = azimuth(culm, node, node.branches[0]),
                   b = azimuth(culm, node, node.branches[1]);
      ASSERT_LT(apart(a, b), 10 * kDegree);
      if (!sides.empty()) {
        ASSERT_LT(apart(a, sides.back() + kPi), 10 * kDegree) << seed;
        ASSERT_LT(apart(b, sides.back() + kPi), 10 * kDegree) << seed;
      }
      sides.push_back(a);
    }
    ASSERT_GT(sides.size(), 20u);
  }
  EXPECT_GT(nodes, 58.1);
  EXPECT_LT(nodes, 60.4);
}

TEST_P(Moso, HeightGoesWithDiameter) {
  std::vector<double> heights, diameters;
  for (uint64_t seed = GetParam() + 1000; seed < GetParam() + 1300; ++seed) {
    const lsystem::DrawingPtr plant = grown("moso", seed);
    const lsystem::Axis& culm = plant->axes.at(0);
    heights.push_back(std::log(culm.length()));
    diameters.push_back(std::log(2 * lsystem::station_at(culm, 1.3).radius));
  }
  EXPECT_NEAR(fitted(diameters, heights).slope, 0.629, 0.03);
}

TEST(Internodes, OfMosoFollowTheClosedForm) {
  const lsystem::DrawingPtr plant = grown("moso", 7);
  const lsystem::Axis& culm = plant->axes.at(0);
  const double a = 0.56343, n = static_cast<double>(culm.nodes.size());
  for (size_t i = 0; i < culm.nodes.size(); ++i) {
    const double t =
        0.5 + a * std::tanh((2 * static_cast<double>(i) / n - 1) * std::atanh(0.5 / a));
    EXPECT_NEAR(culm.nodes[i].along, t * culm.length(), 1e-6);
  }
}

TEST(Ci, HasItsInternodesWallsTipsAndBranches) {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const lsystem::DrawingPtr plant = grown("ci", seed);
    const lsystem::Axis& culm = plant->axes.at(0);
    for (const double length : internodes(culm)) {
      ASSERT_GE(length, 0.15) << seed;
      ASSERT_LE(length, 0.60) << seed;
    }
    ASSERT_GE(culm.length(), 5);
    ASSERT_LE(culm.length(), 12);
    EXPECT_LT(culm.stations.back().frame.tangent.y, 0) << "the tip hangs";
    double highest = 0;
    for (const lsystem::Station& s : culm.stations) highest = std::max(highest, s.position.y);
    EXPECT_LT(culm.stations.back().position.y, highest - 0.1);
    const auto last = culm.nodes.size() - 1;
    for (size_t i = 0; i < last; ++i)
      if (culm.nodes[i].along > 0.5 * culm.length()) {
        ASSERT_GE(culm.nodes[i].branches.size(), 5u);
      }
  }
}

TEST(Ci, WallsAreEightToTwelveMillimetresThick) {
  LoadOptions options;
  options.include_folders = {std::filesystem::path(VUG_DATA)};
  options.overrides = {{"LEAVES", "0"}};
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    options.seed = seed;
    const Loaded loaded = load_text("include \"bamboo/ci.vug\"\n", "test.vug", options);
    ASSERT_TRUE(loaded.usable()) << loaded.report();
    const lsystem::Axis& culm = loaded.shot.lsystems.at(0)->drawing()->axes.at(0);
    const mesh::MeshPtr& plan = loaded.shot.meshes.back()->file_mesh;
    int met = 0;
    for (size_t i = 0; i < plan->positions.size(); ++i) {
      const auto number = [&](const char* name) {
        return static_cast<double>(mesh::find_attribute(*plan, name)->values[i]);
      };
      const double along = number("along");
      // Further up the culm is nearly as thin as its walls.
      if (number("inside") < 1 || number("order") > 0 || number("radius") < 0.013 || along == 0)
        continue;
      const Vec3d middle = lsystem::station_at(culm, along).position;
      const double inner = (Vec3d(plan->positions[i]) - middle).length();
      if (inner < 0.05 * number("radius")) continue;  // the middle of a diaphragm
      EXPECT_GT(number("radius") - inner, 0.008) << seed;
      EXPECT_LT(number("radius") - inner, 0.012) << seed;
      ++met;
    }
    EXPECT_GT(met, 20);
  }
}

TEST(Bamboo, AMosoWithItsLeavesIsAPrototype) {
  const lsystem::DrawingPtr plant = grown("moso", 3, true);
  EXPECT_GE(plant->instances.size(), 5000u);
  int orders = 0;
  for (const lsystem::Axis& axis : plant->axes) orders = std::max(orders, axis.order);
  EXPECT_GE(orders, 2);
  const mesh::Mesh mesh = flora::swept_mesh(flora::tubes(*plant, {}));
  const mesh::Topology topology = mesh::inspect(mesh);
  EXPECT_TRUE(topology.closed());
  EXPECT_EQ(topology.misoriented_edges, 0u);
  EXPECT_EQ(topology.nonmanifold_vertices, 0u);
}

/// A rotation about an axis with a translation.
lsystem::Axis tilted(lsystem::Axis axis, const Vec3d& about, double angle, const Vec3d& off) {
  const auto turn = [&](const Vec3d& v) { return rotated(v, about, angle); };
  for (lsystem::Station& s : axis.stations) {
    s.position = turn(s.position) + off;
    s.frame = Frame{turn(s.frame.tangent), turn(s.frame.normal), Vec3d(0)}.orthonormalized();
  }
  for (lsystem::Node& node : axis.nodes)
    for (Vec3d& way : node.branches) way = turn(way);
  return axis;
}

// VUG_LONG_TESTS grows a thousand culms instead of 150.
TEST(Bamboo, NoCulmExceedsItsBox) {
  const char* species[] = {"moso", "ci", "spectabilis"};
  const uint64_t culms = std::getenv("VUG_LONG_TESTS") ? 1000 : 150;
  for (uint64_t seed = 0; seed < culms; ++seed) {
    RandomStream random(RandomKey(seed).at("tilt"));
    lsystem::Drawing plant = *grown(species[seed % 3], seed + 1);
    if (plant.axes.size() > 7) plant.axes.resize(7);  // the culm and its lowest branches
    const Vec3d about =
        Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    const Vec3d off(random.uniform(-50, 50), random.uniform(-50, 50), 0);
    const double angle = random.uniform(0, kPi);
    for (lsystem::Axis& axis : plant.axes) axis = tilted(axis, about, angle, off);
    flora::SweepOptions options;
    options.displacement.groove = 0.1 * random.uniform();
    options.displacement.scar = 0.3 * random.uniform();
    options.displacement.ridge = 0.3 * random.uniform();
    options.wall = 0.3;
    options.open = seed % 2 == 0;
    const std::vector<flora::Tube> tubes = flora::tubes(plant, options);
    flora::MeshOptions rough;
    rough.tolerance = 1e-3;
    const Box3d whole = flora::swept(tubes).bounds();
    for (const flora::Tube& tube : tubes) {
      const Box3d box = vug::grown(tube.bounds(), 1e-5);  // vertices are single precision
      const mesh::Mesh shown = flora::swept_mesh({tube}, rough);
      for (const Vec3f& p : shown.positions) {
        ASSERT_TRUE(box.intersects(Vec3d(p))) << species[seed % 3] << " " << seed;
        ASSERT_TRUE(vug::grown(whole, 1e-5).intersects(Vec3d(p)))
            << species[seed % 3] << " " << seed;
      }
    }
  }
}

TEST(Bamboo, VolumeAndMeshDifferByHalfAVoxelAtMost) {
  for (const auto& [species, wall] : {std::pair("moso", "20%"), std::pair("ci", "0")}) {
    for (const char* voxel : {"3mm", "6mm"}) {
      LoadOptions options;
      options.include_folders = {std::filesystem::path(VUG_DATA)};
      options.overrides = {{"LEAVES", "0"}};
      options.seed = 12;
      const Loaded loaded = load_text(
          fmt::format("include \"bamboo/{}_growth.vug\"\n"
                      "let piece = stems(of: plant, orders: 1, from: 5.1, to: 5.9, wall: {})\n"
                      "volume solid = level_set(piece, voxel: {})\nmesh bark {{ of piece }}\n",
                      species, wall, voxel),
          "test.vug", options);
      ASSERT_TRUE(loaded.usable()) << loaded.report();
      building::Builder builder(loaded.shot);
      const volume::LevelSet& grid = builder.level_set(loaded.shot.volumes.at(0));
      const mesh::MeshPtr mesh = builder.mesh(loaded.shot.meshes.at(0));
      double most = 0;
      for (size_t t = 0; t < mesh->triangles.size(); ++t) {
        const auto [a, b, c] = mesh::corners(*mesh, t);
        most = std::max(most, std::fabs(grid.value((a + b + c) / 3)));
      }
      EXPECT_LE(most, 0.5 * grid.voxel()) << species << " " << voxel;
    }
  }
}

TEST(Bamboo, LeavesAreCutByAPictureAndEachIsAnother) {
  for (const char* species : {"moso", "ci", "spectabilis"}) {
    LoadOptions options;
    options.include_folders = {std::filesystem::path(VUG_DATA)};
    options.seed = 3;
    const Loaded loaded =
        load_text(fmt::format("include \"bamboo/{}.vug\"\n", species), "test.vug", options);
    ASSERT_TRUE(loaded.usable()) << loaded.report();
    building::Builder builder(loaded.shot);
    std::map<const render::Material*, size_t> forms;
    for (const render::Object& object : building::flatten_scene(builder).objects)
      if (object.material->thin()) {
        EXPECT_TRUE(object.material->cut_out()) << species;
        forms[object.material.get()] += 1;
      }
    EXPECT_EQ(forms.size(), 3u) << species;
    for (const auto& [material, count] : forms) EXPECT_GT(count, 300u) << species;

    const lsystem::DrawingPtr plant = grown(species, 3, true);
    double least = 1, most = 0, up = 0, spread = 0;
    for (const lsystem::Instance& leaf : plant->instances) {
      least = std::min(least, leaf.size), most = std::max(most, leaf.size);
      // Faces up rather than down, tips down rather than up, but no two alike.
      up += leaf.frame.binormal.y / static_cast<double>(plant->instances.size());
      spread +=
          leaf.frame.tangent.y < -0.3 ? 1.0 / static_cast<double>(plant->instances.size()) : 0;
    }
    EXPECT_GT(most, 1.7 * least) << species;
    EXPECT_GT(up, 0.1) << species;
    EXPECT_GT(spread, 0.5) << species;
    EXPECT_LT(spread, 1) << species;
  }
}

}  // namespace
}  // namespace vug::loading
