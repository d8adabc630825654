// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/drips/drop.h>
#include <vug/drips/film_path.h>
#include <vug/drips/surface.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vug::drips {
namespace {

/// Surfaces whose tangential gravity is lower count as level.
constexpr double kLevel = 0.05;
/// Roofs have a vertical component of the normal below the first number, floors above the last;
/// drops fall off walls that lean out by more than the second.
constexpr double kRoof = -0.17, kOverhang = -0.5, kFloor = 0.5;
/// A film detaches freely under roofs flatter than the first cosine, not under those steeper than
/// the second (20 and 50 degrees): there it deposits a rib along its path, along which it keeps
/// running, and which becomes a drapery.
constexpr double kFreeCosine = 0.94, kHeldCosine = 0.64;
/// Drops fall from overhangs that are higher than this above the rock below, in metres.
constexpr double kCrack = 0.1;
/// The radius of the ball to which the rock is restricted along a path.
constexpr double kLocal = 0.5;

/// Runs a film until `ended(normal, run, points)` returns an end; `run` is its length so far.
template <class Ended>
Film run(const field::Field& rock, const Vec3d& start, double step, const FilmOptions& options,
         const Ended& ended) {
  Film film{{start}, Vec3d(0.0), FilmEnd::lost};
  Vec3d centre = start;
  field::Field local = rock.restricted({centre, kLocal}).field;
  for (double length = 0;;) {
    const Vec3d p = film.path.back();
    if ((p - centre).length() + 3 * step > kLocal) {
      centre = p;
      local = rock.restricted({centre, kLocal}).field;
    }
    film.normal = normal_at(local, p);
    if (film.normal == Vec3d(0.0) || !options.region.intersects(p)) return film;
    if (const auto end = ended(film.normal, length, p)) {
      film.end = *end;
      return film;
    }
    // The midpoint rule. Where the next point is not lower, the film may be in a crease: it is
    // tried along the mean of both sides, with a shorter step, before the point counts as a low.
    std::optional<Vec3d> next;
    Vec3d normal = film.normal;
    double part = step;
    for (int attempt = 0; attempt < 4 && !next; ++attempt, part *= 0.5) {
      Vec3d way = film_direction(normal);
      if (attempt == 0) way = film_direction(normal_at(local, p + way * (0.5 * part)));
      next = onto_surface(local, p + way * part, 2 * part);
      if (!next || (next->y < p.y && (*next - p).length2() > 1e-2 * part * part)) continue;
      const Vec3d mean = normal + normal_at(local, *next);
      if (mean.length2() > 1e-6) normal = mean.normalized();
      next.reset();
    }
    if (!next) {
      film.end = FilmEnd::low;
      return film;
    }
    length += (*next - p).length();
    film.path.push_back(*next);
  }
}

double fall_along(const Vec3d& normal) { return std::sqrt(std::max(0.0, 1 - normal.y * normal.y)); }

}  // namespace

Vec3d film_direction(const Vec3d& n) {
  const Vec3d along = Vec3d(0, -1, 0) + n * n.y;
  const double length = along.length();
  return length > 1e-9 ? along / length : Vec3d(0.0);
}

Film roof_film(const field::Field& rock, const Vec3d& start, const FilmOptions& o,
               RandomStream random) {
  // It detaches where the integral of its rate exceeds an exponential deviate.
  const double patience = -maths::log(1 - random.uniform());
  double spent = 0, before = 0;
  return run(rock, start, o.roof_step, o,
             [&](const Vec3d& n, double length, const Vec3d&) -> std::optional<FilmEnd> {
               const double cosine = -n.y;
               if (n.y > kRoof) return FilmEnd::wall;
               if (fall_along(n) < kLevel) return FilmEnd::low;
               const double share =
                   std::clamp((cosine - kHeldCosine) / (kFreeCosine - kHeldCosine), 0.0, 1.0);
               spent +=
                   share * (length - before) / (o.merging * drip_spacing(o.temperature, cosine));
               before = length;
               if (spent > patience || length > o.roof_length) return FilmEnd::detached;
               return std::nullopt;
             });
}

Film wall_film(const field::Field& rock, const Vec3d& start, const FilmOptions& o) {
  return run(rock, start, o.floor_step, o,
             [&](const Vec3d& n, double length, const Vec3d&) -> std::optional<FilmEnd> {
               if (n.y > kFloor) return FilmEnd::floor;
               if (n.y < kOverhang) return FilmEnd::overhang;
               if (length > o.floor_length) return FilmEnd::lost;
               return std::nullopt;
             });
}

Film floor_film(const field::Field& rock, const Vec3d& start, const FilmOptions& o) {
  return run(rock, start, o.floor_step, o,
             [&](const Vec3d& n, double length, const Vec3d& p) -> std::optional<FilmEnd> {
               // The foot of an undercut wall is a low, the lip of a shaft is not.
               if (n.y < kOverhang)
                 return rock.value(p - Vec3d(0, kCrack, 0)) > 0 ? FilmEnd::overhang : FilmEnd::low;
               if (n.y > 0 && fall_along(n) < kLevel) return FilmEnd::low;
               if (length > o.floor_length) return FilmEnd::lost;
               return std::nullopt;
             });
}

}  // namespace vug::drips
