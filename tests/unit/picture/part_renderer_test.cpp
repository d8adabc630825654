// SPDX-License-Identifier: Apache-2.0
// Parts that one PartRenderer writes have the bytes of parts that are rendered one by one.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/load.h>
#include <vug/picture/render_job.h>

#include <fmt/format.h>

namespace vug::picture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartsScene =
    "volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)\n"
    "camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }\n"
    "light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (90, 60, 30))\n"
    "render main { size 24x16  spp 8 }\n";

class PartRendererTest : public testing::Test {
 protected:
  RenderOptions part(const std::string& name, uint32_t begin, uint32_t end) const {
    RenderOptions out;
    out.part = folder_.file(name);
    out.slice.begin = begin, out.slice.end = end;
    return out;
  }
  std::string bytes(const std::string& name) const { return read_text(folder_.file(name)); }
  fs::path guiding() const { return folder_.file("learned"); }

  ScratchFolder folder_{"vug_part_renderer"};
  loading::Loaded loaded_ = loading::load_text(kPartsScene, "t.vug");
  building::Builder builder_{loaded_.shot, {}};
  PicturePlan plan_ = plan_picture(loaded_.shot);
};

TEST_F(PartRendererTest, WritesTheBytesOfSinglePartsWithAnyNumberOfThreads) {
  for (const uint32_t begin : {0U, 3U, 5U}) {
    RenderOptions alone = part(fmt::format("alone{}", begin), begin, begin == 5 ? 8 : begin + 2);
    alone.guiding = guiding();
    render_picture(builder_, plan_, alone);
  }
  for (const int threads : {1, 2, 7})
    with_threads(threads, [&] {
      PartRenderer parts(builder_, plan_, guiding());
      // In another order, and the first one twice.
      for (const uint32_t begin : {5U, 0U, 3U, 5U}) {
        parts.render(part("part", begin, begin == 5 ? 8 : begin + 2));
        EXPECT_EQ(bytes("part"), bytes(fmt::format("alone{}", begin))) << begin << " " << threads;
      }
      EXPECT_EQ(parts.preparations(), 1U);
    });
}

TEST_F(PartRendererTest, PreparesOtherPixelsAnew) {
  RenderOptions top = part("top", 0, 8), below = part("below", 0, 8);
  top.slice.bands = below.slice.bands = 2;
  below.slice.band = 1;
  for (RenderOptions alone : {top, below}) {
    alone.guiding = guiding();
    alone.part += "_alone";
    render_picture(builder_, plan_, alone);
  }
  PartRenderer parts(builder_, plan_, guiding());
  parts.render(top);
  parts.render(below);
  EXPECT_EQ(parts.preparations(), 2U);
  EXPECT_EQ(bytes("top"), bytes("top_alone"));
  EXPECT_EQ(bytes("below"), bytes("below_alone"));
}

TEST_F(PartRendererTest, ContinuesCheckpointsAndRemovesThem) {
  PartRenderer parts(builder_, plan_, guiding());
  parts.render(part("whole", 0, 8));
  RenderOptions stopped = part("stopped", 0, 8);
  stopped.checkpoint = folder_.file("checkpoint"), stopped.resume = true;
  // A complete part has the form of a checkpoint; the state is then finished already.
  fs::copy_file(folder_.file("whole"), stopped.checkpoint);
  parts.render(stopped);
  EXPECT_EQ(bytes("stopped"), bytes("whole"));
  EXPECT_FALSE(fs::exists(stopped.checkpoint));
}

TEST_F(PartRendererTest, AFailedPartLeavesTheOthersPossible) {
  PartRenderer parts(builder_, plan_, guiding());
  parts.render(part("first", 0, 4));
  RenderOptions foreign = part("foreign", 4, 8);
  foreign.checkpoint = folder_.file("checkpoint"), foreign.resume = true;
  fs::copy_file(folder_.file("first"), foreign.checkpoint);  // of other samples
  EXPECT_THROW(parts.render(foreign), Error);
  EXPECT_THROW(parts.render({}), Error);
  EXPECT_FALSE(fs::exists(foreign.part));
  parts.render(part("again", 0, 4));
  EXPECT_EQ(bytes("again"), bytes("first"));
}

/// The hint of a render of the scene that is stopped when a stage of this name begins.
std::string hint_of_stop(const shot::Shot& shot, const PicturePlan& plan,
                         const fs::path& checkpoint, const std::string& stage) {
  Progress* running = nullptr;
  Progress progress([&](const std::string& name, double) {
    if (name.find(stage) != std::string::npos) running->cancel();
  });
  running = &progress;
  building::Builder builder(shot, {}, progress);
  RenderOptions options;
  options.checkpoint = checkpoint, options.resume = true;
  try {
    render_picture(builder, plan, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
    return error.hint();
  }
  return "it was not stopped";
}

TEST_F(PartRendererTest, AStopNamesTheCheckpointOnlyIfThereIsOne) {
  const fs::path checkpoint = folder_.file("checkpoint");
  const auto hint = [&](const std::string& stage) {
    return hint_of_stop(loaded_.shot, plan_, checkpoint, stage);
  };
  const std::string early = hint("BVH and lights");
  EXPECT_NE(early.find("before its first sample"), std::string::npos) << early;
  EXPECT_FALSE(fs::exists(checkpoint));
  const std::string late = hint("rendering");
  EXPECT_NE(late.find("contains the work so far"), std::string::npos) << late;
  EXPECT_TRUE(fs::exists(checkpoint));
}

}  // namespace
}  // namespace vug::picture
