// SPDX-License-Identifier: Apache-2.0
// The threads of the viewport: the last picture stays, a motion builds nothing, work ends on
// request.
#include "scene.h"

#include <vug/viewport/viewport.h>

#include <atomic>

namespace vug::viewport {
namespace {

class Viewports : public testing::Test {
 protected:
  ViewportStatus show(const std::string& text) {
    viewport_.set_text(text);
    viewport_.wait();
    return viewport_.status();
  }
  void SetUp() override { viewport_.set_size(64, 36); }

  std::atomic<int> notes_ = 0;
  Viewport viewport_{"scene.vug", {}, [this] { ++notes_; }};
};

TEST_F(Viewports, ShowACompletePictureOfTheText) {
  EXPECT_FALSE(viewport_.status().picture);
  const ViewportStatus status = show(scene_text());
  ASSERT_TRUE(status.picture) << status.report;
  EXPECT_TRUE(status.picture->complete);
  EXPECT_FALSE(status.stale());
  EXPECT_FALSE(status.problems->has_errors());
  EXPECT_EQ(status.counters.scenes, 1u);
  EXPECT_GT(status.counters.pictures, 1u) << "coarse ones come first";
  EXPECT_GT(notes_, 3);
  // The target is the surface in the middle of the picture.
  EXPECT_NEAR((viewport_.view().eye - viewport_.view().target).length(), 3.5, 0.02);
}

TEST_F(Viewports, KeepTheLastPictureOfATextWithErrors) {
  const PreviewPtr good = show(scene_text()).picture;
  const ViewportStatus faulty = show(scene_text() + "object wrong on nowhere { }\n");
  EXPECT_EQ(faulty.picture, good);
  EXPECT_TRUE(faulty.stale());
  EXPECT_EQ(faulty.failed, faulty.wanted);
  ASSERT_TRUE(faulty.problems->has_errors());
  EXPECT_EQ(faulty.problems->all().front().where.line, 16);
  const ViewportStatus mended = show(scene_text("60cm"));
  EXPECT_FALSE(mended.stale());
  EXPECT_TRUE(mended.problems->all().empty());
  EXPECT_NE(mended.picture->rgb, good->rgb);
}

TEST_F(Viewports, AMotionBuildsNothing) {
  const ViewportStatus before = show(scene_text());
  const View home = viewport_.view();
  for (int i = 1; i < 20; ++i) viewport_.set_view(orbit(home, 0.05 * i, 0));
  viewport_.wait();
  const ViewportStatus after = viewport_.status();
  EXPECT_EQ(after.counters.scenes, 1u);
  EXPECT_EQ(after.counters.texts, 1u);
  EXPECT_EQ(after.counters.trees, before.counters.trees);
  EXPECT_EQ(after.picture->view, orbit(home, 0.05 * 19, 0)) << "the last request counts";
  EXPECT_TRUE(after.picture->complete);
  EXPECT_NE(after.picture->rgb, before.picture->rgb);
  viewport_.set_view({});
  viewport_.wait();
  EXPECT_EQ(viewport_.status().picture->rgb, before.picture->rgb);
}

TEST_F(Viewports, AViewStaysWhenTheTextChanges) {
  show(scene_text());
  const View own = orbit(viewport_.view(), 1, 0.2);
  viewport_.set_view(own);
  const ViewportStatus status = show("# a comment\n" + scene_text());
  EXPECT_EQ(status.picture->view, own);
  EXPECT_EQ(status.counters.products, 6u + 0u) << "three level sets and meshes, once";
}

TEST_F(Viewports, StopEndsTheWorkAndKeepsThePicture) {
  const PreviewPtr good = show(scene_text()).picture;
  // Fine voxels: a build that takes long compared with the stop.
  std::string heavy = scene_text("80cm");
  heavy.replace(heavy.find("voxel: 5cm"), 10, "voxel: 2mm");
  viewport_.set_text(heavy);
  viewport_.stop();
  viewport_.wait();
  const ViewportStatus stopped = viewport_.status();
  EXPECT_TRUE(stopped.stopped);
  EXPECT_TRUE(stopped.stale());
  EXPECT_EQ(stopped.picture, good);
  EXPECT_EQ(stopped.counters.scenes, 1u);
  const ViewportStatus next = show(scene_text("70cm"));
  EXPECT_FALSE(next.stopped);
  EXPECT_FALSE(next.stale());
}

TEST_F(Viewports, ShowTheLastOfManyTexts) {
  for (int i = 20; i < 30; ++i) viewport_.set_text(scene_text(std::to_string(i) + "cm"));
  const ViewportStatus status = show(scene_text("30cm"));
  EXPECT_EQ(status.wanted, 11u);
  EXPECT_EQ(status.picture->scene.scene->version, 11u);
}

TEST_F(Viewports, WarningsOfTheBuildAreProblems) {
  const ViewportStatus status =
      show(scene_text() +
           "volume nothing = level_set(sphere(1mm), voxel: 10cm)\nmesh nothing on "
           "nothing { }\nobject nothing on nothing { }\n");
  EXPECT_FALSE(status.problems->all().empty());
  EXPECT_EQ(status.problems->all().front().where.line, 16) << status.report;
}

}  // namespace
}  // namespace vug::viewport
