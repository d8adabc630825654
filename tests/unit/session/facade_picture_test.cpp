// SPDX-License-Identifier: Apache-2.0
// Reading pictures of facades: depths at edges.
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/session/facade_picture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::session {
namespace {

TEST(FacadePicture, MixedPixelsAtAStepBelongToOneSide) {
  constexpr int kSide = 24;
  constexpr float kWall = 30, kPane = 30.24f;
  const ScratchFolder scratch("vug_steps");
  const auto path = scratch.file("depth.exr");
  image::Image depth(kSide, kSide, {"Z"});
  // A window with edges inside pixels: it covers a third of those on the left and at the top, and
  // two thirds of those on the right and at the bottom; the wall leans by 2 cm.
  const auto share = [](int at) {
    return at == 6 ? 1 / 3.f : at == 15 ? 2 / 3.f : at > 6 && at < 15;
  };
  const auto wall = [&](int x) { return kWall + 0.02f * static_cast<float>(x) / kSide; };
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float of_window = share(x) * share(y);
      depth.at(x, y) = (1 - of_window) * wall(x) + of_window * kPane;
    }
  image::write_exr(path, depth);
  const FacadePicture read = read_facade_picture(path);
  ASSERT_TRUE(read.depth);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const bool corner = (x == 7 || x == 15) && (y == 7 || y == 15);
      if (corner) continue;  // the median of nine belongs to the wall
      const bool inside = x > 6 && x < 16 && y > 6 && y < 16;
      const float off = read.depth->at(x, y);  // behind the most frequent depth
      EXPECT_LT(inside ? std::abs(off - 0.24f) : std::abs(off), 0.025f) << x << " " << y;
    }
}

}  // namespace
}  // namespace vug::session
