// SPDX-License-Identifier: Apache-2.0
// Films run down the steepest way, on the surface.
#include <vug/drips/drop.h>
#include <vug/drips/film_path.h>
#include <vug/drips/surface.h>
#include <vug/field/translated.h>

#include <gtest/gtest.h>

#include <cmath>

#include "rooms.h"

namespace vug::drips {
namespace {

/// Each point is on the surface and lower than the one before; directions are tangential.
void expect_descends(const field::Field& rock, const Film& film) {
  for (size_t i = 0; i < film.path.size(); ++i) {
    EXPECT_NEAR(rock.value(film.path[i]), 0, 1e-5);
    if (i > 0) {
      EXPECT_LT(film.path[i].y, film.path[i - 1].y);
    }
    const Vec3d n = normal_at(rock, film.path[i]);
    EXPECT_LT(std::fabs(n.dot(film_direction(n))), 1e-3);
  }
}

TEST(Film, RunsDownASlopingRoofToTheWall) {
  // 70 degrees: too steep for drops to detach soon.
  const field::Field rock = hall(6, std::tan(70 * kPi / 180), 6);
  FilmOptions o;
  o.merging = 1e9;
  o.roof_length = 10;
  const Vec3d start = *onto_surface(rock, Vec3d(0.7, 1.1, 0), 2);
  const Film film = roof_film(rock, start, o, RandomStream(RandomKey(1)));
  ASSERT_GT(film.path.size(), 10u);
  expect_descends(rock, film);
  for (const Vec3d& p : film.path) EXPECT_NEAR(p.z, 0, 1e-9) << "it keeps to the fall line";
}

TEST(Film, FollowsRoughRoofsToTheirLows) {
  const field::Field rock = cave();
  FilmOptions o;
  o.merging = 1e9;  // It does not detach.
  int lows = 0, points = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec3d above(-2.4 + 0.12 * i, 0, 1.7 * std::sin(i));
    const auto y = VerticalLine(rock, above, 0.05).crossing(0, 4);
    ASSERT_TRUE(y);
    const Film film = roof_film(rock, {above.x, *y, above.z}, o, RandomStream(RandomKey(1)));
    expect_descends(rock, film);
    points += static_cast<int>(film.path.size());
    if (film.end != FilmEnd::low) continue;
    ++lows;
    // No way leads down from a low that is not level.
    for (double t = 0; t < 6; t += 0.5) {
      const auto near = onto_surface(
          rock, film.path.back() + Vec3d(0.03 * std::cos(t), 0, 0.03 * std::sin(t)), 0.1);
      if (near) {
        EXPECT_GT(near->y, film.path.back().y - 0.01);
      }
    }
  }
  EXPECT_GT(lows, 20);
  EXPECT_GT(points, 200);
}

/// The first change of sign between samples, from values in double precision alone.
std::optional<double> plain_crossing(const field::Field& rock, const Vec3d& at, double step,
                                     double to) {
  const auto solid = [&](double y) { return rock.value({at.x, y, at.z}) <= 0; };
  const double way = to < at.y ? -1 : 1, length = std::fabs(to - at.y);
  const bool inside = solid(at.y);
  double near = at.y;
  for (double s = 0; s < length;) {
    s = std::min(s + step, length);
    double far = at.y + way * s;
    if (solid(far) != inside) {
      for (int i = 0; i < 24; ++i) {
        const double middle = 0.5 * (near + far);
        (solid(middle) == inside ? near : far) = middle;
      }
      return 0.5 * (near + far);
    }
    near = far;
  }
  return std::nullopt;
}

TEST(VerticalLines, HaveTheBitsOfAPlainSearch) {
  const field::Field far_away =
      field::unite({cave(), field::translated(field::make("sphere"), {3e4, 0, 0})});
  int found = 0;
  for (const field::Field& rock : {cave(), hall(6, 0.4, 6), far_away})
    for (int i = 0; i < 60; ++i)
      for (const double to : {-6.0, 6.0}) {
        const Vec3d at(-2.4 + 0.08 * i, 0.01 * i, 1.7 * std::sin(i));
        const auto expected = plain_crossing(rock, at, 0.05, to);
        const auto y = VerticalLine(rock, at, 0.05).crossing(at.y, to);
        ASSERT_EQ(y.has_value(), expected.has_value()) << at;
        if (!y) continue;
        EXPECT_EQ(*y, *expected) << at;
        ++found;
      }
  EXPECT_GT(found, 200);
}

TEST(Film, DetachesAfterFourWavelengthsOnAverage) {
  const field::Field rock = hall(40, 0.2, 40);
  double sum = 0;
  constexpr int kFilms = 400;
  for (int i = 0; i < kFilms; ++i) {
    const Vec3d start = *onto_surface(rock, Vec3d(0, 1, 0), 2);
    FilmOptions o;
    o.roof_step = 0.01;
    const Film film =
        roof_film(rock, start, o, RandomStream(RandomKey(1).at(static_cast<uint64_t>(i))));
    EXPECT_EQ(film.end, FilmEnd::detached);
    sum += (film.path.back() - start).length();
  }
  const double mean = 4 * drip_spacing(10, 1 / std::hypot(1, 0.2));
  EXPECT_NEAR(sum / kFilms, mean, 4 * mean / std::sqrt(kFilms) + 0.01);
}

TEST(Film, RunsDownWallsAndOverFloors) {
  const field::Field rock = cave();
  const auto x = onto_surface(rock, Vec3d(2.9, 0, 0.3), 1);
  ASSERT_TRUE(x);
  const Film wall = wall_film(rock, *x, {});
  EXPECT_EQ(wall.end, FilmEnd::floor);
  expect_descends(rock, wall);
  const Film floor = floor_film(rock, wall.path.back(), {});
  EXPECT_EQ(floor.end, FilmEnd::low);
  expect_descends(rock, floor);
}

TEST(Film, StaysWhereThereIsNoSurface) {
  const Film film = floor_film(field::empty(), {0, 0, 0}, {});
  EXPECT_EQ(film.end, FilmEnd::lost);
  EXPECT_EQ(film.path.size(), 1u);
  const double nan = std::nan("");
  EXPECT_EQ(roof_film(hall(), {nan, nan, nan}, {}, RandomStream(RandomKey(1))).end, FilmEnd::lost);
}

}  // namespace
}  // namespace vug::drips
