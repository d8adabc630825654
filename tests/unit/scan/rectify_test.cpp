// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/scan/rectify.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::scan {
namespace {

/// A view of a rectangle of width x height metres by a camera with square pixels; the corners start
/// with the upper left one.
struct View {
  double focal = 900;  ///< Pixels.
  double yaw = 0.5, pitch = 0.2;
  double away = 14;  ///< Metres.
  int width = 1200, height = 800;

  Vec2d operator()(double x, double y) const {  // Metres from the rectangle's centre, y up.
    const double u = x * std::cos(yaw), v = x * std::sin(yaw);
    const double b = y * std::cos(pitch) - v * std::sin(pitch);
    const double c = y * std::sin(pitch) + v * std::cos(pitch) + away;
    return {width / 2.0 + focal * u / c, height / 2.0 - focal * b / c};
  }
  FourPoints corners(double w, double h) const {
    return {(*this)(-w / 2, h / 2), (*this)(w / 2, h / 2), (*this)(w / 2, -h / 2),
            (*this)(-w / 2, -h / 2)};
  }
};

TEST(Homography, MapsFourPointsToFour) {
  RandomStream stream{RandomKey(9)};
  for (int i = 0; i < 200; ++i) {
    FourPoints from = {Vec2d(0, 0), {4000, 0}, {4000, 3000}, {0, 3000}}, to = from;
    for (size_t k = 0; k < 4; ++k) {
      from[k] += {stream.uniform(-900, 900), stream.uniform(-900, 900)};
      to[k] = to[k] / 300.0 + Vec2d(stream.uniform(-2, 2), stream.uniform(-2, 2));
    }
    const image::Homography there = homography(from, to), back = homography(to, from);
    for (size_t k = 0; k < 4; ++k) EXPECT_NEAR((there(from[k]) - to[k]).length(), 0, 1e-9);
    const Vec2d inside = (from[0] + from[1] + from[2] + from[3]) / 4.0;
    EXPECT_NEAR((back(there(inside)) - inside).length(), 0, 1e-6);
  }
}

TEST(Homography, CollinearPointsAreRejected) {
  const FourPoints square = {Vec2d(0, 0), {1, 0}, {1, 1}, {0, 1}};
  for (const FourPoints& bad : {FourPoints{Vec2d(0, 0), {1, 0}, {2, 0}, {0, 1}},
                                FourPoints{Vec2d(0, 0), {0, 0}, {1, 1}, {0, 1}},
                                FourPoints{Vec2d(0, 0), {1, 0}, {1, 1}, {std::nan(""), 1}}}) {
    EXPECT_THROW(homography(square, bad), Error);
    EXPECT_THROW(homography(bad, square), Error);
  }
}

TEST(Rectify, EstimatesTheAspectFromAView) {
  for (const double yaw : {0.5, -0.8, 0.3})
    for (const double aspect : {0.5, 1.0, 1.6}) {
      const View view{.yaw = yaw};
      EXPECT_NEAR(estimate_aspect(view.corners(6 * aspect, 6), view.width, view.height), aspect,
                  1e-6);
    }
  const View square_on{.yaw = 0, .pitch = 0};
  EXPECT_NEAR(estimate_aspect(square_on.corners(9, 6), square_on.width, square_on.height), 1.5,
              1e-9);
}

/// A checkerboard of 8 x 6 squares of one metre.
double board(double x, double y) {
  return (static_cast<int>(std::floor(x + 100)) + static_cast<int>(std::floor(y + 100))) % 2;
}

image::Image photo_of_board(const View& view) {
  image::Image out(view.width, view.height, {"R", "G", "B"});
  const image::Homography to_wall =
      homography(view.corners(8, 6), {Vec2d(0, 6), {8, 6}, {8, 0}, {0, 0}});
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      double light = 0;
      for (int s = 0; s < 16; ++s) {
        const Vec2d p = to_wall({x + (s % 4 + 0.5) / 4, y + (s / 4 + 0.5) / 4});
        if (p.x >= 0 && p.x < 8 && p.y >= 0 && p.y < 6) light += board(p.x, p.y) / 16;
      }
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = static_cast<float>(light);
    }
  return out;
}

TEST(Rectify, ViewsOfABoardBecomeTheBoard) {
  for (const double away : {9.0, 14.0, 40.0}) {  // Magnified, at the same scale, and reduced.
    const View view{.away = away};
    const RectifiedPhoto out =
        rectify(photo_of_board(view), view.corners(8, 6), {.width = 8, .height = 6, .pixel = 0.05});
    ASSERT_EQ(out.picture.width, 160);
    ASSERT_EQ(out.picture.height, 120);
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const double from_edge =
            std::min({std::fmod(x + 0.5, 20.0), std::fmod(y + 0.5, 20.0),
                      20 - std::fmod(x + 0.5, 20.0), 20 - std::fmod(y + 0.5, 20.0)});
        if (from_edge < (away > 20 ? 7 : 3)) continue;
        EXPECT_NEAR(out.picture.at(x, y), board((x + 0.5) / 20, 6 - (y + 0.5) / 20), 0.15)
            << away << ' ' << x << ' ' << y;
      }
  }
}

