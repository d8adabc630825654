// SPDX-License-Identifier: Apache-2.0
// The outlines of hanging and standing forms, and of pieces.
#include <vug/base/maths.h>
#include <vug/drips/drop.h>
#include <vug/drips/form_fields.h>
#include <vug/drips/trunk.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// Points of curves; their number times the sides is the cost of a distance.
constexpr int kHangingPoints = 14, kColumnPoints = 26;
constexpr int kCapPoints = 4, kEndPoints = 6;
/// The radii of stalactites and of columns vary by these fractions. The waves of stalactites are
/// those of a form with this share of the girth as radius.
constexpr double kWaves = 0.07, kColumnWaves = 0.1, kWaveRadius = 0.5;
/// The coat of a column is thinner at the waist and thicker at both ends, where the film is slow.
constexpr double kWaistCoat = 0.7, kEndCoat = 1.8;
/// Passes of a mean of three neighbours over the radii of a column.
constexpr int kFillings = 4;
/// No column is thinner than three straws, or than this share of the lower trunk: the film that
/// runs over the place where both met coats it.
constexpr double kThinnestWaist = 0.4;
constexpr double kLeastStraws = 3;

/// The lower end of a stalactite of that radius and slope: part of a sphere, as of a drop.
void add_cap(double rim, double slope, std::vector<Vec2d>& out) {
  const double angle = maths::atan2(slope, 1), ball = rim / maths::sin(angle);
  for (int i = 0; i < kCapPoints; ++i) {
    const double t = angle * i / kCapPoints;
    out.emplace_back(ball * maths::sin(t), ball * (maths::cos(angle) - maths::cos(t)));
  }
}

double tip_radius(const FormOptions& o, const field::StalactiteCurve& curve) {
  return std::max({o.tip, 0.5 * straw_diameter(10), curve.least_radius()});
}

/// The end that has grown on a stump since it broke at the height `cut`.
void add_end(double length, double cut, const field::StalactiteCurve& curve, double tip,
             std::vector<Vec2d>& out) {
  const double root = std::max(1.02 * tip, curve.radius_at(curve.height_at(tip) + length));
  for (const Vec2d& p : curve.points(tip, root, kEndPoints))
    out.emplace_back(p.x, std::min(cut, cut - length + p.y));
  out.insert(out.begin(), Vec2d(0, out.front().y - 0.5 * out.front().x));
}

/// From the tip up to where it broke; the tip is at y = 0.
std::vector<Vec2d> piece(const Form& form, const FormOptions& o,
                         const field::StalactiteCurve& curve) {
  const double length = (form.top - form.bottom).length(), tip = tip_radius(o, curve);
  std::vector<Vec2d> out;
  add_cap(tip, curve.slope_at(tip), out);
  for (const Vec2d& p : curve.points(tip, form.radius, kHangingPoints))
    out.emplace_back(p.x, std::min(p.y, length));
  // Broken across, not quite at a right angle to the axis.
  out.emplace_back(0.4 * form.radius, length - 0.25 * form.radius);
  out.emplace_back(0, length - 0.1 * form.radius);
  return out;
}

/// From the tip up; the tip is at y = 0.
std::vector<Vec2d> hanging(const Form& form, const FormOptions& o,
                           const field::StalactiteCurve& curve, const DripHistory& history) {
  const double length = (form.top - form.bottom).length() + form.sunk, top = length + form.root;
  std::vector<Vec2d> out;
  if (form.kind == FormKind::straw)
    return {{0, -0.5 * form.radius},
            {0.87 * form.radius, 0},
            {form.radius, 0.5 * form.radius},
            {form.radius, top},
            {0, top}};
  const double tip = tip_radius(o, curve);
  const std::vector<Vec2d> side = curve.points(tip, form.radius, kHangingPoints);
  const double cut = form.broken * length;
  if (cut <= 0) add_cap(side.front().x, curve.slope_at(side.front().x), out);
  if (cut > 0 && form.regrown > 0) add_end(form.regrown, cut, curve, tip, out);
  for (size_t i = 0; i < side.size(); ++i) {
    const Vec2d& p = side[i];
    if (p.y < cut) {
      if (i + 1 < side.size() && side[i + 1].y > cut) {
        const double part = (cut - p.y) / (side[i + 1].y - p.y);
        if (out.empty()) out.emplace_back(0, cut);
        out.emplace_back(p.x + part * (side[i + 1].x - p.x), cut);
      }
      continue;
    }
    out.emplace_back(p.x * (1 + kWaves * history.wave(length - p.y)), p.y);
  }
  out.emplace_back(out.back().x, top);
  out.emplace_back(0, top);
  return out;
}

/// Below the floor the outline continues as wide as at the floor.
std::vector<Vec2d> standing(const Form& form, const DripHistory& history) {
  std::vector<Vec2d> out = grown_trunk(form, form.top.y - form.bottom.y, history);
  out.emplace_back(out.back().x, -form.root);
  out.emplace_back(0, -form.root);
  return out;
}

std::vector<Vec2d> column(const Form& form, const FormOptions& o,
                          const field::StalactiteCurve& curve, const DripHistory& history) {
  const double height = (form.top - form.bottom).length();
  const std::vector<Vec2d> lower = grown_trunk(form, form.waist * height, history);
  const double tip = tip_radius(o, curve);
  const double end = curve.height_at(tip),
               least = std::max(
                   {tip, kLeastStraws * 0.5 * straw_diameter(10), kThinnestWaist * form.radius});
  std::vector<double> radii;
  for (int i = 0; i <= kColumnPoints; ++i) {
    const double y = height * (1 - static_cast<double>(i) / kColumnPoints);
    const double above = y - form.waist * height;
    const double hung = above > 0 ? curve.radius_at(end + above) : 0;
    const double aside = std::fabs(2 * y / height - 1);
    const double coat = form.coat * (kWaistCoat + (kEndCoat - kWaistCoat) * aside * aside * aside);
    radii.push_back(form.cover * (std::max({hung, radius_at(lower, y), least}) + coat) *
                    (1 + kColumnWaves * history.wave(y)));
  }
  // The film that covers both fills the shoulder where they met.
  for (int pass = 0; pass < kFillings; ++pass) {
    const std::vector<double> before = radii;
    for (size_t i = 1; i + 1 < radii.size(); ++i)
      radii[i] =
          std::max(form.cover * least, 0.25 * (before[i - 1] + before[i + 1]) + 0.5 * before[i]);
  }
  std::vector<Vec2d> out{Vec2d(0, height + form.root), Vec2d(radii.front(), height + form.root)};
  for (size_t i = 0; i < radii.size(); ++i)
    out.emplace_back(radii[i], height * (1 - static_cast<double>(i) / kColumnPoints));
  out.emplace_back(out.back().x, -form.root);
  out.emplace_back(0, -form.root);
  return out;
}

}  // namespace

std::vector<Vec2d> outline_of(const Form& form, const FormOptions& o,
                              const field::StalactiteCurve& curve) {
  // The waves of hanging forms keep their distance while the root becomes wider.
  const bool hangs = form.kind == FormKind::stalactite;
  const DripHistory history(RandomKey(o.seed).at("girdles").at(static_cast<uint64_t>(form.drip)),
                            hangs ? kWaveRadius * o.girth : form.radius, form.scatter);
  switch (form.kind) {
    case FormKind::column:
      return column(form, o, curve, history);
    case FormKind::stalagmite:
      return standing(form, history);
    case FormKind::piece:
      return piece(form, o, curve);
    default:
      return hanging(form, o, curve, history);
  }
}

}  // namespace vug::drips
