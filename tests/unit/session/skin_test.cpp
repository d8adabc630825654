// A skin is a product: made once, held, counted, and refused for its size before the work.
#include <gtest/gtest.h>
#include <vug/base/memory.h>
#include <vug/session/build.h>
#include <vug/session/load.h>

namespace vug::session {
namespace {

const std::string kBall =
    "volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock {}\n";

Shot shot_of(const std::string& cells) {
  const Loaded loaded = load_text(kBall + cells + "\n", "skin.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  return loaded.shot;
}

TEST(Skin, IsMadeOnceAndHeld) {
  const Shot shot =
      shot_of("cells skin on wall { spacing 10cm  run sprinkle(attribute: \"wet\") }");
  BuildOptions options;
  options.max_memory = uint64_t{1} << 30;
  Builder builder(shot, options);
  const CellsPtr cells = shot.meshes.back()->cells;
  builder.mesh(cells->on);
  const uint64_t room = builder.room();
  const SkinPtr skin = builder.skin(cells);
  EXPECT_NEAR(static_cast<double>(skin->network().size()), 4 * kPi / 0.01, 0.2 * 4 * kPi / 0.01);
  EXPECT_EQ(skin->simulation.step(), 100);
  EXPECT_EQ(room - builder.room(), skin->simulation.bytes());
  // Three vectors, two numbers and six links or so of a cell, and what it carries.
  EXPECT_GT(skin->simulation.bytes(), skin->network().size() * (3 * 12 + 2 * 4 + 4 * 4 + 4));
  const auto& wet = skin->simulation.attributes().values<float>("wet");
  EXPECT_EQ(wet.size(), skin->network().size());
  EXPECT_FALSE(skin->relaxing.empty());

  const auto worn = builder.mesh(shot.meshes.back());
  EXPECT_TRUE(mesh::find_attribute(*worn, "wet"));
  EXPECT_EQ(builder.skin(cells), skin);

  const Shot again = shot;
  Builder next(again, options);
  next.take_over(std::move(builder));
  EXPECT_EQ(next.skin(cells), skin);
}

TEST(Skin, TooManyCellsAreRefusedBeforeAnyWork) {
  const Shot shot = shot_of("cells skin on wall { spacing 1mm  run voronoi }");
  BuildOptions options;
  options.max_memory = uint64_t{1} << 30;
  Builder builder(shot, options);
  try {
    builder.require_room(shot.meshes.back());
    FAIL() << "12 million cells in a GiB";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_NE(std::string(error.what()).find("cells would take about"), std::string::npos);
    EXPECT_EQ(error.where().line, 3);
    EXPECT_EQ(error.where().column, 22);
    EXPECT_EQ(error.hint().rfind("use a larger spacing", 0), 0u) << error.hint();
  }
  EXPECT_EQ(builder.seconds(), 0);
}

}  // namespace
}  // namespace vug::session
