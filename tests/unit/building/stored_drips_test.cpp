// SPDX-License-Identifier: Apache-2.0
// Drips from a store equal those that are computed.
#include <vug/base/binary_value.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/building/explain_products.h>
#include <vug/loading/load.h>
#include <vug/shot/drips_plan.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace vug::building {
namespace {

namespace fs = std::filesystem;

std::string scene_with(const std::string& more) {
  return "let room = displace(complement(box(size: (4, 2.4, 4))), noise: fbm(scale: 80cm), amount: "
         "10cm)\n"
         "drips water = seepage(room, from: (-2, -1.5, -2), to: (2, 1.5, 2), spacing: 30cm, "
         "broken: "
         "40%, draperies: 100%, seed: 3" +
         more +
         ")\n"
         "volume rock = level_set(speleothems(of: water), voxel: 10cm, from: (-2, -1, -2), to: (2, "
         "1, 2))\n";
}

template <class T>
std::string stored_bytes(const T& value) {
  std::ostringstream out;
  write_value(out, value);
  return out.str();
}

struct DripsRun {
  std::string graph, forms;
  std::vector<double> values;  ///< The volume's field at points of a grid.
  std::vector<std::string> products;
};

StoreUse drips_store(const fs::path& folder) {
  StoreUse use;
  use.least_seconds = 0;
  use.store = std::make_shared<store::Store>(store::StoreOptions{folder, 1'000'000'000});
  return use;
}

/// An empty folder means no store.
DripsRun compute(const std::string& text, const fs::path& folder) {
  const loading::Loaded loaded = loading::load_text(text, "drips.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  DripsRun out;
  BuildOptions options;
  if (!folder.empty()) options.stored = drips_store(folder);
  options.stored.on_product = [&](const ProductReport& report) {
    out.products.push_back(
        fmt::format("{} {}{}", report.kind, report.name, report.reused ? ", reused" : ""));
  };
  const Builder builder(loaded.shot, options);
  const shot::DripsPlan& plan = *loaded.shot.drips.at(0).drips;
  out.forms = stored_bytes(static_cast<const drips::GrownForms&>(plan.grown()));
  out.graph = stored_bytes(plan.graph());
  const field::Field& rock = loaded.shot.volumes.at(0)->field;
  for (double x = -1.9; x < 2; x += 0.31)
    for (double y = -1.3; y < 1.4; y += 0.17)
      for (double z = -1.9; z < 2; z += 0.29) out.values.push_back(rock.value({x, y, z}));
  return out;
}

void expect_same(const DripsRun& a, const DripsRun& b) {
  EXPECT_EQ(a.graph, b.graph);
  EXPECT_EQ(a.forms, b.forms);
  EXPECT_EQ(a.values, b.values);
}

TEST(StoredDrips, EqualThoseThatAreComputed) {
  for (const char* more : {"", ", flowstone: 0%"}) {
    const ScratchFolder scratch("vug_stored_drips");
    const std::string text = scene_with(more);
    const DripsRun alone = compute(text, {});
    EXPECT_GT(alone.graph.size(), 10000u);
    EXPECT_GT(alone.forms.size(), 5000u);
    EXPECT_TRUE(alone.products.empty());
    const DripsRun first = with_threads(1, [&] { return compute(text, scratch.path()); });
    expect_same(first, alone);
    EXPECT_EQ(first.products,
              (*more ? std::vector<std::string>{"grown_forms water", "drip_graph water"}
                     : std::vector<std::string>{"drip_graph water", "grown_forms water"}));
    for (const int threads : {2, 7}) {
      const DripsRun again = with_threads(threads, [&] { return compute(text, scratch.path()); });
      expect_same(again, alone);
      EXPECT_EQ(again.products, (std::vector<std::string>{"grown_forms water, reused",
                                                          "drip_graph water, reused"}));
    }
  }
}

TEST(StoredDrips, OtherInputsAreComputed) {
  const ScratchFolder scratch("vug_stored_drips");
  compute(scene_with(""), scratch.path());
  for (const char* more :
       {", density: 40%", ", folds: 8cm", ", edits: [add_drip(at: (0, 0, 0))]"}) {
    const std::string text = scene_with(more);
    const DripsRun other = compute(text, scratch.path());
    expect_same(other, compute(text, {}));
    EXPECT_EQ(other.products, (std::vector<std::string>{"drip_graph water", "grown_forms water"}));
  }
}

TEST(StoredDrips, AreComputedAgainIfTheStoreIsDamaged) {
  const ScratchFolder scratch("vug_stored_drips");
  const std::string text = scene_with("");
  const DripsRun first = compute(text, scratch.path());
  size_t damaged = 0;
  for (const auto& each : fs::recursive_directory_iterator(scratch.path() / "objects"))
    if (each.is_regular_file()) {
      fs::resize_file(each.path(), fs::file_size(each.path()) - 9);
      ++damaged;
    }
  EXPECT_EQ(damaged, 2u);
  const DripsRun again = compute(text, scratch.path());
  expect_same(again, first);
  EXPECT_EQ(again.products, first.products);
}

TEST(StoredDrips, AreListedOnceTheyAreKnown) {
  const ScratchFolder scratch("vug_stored_drips");
  const auto listed = [&] {
    const loading::Loaded loaded = loading::load_text(scene_with(""), "drips.vug");
    std::vector<std::string> out;
    for (const ProductReport& each : explain_products(loaded.shot, drips_store(scratch.path())))
      if (each.name == "water") out.push_back(each.kind + (each.reused ? ", reused" : ""));
    return out;
  };
  EXPECT_EQ(listed(), std::vector<std::string>());
  compute(scene_with(""), scratch.path());
  EXPECT_EQ(listed(), (std::vector<std::string>{"drip_graph, reused", "grown_forms, reused"}));
}

// Drips may be computed after the builder that stored them is gone.
TEST(StoredDrips, DoNotNeedTheBuilder) {
  const ScratchFolder scratch("vug_stored_drips");
  const loading::Loaded loaded = loading::load_text(scene_with(""), "drips.vug");
  size_t reports = 0;
  {
    BuildOptions options;
    options.stored = drips_store(scratch.path());
    options.stored.on_product = [&](const ProductReport&) { ++reports; };
    const Builder builder(loaded.shot, options);
  }
  EXPECT_EQ(stored_bytes(loaded.shot.drips.at(0).drips->graph()),
            compute(scene_with(""), {}).graph);
  EXPECT_EQ(reports, 0u);
}

}  // namespace
}  // namespace vug::building
