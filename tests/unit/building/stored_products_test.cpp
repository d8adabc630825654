// SPDX-License-Identifier: Apache-2.0
// Products from a store equal those that are built from scratch, after any edits of a scene and
// with a store that is damaged meanwhile.
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/building/explain_products.h>
#include <vug/loading/load.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace vug::building {
namespace {

namespace fs = std::filesystem;

/// A small scene that edits change in one place after the other.
struct EditedScene {
  std::map<std::string, std::string> parts = {
      {"radius", "1m"},
      {"where", "(0.4, 0.9, 0)"},
      {"noise", "fbm(scale: 60cm, seed: 1)"},
      {"amount", "5cm"},
      {"blend", "smooth(10cm)"},
      {"voxel", "14cm"},
      {"width", "3"},
      {"region", ""},
      {"polish", "true"},
      {"paint", ""},
      {"piece", "0"},
      {"hardness", "20%"},
      {"adaptivity", "0%"},
      {"lamp", "(3, 3, 3)"},
      {"eye", "(0, 0, 5)"},
      {"comment", "first"},
      {"extra", ""},
      {"rule", "voronoi(steps: 3)"},
      {"mask", "height(from: -1, to: 1)"},
  };

  std::string text() const {
    const auto& p = parts;
    return fmt::format(
        "# {}\n"
        "let host = host_rock(sphere({}), of: \"shale\", contact: 20cm,\n"
        "  bodies: [made_of(half_space(), of: rock_material(\"lime\", hardness: {}))])\n"
        "let rough = displace(union([host, sphere(30cm).translate({}){}], blend: {}),\n"
        "  noise: {}, amount: {})\n"
        "volume rock = level_set(rough, voxel: {}, half_width: {}{})\n"
        "mesh skin on rock {{ polish {}  smallest_piece {}  adaptivity {}  {} }}\n"
        "volume copy on skin {{ voxel 20cm }}\n"
        "mesh cover on copy {{}}\n"
        "let high = {}\n"
        "cells worn on skin {{ spacing 25cm  run random_color(apart: 60cm), {}, set(attribute: "
        "\"grey\", to: high) }}\n"
        "object thing on skin {{}}\n"
        "camera main {{ eye {}  target (0, 0, 0) }}\n"
        "light lamp = sphere(center: {}, radius: 10cm, radiance: (1, 1, 1))\n",
        p.at("comment"), p.at("radius"), p.at("hardness"), p.at("where"), p.at("extra"),
        p.at("blend"), p.at("noise"), p.at("amount"), p.at("voxel"), p.at("width"), p.at("region"),
        p.at("polish"), p.at("piece"), p.at("adaptivity"), p.at("paint"), p.at("mask"),
        p.at("rule"), p.at("eye"), p.at("lamp"));
  }

