// SPDX-License-Identifier: Apache-2.0
// The bytes of products may only change together with the epoch of their kind, or else the stores
// of users would return products of earlier versions.
#include <vug/base/binary_value.h>
#include <vug/building/builder.h>
#include <vug/building/product_keys.h>
#include <vug/loading/load.h>
#include <vug/shot/drips_plan.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace vug::building {
namespace {

using Json = nlohmann::ordered_json;

const std::string kFile = VUG_TEST_DATA "/product_digests.json";

/// Fields of all families, with 10 to 30 voxels along each axis.
const std::vector<std::pair<std::string, std::string>> kFields = {
    {"sphere", "sphere(1m)"},
    {"box", "box(size: (2, 1, 1.5), rounding: 10cm).rotate(angle: 30deg)"},
    {"torus", "torus(radius: 80cm, tube: 30cm)"},
    {"prism", "prism(sides: 5, radius: 90cm, height: 1.5m)"},
    {"ellipsoid", "ellipsoid(radii: (1, 0.6, 0.4))"},
    {"lathe", "lathe(radii: [0, 0.8, 0.3, 0], heights: [-1, -0.8, 0.9, 1])"},
    {"stalactite", "stalactite(length: 1.6m, radius: 30cm)"},
    {"stalagmite", "stalagmite(height: 1.2m, radius: 40cm)"},
    {"drapery",
     "drapery(path: [(-1, 0, 0), (0, -0.2, 0.1), (1, -0.5, 0)], width: 60cm, thickness: 10cm)"},
    {"gyroid", "intersection([gyroid(period: 1m, thickness: 25cm), sphere(1m)])"},
    {"travertine_dome", "travertine_dome(radius: 1m)"},
    {"helictite", "helictite(length: 1m, radius: 6cm, seed: 3)"},
    {"smooth_union", "union([sphere(70cm), box(size: (2, 0.5, 0.5))], blend: smooth(30cm))"},
    {"chamfer", "difference(box(size: (2, 1, 1)), cuts: [sphere(60cm)], blend: chamfer(20cm))"},
    {"morph", "morph(sphere(1m), box(size: (1.5, 1.5, 1.5)), amount: 40%)"},
    {"shell", "shell(sphere(1m), thickness: 25cm)"},
    {"offset", "offset(box(size: (1.4, 1, 1)), by: 20cm)"},
    {"twist", "twist(box(size: (0.8, 2, 0.8)), rate: 0.6)"},
    {"bend", "bend(box(size: (2, 0.4, 0.6)), rate: 0.5)"},
    {"taper", "taper(box(size: (1, 2, 1)), from: 1, to: 0.4)"},
    {"warp", "warp(sphere(90cm), scale: 70cm, amount: 15cm)"},
    {"repeat", "repeat(sphere(30cm), spacing: (0.7, 0, 0.7), counts: (3, 0, 3))"},
    {"fbm", "displace(sphere(90cm), noise: fbm(scale: 50cm), amount: 12cm)"},
    {"ridged", "displace(sphere(90cm), noise: ridged(scale: 50cm), amount: 12cm)"},
    {"worley", "displace(sphere(90cm), noise: worley(scale: 50cm), amount: 12cm)"},
    {"scallops", "displace(box(size: (2, 1, 1)), noise: scallops(size: 40cm), amount: 10cm)"},
    {"joints", "displace(sphere(90cm), noise: joints(spacing: 50cm), amount: 12cm)"},
    {"strata", "strata(sphere(1m), depth: 15cm, thickness: 30cm)"},
    {"pendants", "pendants(box(size: (2, 1, 2)), spacing: 50cm, width: 20cm, height: 30cm)"},
    {"spongework", "spongework(box(size: (2, 1, 1)), size: 40cm, depth: 30cm)"},
    {"popcorn",
     "popcorn(box(size: (1, 1, 1)), from: (-1, 0.3, -1), to: (1, 1, 1), spacing: 15cm, diameter: "
     "10cm)"},
    {"cupolas",
     "cupolas(box(size: (3, 1.2, 3)) - box(size: (2.6, 0.5, 2.6)), from: (-1, -0.6, -1), to: (1, "
     "0.6, 1), spacing: 80cm, diameter: 60cm)"},
    {"rimstone", "rimstone(half_space(normal: (0.2, 1, 0)), height: 20cm)"},
    {"host_rock",
     "host_rock(sphere(1m), of: \"shale\", contact: 20cm, bodies: [made_of(half_space(), of: "
     "\"lime\")])"},
    {"passages", "passages(of: plan)"},
    {"breakdown", "breakdown(at: (0, 2, 0), span: 6m, length: 6m, floor: 0m)"},
    {"dripstone",
     "dripstone(box(size: (4, 3, 4)) - box(size: (3, 2, 3)), from: (-1.5, -1, -1.5), to: (1.5, "
     "1.2, 1.5), spacing: 60cm, tip: 6cm, seed: 2)"},
};

Json digests_of(const std::string& field) {
  const std::string text =
      "network plan = graph(names: [\"a\", \"b\", \"c\"],\n"
      "  at: [(0, 0, 0), (3, 0.2, 0), (5, 0, 2)], paths: [\"a b c\"])\n"
      "let solid = " +
      field +
      "\n"
      "volume rock = level_set(solid, voxel: 12cm, from: (-2, -2, -2), to: (2, 2, 2))\n"
      "mesh skin on rock {}\n";
  const loading::Loaded loaded = loading::load_text(text, "epoch.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  if (!loaded.usable()) return nullptr;
  Builder builder(loaded.shot);
  return {{"level_set", builder.level_set(loaded.shot.volumes.at(0)).content().hex()},
          {"mesh", mesh::digest(*builder.mesh(loaded.shot.meshes.at(0))).hex()}};
}

/// Runs of cells of all families of rules, with about 700 cells.
const std::vector<std::pair<std::string, std::string>> kCells = {
    {"cracks",
     "random_color(apart: 40cm), voronoi(steps: 6), crack(begin: 6), wake(begin: 7), "
     "spreading_color(begin: 7, steps: 3)"},
    {"wear", "erosion(steps: 4), corrosion(steps: 4), dust(steps: 3), crust(steps: 3)"},
    {"water", "run_off(steps: 12), moisture(begin: 6, steps: 6), film(steps: 4)"},
    {"life", "life(steps: 4), moss(steps: 6), lichen(steps: 6)"},
    {"patterns", "gray_scott(steps: 10), maze(begin: 10, steps: 4)"},
    {"growth", "calcite(steps: 4), efflorescence(steps: 4)"},
};

Json digests_of_cells(const std::string& rules) {
  const loading::Loaded loaded = loading::load_text(
      "volume rock = level_set(displace(sphere(90cm), noise: fbm(scale: 50cm), amount: 12cm), "
      "voxel: 10cm)\n"
      "mesh skin on rock {}\ncells worn on skin { spacing 12cm  run " +
          rules + " }\n",
      "epoch.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  if (!loaded.usable()) return nullptr;
  Builder builder(loaded.shot);
  return {{kCellMeshKind.name, mesh::digest(*builder.mesh(loaded.shot.meshes.at(1))).hex()}};
}

template <class T>
std::string digest_of_file(const T& value) {
  std::ostringstream out;
  write_value(out, value);
  return digest(out.str()).hex();
}

Json digests_of_drips(const std::string& more) {
  const loading::Loaded loaded = loading::load_text(
      "drips water = seepage(complement(box(size: (3, 2, 3))), from: (-1.5, -1.2, -1.5), to: (1.5, "
      "1.2, 1.5), spacing: 30cm, joints: [fractures(azimuth: 107deg, dip: 84deg, spacing: 1m)]" +
          more + ")\n",
      "epoch.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  if (!loaded.usable()) return nullptr;
  const shot::DripsPlan& plan = *loaded.shot.drips.at(0).drips;
  const drips::GrownForms& grown = plan.grown();
  return {{kDripGraphKind.name, digest_of_file(plan.graph())},
          {kGrownFormsKind.name, digest_of_file(grown)}};
}

TEST(Epochs, IncreaseWhenTheBytesOfProductsChange) {
  Json epochs;
  for (const store::ProductKind& kind :
       {kLevelSetKind, kMeshKind, kCellMeshKind, kDripGraphKind, kGrownFormsKind})
    epochs[kind.name] = kind.epoch;
  Json now = {{"epochs", epochs}, {"products", Json::object()}};
  for (const auto& [name, field] : kFields) now["products"][name] = digests_of(field);
  for (const auto& [name, rules] : kCells)
    now["products"]["cells: " + name] = digests_of_cells(rules);
  now["products"]["drips: many"] = digests_of_drips(", draperies: 100%, broken: 50%");
  now["products"]["drips: bare"] = digests_of_drips(", flowstone: 0%, straws: 100%");

  Json before = {{"epochs", Json::object()}, {"products", Json::object()}};
  if (std::ifstream in(kFile); in) before = Json::parse(in);
  std::map<std::string, std::string> changed;  // The first product of each kind with other bytes.
  for (const auto& [name, kinds] : before["products"].items())
    for (const auto& [kind, digest] : kinds.items())
      if (now["products"].contains(name) && now["products"][name][kind] != digest)
        changed.emplace(kind, name);
  for (const auto& [kind, product] : changed)
    EXPECT_NE(before["epochs"][kind], epochs[kind])
        << "the bytes of '" << product
        << "' and perhaps others have changed: increase the epoch of '" << kind
        << "' in lib/vug/building/product_keys.h, and run this test with VUG_UPDATE=1";
  if (HasFailure()) return;
  if (std::getenv("VUG_UPDATE")) {
    std::ofstream(kFile) << now.dump(1) << "\n";
    return;
  }
  EXPECT_EQ(now, before) << "run this test with VUG_UPDATE=1 to record the new digests in "
                         << kFile;
}

}  // namespace
}  // namespace vug::building
