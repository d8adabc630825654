// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/drips/trunk.h>
#include <vug/field/speleothems/stalagmite_curve.h>
#include <vug/field/speleothems/travertine_dome.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// Standard deviation of the logarithm of the interval between drops over centuries, of which half
/// is that of the radius, which is proportional to the interval to the power -1/2 (our choice).
constexpr double kIntervalSpread = 0.75;
/// Girdles follow each other after this number of radii.
constexpr double kLeastPitch = 2.2, kMostPitch = 7;
/// Plates grow below tall falls: the scatter in metres from which they do, their distance, and the
/// part of the radius by which their rims stand out.
constexpr double kPlateScatter = 0.015, kLeastPlate = 0.03, kMostPlate = 0.1, kPlateRim = 0.14;
/// Most drips were faster when they were young: the oldest part of a trunk is wider by up to the
/// first number, which fades over the second number of radii.
constexpr double kTaper = 1.1, kTaperHeight = 9;
/// The foot is wider by a fraction of up to the first number, and as high as up to this number of
/// radii.
constexpr double kWidestFoot = 0.9, kHighestFoot = 2.2;
/// The film thickens the wall down to the first depth below the apex, in radii, and fades out at
/// the second.
constexpr double kWetted = 1.4, kDry = 3.6;
constexpr int kProfilePoints = 12, kMostHeights = 48;
constexpr double kGirdleStep = 0.35;  // Of past heights, in radii.
/// The steepest part of the dome at the foot of massive stalagmites, radians.
constexpr double kDomeSlope = 1.25;
constexpr int kDomePoints = 8;

double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The steady profile down to `depth` below the apex, x the radius and y the height above that.
std::vector<Vec2d> steady(const Form& form, double height, double depth) {
  field::StalagmiteForm shape{form.radius, std::min(form.scatter, 0.8 * form.radius),
                              form.apex_cosine};
  // The sides of a cone fall by this tangent within the landing, which a low one is too small for.
  const double k = form.apex_cosine, fall = std::sqrt(std::max(0.0, 1 - k * k)) / k;
  if (fall > 0) shape.landing = std::min(shape.landing, 0.9 * height / fall);
  std::vector<Vec2d> out;
  for (const Vec2d& p : field::StalagmiteCurve(shape).points(depth, kProfilePoints))
    out.emplace_back(p.x, depth - p.y);
  return out;
}

/// From its apex at (0, `top`) down.
std::vector<Vec2d> dome(double scale, double top) {
  std::vector<Vec2d> out{Vec2d(0, top)};
  for (int i = 1; i <= kDomePoints; ++i) {
    const double angle = kDomeSlope * i / kDomePoints;
    out.emplace_back(field::dome_radius(scale, angle), top - field::dome_depth(scale, angle));
  }
  return out;
}

}  // namespace

DripHistory::DripHistory(RandomKey key, double radius, double scatter) {
  RandomStream random(key);
  for (double& phase : phases_) phase = random.uniform(0, 2 * kPi);
  pitch_ = std::max(0.04, radius * random.uniform(kLeastPitch, kMostPitch));
  amount_ = 0.5 * kIntervalSpread * random.uniform(0.4, 1.4);
  const double foot = random.uniform();
  foot_ = kWidestFoot * (0.12 + 0.88 * foot * foot);
  foot_height_ = radius * random.uniform(0.7, kHighestFoot);
  const double decline = random.uniform();
  taper_ = kTaper * (0.1 + 0.9 * decline * decline);
  taper_height_ = kTaperHeight * radius;
  plate_pitch_ = random.uniform(kLeastPlate, kMostPlate);
  plates_ = kPlateRim * random.uniform() * smoothstep(scatter / kPlateScatter - 1);
}

double DripHistory::wave(double height) const {
  const double turn = 2 * kPi * height / pitch_;
  return 0.45 * maths::sin(0.31 * turn + phases_[1]) + 0.35 * maths::sin(turn + phases_[0]) +
         0.2 * maths::sin(2.3 * turn + phases_[2]);
}

double DripHistory::radius_at(double height) const {
  const double plate = 0.5 + 0.5 * maths::sin(2 * kPi * height / plate_pitch_ + phases_[3] +
                                              1.5 * wave(0.4 * height));
  const double taper = 1 + taper_ * maths::exp(-height / taper_height_);
  return taper * maths::exp(amount_ * wave(height)) * (1 + plates_ * plate * plate);
}

double DripHistory::flare(double height) const {
  return 1 + foot_ * maths::exp(-std::max(height, 0.0) / foot_height_);
}

double radius_at(const std::vector<Vec2d>& outline, double y) {
  if (y > outline.front().y) return 0;
  for (size_t i = 1; i < outline.size(); ++i) {
    const Vec2d &a = outline[i - 1], &b = outline[i];
    if (y > a.y || y < b.y) continue;
    const double part = a.y > b.y ? (a.y - y) / (a.y - b.y) : 0;
    return a.x + part * (b.x - a.x);
  }
  return outline.back().x;
}

std::vector<Vec2d> grown_trunk(const Form& form, double height, const DripHistory& history) {
  const double deep = kDry * form.radius;
  const std::vector<Vec2d> profile = steady(form, height, deep);
  // Multiples of a step from the floor up, whatever the height, and the present apex.
  const double step = std::max(kGirdleStep * form.radius, 0.01);
  std::vector<double> apexes, heights;
  for (int i = 1; i * step < height; ++i) apexes.push_back(i * step);
  apexes.push_back(height);
  for (const Vec2d& p : profile)
    if (p.y - deep + height >= 0) heights.push_back(p.y - deep + height);
  int every = 1;
  while (height > every * step * kMostHeights) every *= 2;
  for (int i = 0; i * step < height; i += every) heights.push_back(i * step);
  std::sort(heights.begin(), heights.end(), std::greater<>());
  const std::vector<Vec2d> foot =
      form.dome > 0 ? dome(form.dome, 0.5 * height) : std::vector<Vec2d>{Vec2d(0, 0)};
  std::vector<Vec2d> out;
  for (const double y : heights) {
    double widest = 0;
    for (const double apex : apexes) {
      const double ratio = history.radius_at(apex);
      const double depth = (apex - y) / ratio;
      if (depth < 0 || depth > kDry * form.radius) continue;
      const double wet = 1 - smoothstep((depth / form.radius - kWetted) / (kDry - kWetted));
      widest = std::max(widest, ratio * radius_at(profile, deep - depth) * (0.45 + 0.55 * wet));
    }
    const double under = foot.size() > 1 ? radius_at(foot, y) : 0;
    const Vec2d next(std::max(widest * history.flare(y), under), y);
    if (out.empty() || out.back().y - y > 1e-4 * height) out.push_back(next);
  }
  out.back().y = 0;
  return out;
}

}  // namespace vug::drips