  void edit(RandomStream& random) {
    static const std::vector<std::pair<const char*, std::vector<const char*>>> kEdits = {
        {"radius", {"1m", "90cm", "1.1m"}},
        {"where", {"(0.4, 0.9, 0)", "(0, 1, 0)", "(-0.9, 0.3, 0.2)"}},
        {"noise",
         {"fbm(scale: 60cm, seed: 1)", "fbm(scale: 60cm, seed: 2)", "ridged(scale: 50cm)"}},
        {"amount", {"5cm", "0cm", "8cm"}},
        {"blend", {"smooth(10cm)", "sharp", "chamfer(10cm)"}},
        {"voxel", {"14cm", "17cm"}},
        {"width", {"3", "4"}},
        {"region", {"", ", from: (-1, -1, -1), to: (1, 1.1, 1)"}},
        {"polish", {"true", "false"}},
        {"paint",
         {"",
          "paint layer(under: (0.5, 0.4, 0.3), over: (0.2, 0.2, 0.2), mask: height(from: 0, to: "
          "1))"}},
        {"piece", {"0", "20cm"}},
        {"hardness", {"20%", "60%"}},
        {"adaptivity", {"0%", "40%"}},
        {"lamp", {"(3, 3, 3)", "(2, 3, 3)"}},
        {"eye", {"(0, 0, 5)", "(0, 1, 5)"}},
        {"comment", {"first", "second"}},
        {"extra", {"", ", torus(radius: 70cm, tube: 10cm)"}},
        {"rule", {"voronoi(steps: 3)", "voronoi(steps: 4)", "life(steps: 2)"}},
        {"mask", {"height(from: -1, to: 1)", "slope(from: 0deg, to: 60deg)"}},
    };
    const auto& [name, values] = kEdits[random.below(static_cast<uint32_t>(kEdits.size()))];
    parts[name] = values[random.below(static_cast<uint32_t>(values.size()))];
  }
};

/// The digests of all products, by name.
std::map<std::string, std::string> products_of(const std::string& text, const StoreUse& use) {
  const loading::Loaded loaded = loading::load_text(text, "edited.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  BuildOptions options;
  options.stored = use;
  Builder builder(loaded.shot, options);
  std::map<std::string, std::string> out;
  for (const shot::MeshPtr& plan : loaded.shot.meshes) {
    out["mesh " + plan->name] = mesh::digest(*builder.mesh(plan)).hex();
    out["pieces of " + plan->name] = std::to_string(builder.components_removed(plan));
    for (const volume::SmallFeature& each : builder.small_features(plan))
      out["features of " + plan->name] += to_string(each.kind) + digest_of(each.at).hex();
  }
  for (const shot::VolumePtr& plan : loaded.shot.volumes) {
    const volume::LevelSet& level_set = builder.level_set(plan);
    out["volume " + plan->name] = level_set.content().hex();
    EXPECT_EQ(level_set.name(), "");
    EXPECT_EQ(level_set.metadata().size(), 1u) << "the class of the grid";
  }
  return out;
}

StoreUse use_of(const fs::path& folder, size_t* reused = nullptr) {
  StoreUse use;
  use.store = std::make_shared<store::Store>(store::StoreOptions{folder, 1'000'000'000});
  use.least_seconds = 0;
  use.scene = "edited.vug";
  if (reused)
    use.on_product = [reused](const ProductReport& report) { *reused += report.reused ? 1 : 0; };
  return use;
}

void damage_a_file(const fs::path& folder, RandomStream& random) {
  std::vector<fs::path> files;
  for (const auto& each : fs::recursive_directory_iterator(folder))
    if (each.is_regular_file()) files.push_back(each.path());
  if (files.empty()) return;
  std::sort(files.begin(), files.end());
  const fs::path& file = files[random.below(static_cast<uint32_t>(files.size()))];
  std::error_code gone;
  const uint64_t size = fs::file_size(file, gone);
  if (gone) return;
  switch (random.below(3)) {
    case 0:
      fs::resize_file(file, size / 2, gone);
      break;
    case 1:
      fs::remove(file, gone);
      break;
    default: {
      std::fstream io(file, std::ios::binary | std::ios::in | std::ios::out);
      io.seekp(static_cast<std::streamoff>(random.below(static_cast<uint32_t>(size + 1))));
      io.put('\x55');
    }
  }
}

/// Edits the scene step by step; each time the products equal those without a store.
void run_script(uint64_t script, int steps, const fs::path& folder, bool damage) {
  RandomStream random(RandomKey(17).at(script));
  EditedScene scene;
  size_t reused = 0;
  std::map<std::string, std::map<std::string, std::string>> known;
  for (int step = 0; step < steps; ++step) {
    scene.edit(random);
    if (damage) damage_a_file(folder, random);
    const std::string text = scene.text();
    const auto [scratch, is_new] = known.try_emplace(text);
    if (is_new) scratch->second = products_of(text, {});
    ASSERT_EQ(products_of(text, use_of(folder, &reused)), scratch->second)
        << "script " << script << ", step " << step << "\n"
        << text;
  }
  EXPECT_GT(reused, static_cast<size_t>(steps) / 3);
}

TEST(StoredProducts, EqualThoseFromScratchAfterEdits) {
  for (uint64_t script = 0; script < 10; ++script) {
    const ScratchFolder scratch("vug_stored_test");
    run_script(script, 6, scratch.path(), false);
  }
}

// VUG_LONG_TESTS runs ten scripts instead of two.
TEST(StoredProductsLong, EqualThoseFromScratchAfterEdits) {
  const uint64_t scripts = std::getenv("VUG_LONG_TESTS") ? 10 : 2;
  for (uint64_t script = 0; script < scripts; ++script) {
    const ScratchFolder scratch("vug_stored_test");
    run_script(script, 100, scratch.path(), false);
  }
}

TEST(StoredProducts, EqualThoseFromScratchWithADamagedStore) {
  const ScratchFolder scratch("vug_stored_test");
  for (uint64_t script = 100; script < 104; ++script) run_script(script, 8, scratch.path(), true);
}

TEST(StoredProducts, EqualThoseFromScratchWithASharedStore) {
  const ScratchFolder scratch("vug_stored_test");
  std::vector<std::thread> users;
  for (uint64_t user = 0; user < 4; ++user)
    users.emplace_back([&, user] { run_script(200 + user % 2, 5, scratch.path(), user == 3); });
  for (std::thread& each : users) each.join();
}

/// The kinds and names of the products that were built, not reused.
std::vector<std::string> built(const std::string& text, const fs::path& folder) {
  std::vector<std::string> out;
  StoreUse use = use_of(folder);
  use.on_product = [&](const ProductReport& report) {
    if (!report.reused)
      out.push_back(
          fmt::format("{} {}: {}", report.kind, report.name,
                      report.changed ? fmt::format("{}", fmt::join(*report.changed, ",")) : "new"));
  };
  products_of(text, use);
  return out;
}

TEST(StoredProducts, OnlyChangedPartsAreBuilt) {
  const ScratchFolder scratch("vug_stored_test");
  EditedScene scene;
  EXPECT_EQ(
      built(scene.text(), scratch.path()),
      (std::vector<std::string>{"level_set rock: new", "mesh skin: new", "level_set copy: new",
                                "mesh cover: new", "cell_mesh worn: new"}));
  const std::vector<std::string> nothing;
  EXPECT_EQ(built(scene.text(), scratch.path()), nothing);
  scene.parts["comment"] = "another";
  scene.parts["lamp"] = "(9, 9, 9)";
  scene.parts["eye"] = "(1, 2, 9)";
  EXPECT_EQ(built(scene.text(), scratch.path()), nothing);
  scene.parts["paint"] =
      "paint layer(under: (0.5, 0.4, 0.3), over: (0.2, 0.2, 0.2), mask: height(from: 0, to: 2))";
  EXPECT_EQ(built(scene.text(), scratch.path()),
            std::vector<std::string>{"cell_mesh worn: cells,mesh,support_0"})
      << "colours are attributes, which cells may read";
  scene.parts["rule"] = "voronoi(steps: 2)";
  EXPECT_EQ(built(scene.text(), scratch.path()),
            std::vector<std::string>{"cell_mesh worn: cells,use"});
  scene.parts["polish"] = "false";
  const std::vector<std::string> after = built(scene.text(), scratch.path());
  ASSERT_FALSE(after.empty());
  EXPECT_EQ(after[0], "mesh skin: polish");
  scene.parts["radius"] = "95cm";
  EXPECT_EQ(built(scene.text(), scratch.path())[0], "level_set rock: field");
}

TEST(StoredProducts, CanBeExplainedBeforeTheyAreBuilt) {
  const ScratchFolder scratch("vug_stored_test");
  EditedScene scene;
  const auto explain = [&] {
    const loading::Loaded loaded = loading::load_text(scene.text(), "edited.vug");
    return explain_products(loaded.shot, use_of(scratch.path()));
  };
  for (const ProductReport& each : explain()) {
    EXPECT_FALSE(each.reused);
    EXPECT_FALSE(each.changed);
  }
  products_of(scene.text(), use_of(scratch.path()));
  for (const ProductReport& each : explain()) EXPECT_TRUE(each.reused) << each.name;
  scene.parts["adaptivity"] = "30%";
  for (const ProductReport& each : explain())
    if (each.kind == "mesh" && each.name == "skin") {
      EXPECT_FALSE(each.reused);
      EXPECT_EQ(each.changed, std::vector<std::string>{"adaptivity"});
    }
}

// A stored mesh needs neither the level set nor what the field defers.
TEST(StoredProducts, AStoredMeshComputesNothing) {
  const ScratchFolder scratch("vug_stored_test");
  const std::string text =
      "let rock = popcorn(box(size: (1, 1, 1)), from: (-1, 0.3, -1), to: (1, 1, 1), spacing: 8cm,\n"
      "  diameter: 4cm)\n"
      "volume cave = level_set(rock, voxel: 5cm)\nmesh skin on cave {}\nobject o on skin {}\n";
  std::vector<std::string> stages;
  const auto run = [&] {
    stages.clear();
    const loading::Loaded loaded = loading::load_text(text, "t.vug");
    EXPECT_TRUE(loaded.usable()) << loaded.report();
    BuildOptions options;
    options.stored = use_of(scratch.path());
    Progress progress([&](const std::string& stage, double) { stages.push_back(stage); });
    Builder builder(loaded.shot, options, progress);
    builder.compute_deferred(loaded.shot);
    builder.require_mesh_memory(loaded.shot.meshes.at(0));
    return mesh::digest(*builder.mesh(loaded.shot.meshes.at(0))).hex();
  };
  const std::string first = run();
  EXPECT_FALSE(stages.empty());
  EXPECT_EQ(run(), first);
  EXPECT_EQ(stages, std::vector<std::string>()) << "no stage of work";
}

}  // namespace
}  // namespace vug::building
