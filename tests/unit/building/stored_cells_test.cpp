// SPDX-License-Identifier: Apache-2.0
// Meshes with cells from a store equal those whose cells run, and a change of anything that the
// cells depend on makes them run again.
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vug::building {
namespace {

namespace fs = std::filesystem;

const std::string kScene =
    "param gain = 1 in 0..3\n"
    "let bright = multiply([height(from: -1, to: 1), gain / 3])\n"
    "volume rock = level_set(sphere(60cm), voxel: 9cm)\n"
    "mesh skin on rock {}\n"
    "cells worn on skin {\n"
    "  spacing 12cm  relax 2  holes true\n"
    "  run random_color(apart: 50cm), voronoi(steps: 5), crack(begin: 5, where: bright),\n"
    "      set(begin: 6, attribute: \"height\", to: multiply([bright, 0.02]))\n"
    "}\n"
    "object thing on worn {}\n"
    "light lamp = sphere(center: (3, 3, 3), radius: 10cm, radiance: (1, 1, 1))\n"
    "camera main { eye (0, 0, 5)  target (0, 0, 0) }\n";

struct CellsRun {
  std::string mesh;
  size_t cell_layers = 0, reused = 0;
};

CellsRun run_cells(const std::string& text, const fs::path& folder,
                   const loading::LoadOptions& load = {}) {
  const loading::Loaded loaded = loading::load_text(text, (folder / "cells.vug").string(), load);
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  CellsRun out;
  BuildOptions options;
  if (!folder.empty())
    options.stored.store =
        std::make_shared<store::Store>(store::StoreOptions{folder, 1'000'000'000});
  options.stored.least_seconds = 0;
  options.stored.on_product = [&](const ProductReport& report) {
    out.reused += report.kind == "cell_mesh" && report.reused ? 1 : 0;
  };
  Builder builder(loaded.shot, options);
  out.mesh = mesh::digest(*builder.mesh(loaded.shot.objects.at(0).mesh)).hex();
  out.cell_layers = builder.counts().cell_layers;
  return out;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(StoredCells, EqualThoseThatRan) {
  const ScratchFolder scratch("vug_stored_cells");
  const CellsRun alone = run_cells(kScene, {});
  EXPECT_EQ(alone.cell_layers, 1u);
  const CellsRun first = run_cells(kScene, scratch.path());
  EXPECT_EQ(first.mesh, alone.mesh);
  EXPECT_EQ(first.cell_layers, 1u);
  EXPECT_EQ(first.reused, 0u);
  for (const std::string& text :
       {kScene, changed(kScene, "(3, 3, 3)", "(4, 3, 3)"),
        changed(kScene, "(0, 0, 5)", "(0, 1, 5)"), "# a comment\n" + kScene}) {
    const CellsRun again = run_cells(text, scratch.path());
    EXPECT_EQ(again.mesh, alone.mesh);
    EXPECT_EQ(again.cell_layers, 0u) << text;
    EXPECT_EQ(again.reused, 1u) << text;
  }
}

TEST(StoredCells, AnyChangeOfTheirTextRunsThemAgain) {
  const ScratchFolder scratch("vug_stored_cells");
  run_cells(kScene, scratch.path());
  std::vector<std::pair<std::string, loading::LoadOptions>> versions;
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"steps: 5", "steps: 3"},
                                                        {"apart: 50cm", "apart: 40cm"},
                                                        {"gain = 1", "gain = 2"},
                                                        {"from: -1", "from: -0.5"},
                                                        {"relax 2", "relax 3"},
                                                        {"sphere(60cm)", "sphere(61cm)"},
                                                        {"height(", "slope("},
                                                        {"on rock {}", "on rock { polish false }"}})
    versions.emplace_back(changed(kScene, from, to), loading::LoadOptions());
  versions.emplace_back(kScene, loading::LoadOptions());
  versions.back().second.overrides = {{"gain", "0.5"}};
  versions.emplace_back(kScene, loading::LoadOptions());
  versions.back().second.seed = 7;
  versions[6].first = changed(versions[6].first, "from: -1, to: 1", "from: 0deg, to: 40deg");
  for (const auto& [text, load] : versions) {
    const CellsRun again = run_cells(text, scratch.path(), load);
    EXPECT_EQ(again.cell_layers, 1u) << text;
    EXPECT_EQ(again.mesh, run_cells(text, {}, load).mesh) << text;
    EXPECT_EQ(run_cells(text, scratch.path(), load).cell_layers, 0u) << text;
  }
}

// The value that an include gives a parameter of a module may use other parameters.
TEST(StoredCells, ValuesThatModulesAreGivenCount) {
  const ScratchFolder scratch("vug_stored_cells");
  std::ofstream(scratch.path() / "kit.vug")
      << "param low = -2 in -9..9\nlet mask = height(from: low, to: 1)\n";
  const std::string text =
      "param bottom = -1 in -9..9\ninclude \"kit.vug\" as kit { low bottom / 2 }\n" +
      changed(kScene, "height(from: -1, to: 1)", "kit.mask");
  const CellsRun first = run_cells(text, scratch.path());
  EXPECT_EQ(run_cells(text, scratch.path()).cell_layers, 0u);
  const std::string other = changed(text, "bottom = -1", "bottom = -0.8");
  const CellsRun second = run_cells(other, scratch.path());
  EXPECT_EQ(second.cell_layers, 1u);
  EXPECT_NE(second.mesh, first.mesh);
}

TEST(StoredCells, RunsThatDependOnTheFrameAreNotStored) {
  const ScratchFolder scratch("vug_stored_cells");
  const std::string text = changed(kScene, "gain / 3", "gain / 3 * keys(1: 1, 9: 0.5)");
  run_cells(text, scratch.path());
  loading::LoadOptions later;
  later.frame = 9;
  const CellsRun last = run_cells(text, scratch.path(), later);
  EXPECT_EQ(last.cell_layers, 1u);
  EXPECT_EQ(last.mesh, run_cells(text, {}, later).mesh);
  EXPECT_NE(last.mesh, run_cells(text, {}).mesh);
}

TEST(StoredCells, RunAgainIfTheStoreIsDamaged) {
  const ScratchFolder scratch("vug_stored_cells");
  const CellsRun first = run_cells(kScene, scratch.path());
  size_t damaged = 0;
  for (const auto& each : fs::recursive_directory_iterator(scratch.path() / "objects"))
    if (each.path().extension() == ".mesh") {
      std::fstream io(each.path(), std::ios::binary | std::ios::in | std::ios::out);
      io.seekp(static_cast<std::streamoff>(fs::file_size(each.path()) / 2));
      io.put('\x55').put('\x33');
      ++damaged;
    }
  EXPECT_EQ(damaged, 2u) << "with and without cells";
  const CellsRun again = run_cells(kScene, scratch.path());
  EXPECT_EQ(again.cell_layers, 1u);
  EXPECT_EQ(again.mesh, first.mesh);
  EXPECT_EQ(run_cells(kScene, scratch.path()).cell_layers, 0u);
}

}  // namespace
}  // namespace vug::building