/// Stripes finer than the target's pixels become grey instead of aliasing.
TEST(Rectify, DownsamplesWithoutAliasing) {
  image::Image stripes(900, 900, {"R", "G", "B"});
  for (int y = 0; y < 900; ++y)
    for (int x = 0; x < 900; ++x)
      for (size_t c = 0; c < 3; ++c) stripes.at(x, y, c) = static_cast<float>((x / 2 + y / 2) % 2);
  const RectifiedPhoto out = rectify(stripes, {Vec2d(20, 10), {880, 30}, {870, 890}, {10, 870}},
                                     {.width = 1, .height = 1, .pixel = 0.01});
  for (int y = 5; y < 95; ++y)
    for (int x = 5; x < 95; ++x) EXPECT_NEAR(out.picture.at(x, y), 0.5, 0.1) << x << ' ' << y;
}

TEST(Rectify, DefaultsToTheResolutionOfThePhoto) {
  const image::Image photo(400, 300, {"Y"});
  const FourPoints all = {Vec2d(0, 0), {400, 0}, {400, 300}, {0, 300}};
  const RectifiedPhoto same = rectify(photo, all);
  EXPECT_EQ(same.picture.width, 400);
  EXPECT_EQ(same.picture.height, 300);
  EXPECT_NEAR(same.width, 4.0 / 3, 1e-12);
  EXPECT_EQ(rectify(photo, all, {.width = 8, .height = 3}).picture.width, 800);
  EXPECT_EQ(rectify(image::Image(1, 1, {"Y"}), {Vec2d(0, 0), {1, 0}, {1, 1}, {0, 1}})
                .picture.pixels.size(),
            1U);
}

TEST(Rectify, InvalidInputIsRejected) {
  const image::Image photo(400, 300, {"Y"});
  const FourPoints good = {Vec2d(10, 10), {390, 20}, {380, 280}, {20, 290}};
  const auto message = [&](const FourPoints& corners, const RectifyOptions& options) {
    try {
      rectify(photo, corners, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("done");
  };
  EXPECT_EQ(message(good, {}), "done");
  EXPECT_EQ(message({good[3], good[2], good[1], good[0]}, {}),
            "the corners are in counter-clockwise order");
  EXPECT_EQ(message({good[0], good[2], good[1], good[3]}, {}),
            "the corners do not form a convex quadrangle");
  EXPECT_EQ(message({good[0], good[0], good[1], good[3]}, {}),
            "the corners do not form a convex quadrangle");
  EXPECT_NE(message(good, {.width = 3}), "done");
  EXPECT_NE(message(good, {.width = -3, .height = 2}), "done");
  EXPECT_NE(message(good, {.pixel = -1}), "done");
  try {
    rectify(photo, good, {.width = 9, .height = 9, .pixel = 1e-5, .memory = 1 << 30});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
  }
}

TEST(Rectify, OverlaysPhotosOnRangeImages) {
  RangeImage range{160, 120, 0.05, {}, {}, {}};
  for (size_t p = 0; p < 160 * 120; ++p) {
    range.depth.push_back(static_cast<float>(p % 7));
    range.count.push_back(static_cast<uint16_t>(p % 5));
  }
  const View view;
  const image::Image both = overlay_photo(range, photo_of_board(view), view.corners(8, 6),
                                          {Vec2d(0, 6), {8, 6}, {8, 0}, {0, 0}});
  EXPECT_EQ(both.channels, (std::vector<std::string>{"R", "G", "B", "depth", "count"}));
  for (int y = 10; y < 120; y += 20)
    for (int x = 10; x < 160; x += 20) {
      EXPECT_NEAR(both.at(x, y, 0), board((x + 0.5) / 20, 6 - (y + 0.5) / 20), 0.1);
      EXPECT_EQ(both.at(x, y, 3), range.depth[range.index(x, y)]);
      EXPECT_EQ(both.at(x, y, 4), range.count[range.index(x, y)]);
    }
  image::Image plain(320, 240, {"Y"});
  for (size_t p = 0; p < plain.pixels.size(); ++p) plain.pixels[p] = p % 320 < 160 ? 0.0F : 1.0F;
  const image::Image same = overlay_photo(range, plain);
  EXPECT_NEAR(same.at(40, 60), 0, 1e-3);
  EXPECT_NEAR(same.at(120, 60), 1, 1e-3);
}

}  // namespace
}  // namespace vug::scan
