// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/drips/drop.h>
#include <vug/drips/form_fields.h>
#include <vug/drips/growth.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/stalagmite_curve.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::drips {
namespace {

/// Points of curves; their number times the sides is the cost of a distance.
constexpr int kHangingPoints = 14, kStandingPoints = 14, kColumnPoints = 22;
constexpr int kCapPoints = 4;
/// The radii of trunks and of stalactites vary by these fractions.
constexpr double kGirdles = 0.13, kWaves = 0.07;
/// Girdles are this high in metres: the flow changed while the trunk grew.
constexpr double kGirdleHeight = 0.11;
/// Most trunks are as wide at the foot as at the top; drips that became slower leave a taper, which
/// widens the foot by at most this fraction.
constexpr double kTaper = 0.9;
/// The coat of a column is thinner at the waist and thicker at both ends, where the film is slow.
constexpr double kWaistCoat = 0.7, kEndCoat = 1.8;
/// No column is thinner than three straws.
constexpr double kLeastStraws = 3;

/// A smooth function of the height with values of -1..1, different for each form.
class Waves {
 public:
  explicit Waves(RandomKey key) {
    RandomStream random(key);
    for (double& phase : phases_) phase = random.uniform(0, 2 * kPi);
    const double decline = random.uniform();
    taper_ = kTaper * decline * decline;
    pitch_ = kGirdleHeight * random.uniform(0.7, 1.6);
  }
  /// The factor of a trunk's radius at a fraction of the way from the apex to the foot.
  double taper(double down) const { return 1 + taper_ * down; }
  double at(double height) const {
    const double turn = 2 * kPi * height / pitch_;
    return 0.5 * maths::sin(turn + phases_[0]) + 0.3 * maths::sin(0.43 * turn + phases_[1]) +
           0.2 * maths::sin(2.1 * turn + phases_[2]);
  }

 private:
  std::array<double, 3> phases_{};
  double taper_ = 0, pitch_ = kGirdleHeight;
};

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

/// From the tip up; the tip is at y = 0.
std::vector<Vec2d> hanging(const Form& form, const FormOptions& o,
                           const field::StalactiteCurve& curve, const Waves& waves) {
  const double length = (form.top - form.bottom).length(), top = length + form.root;
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
  for (size_t i = 0; i < side.size(); ++i) {
    const Vec2d& p = side[i];
    if (p.y < cut) {
      if (i + 1 < side.size() && side[i + 1].y > cut) {
        const double part = (cut - p.y) / (side[i + 1].y - p.y);
        out.emplace_back(0, cut);
        out.emplace_back(p.x + part * (side[i + 1].x - p.x), cut);
      }
      continue;
    }
    out.emplace_back(p.x * (1 + kWaves * waves.at(length - p.y)), p.y);
  }
  out.emplace_back(out.back().x, top);
  out.emplace_back(0, top);
  return out;
}

/// The radii of a stalagmite of a height, from the apex down; y is the height above the floor.
std::vector<Vec2d> trunk(const Form& form, double height, int count) {
  field::StalagmiteForm shape{form.radius, std::min(form.scatter, 0.8 * form.radius),
                              form.apex_cosine};
  const field::StalagmiteCurve curve(shape);
  if (!(curve.depth_at(shape.landing) < 0.9 * height))  // A low one is a cone or a plate.
    shape.landing = 0;
  std::vector<Vec2d> out;
  for (const Vec2d& p : field::StalagmiteCurve(shape).points(height, count))
    out.emplace_back(p.x, height - p.y);
  return out;
}

/// The radius at a height of an outline that is listed from the top down.
double radius_at(const std::vector<Vec2d>& outline, double y) {
  for (size_t i = 1; i < outline.size(); ++i) {
    const Vec2d &a = outline[i - 1], &b = outline[i];
    if (y > a.y || y < b.y) continue;
    const double part = a.y > b.y ? (a.y - y) / (a.y - b.y) : 0;
    return a.x + part * (b.x - a.x);
  }
  return y > outline.front().y ? 0 : outline.back().x;
}

/// From the apex down, so that the heights of girdles do not depend on later growth.
std::vector<Vec2d> standing(const Form& form, const Waves& waves) {
  const double height = form.top.y - form.bottom.y;
  const std::vector<Vec2d> exact = trunk(form, height, kStandingPoints);
  std::vector<Vec2d> curve = exact, out;
  // The curve has few points far below the apex; girdles need more.
  const int pieces = std::clamp(static_cast<int>(height / (0.25 * kGirdleHeight)), 0, 60);
  for (int i = 1; i < pieces; ++i) curve.emplace_back(-1, height * i / pieces);
  std::stable_sort(curve.begin(), curve.end(),
                   [](const Vec2d& a, const Vec2d& b) { return a.y > b.y; });
  for (Vec2d p : curve) {
    const double depth = height - p.y;
    if (p.x < 0 && depth < form.radius) continue;  // The apex keeps its curve.
    if (p.x < 0) p.x = radius_at(exact, p.y);
    const double grown = std::min(1.0, depth / form.radius);
    const double girdle = 1 + kGirdles * grown * waves.at(p.y);
    out.emplace_back(p.x * girdle * waves.taper(depth / height), std::max(p.y, 0.0));
  }
  out.emplace_back(out.back().x, -form.root);
  out.emplace_back(0, -form.root);
  return out;
}

std::vector<Vec2d> column(const Form& form, const FormOptions& o,
                          const field::StalactiteCurve& curve, const Waves& waves) {
  const double height = (form.top - form.bottom).length();
  const std::vector<Vec2d> lower = trunk(form, form.waist * height, kStandingPoints);
  const double tip = tip_radius(o, curve);
  const double end = curve.height_at(tip),
               least = std::max(tip, kLeastStraws * 0.5 * straw_diameter(10));
  std::vector<Vec2d> out;
  out.emplace_back(0, height + form.root);
  for (int i = 0; i <= kColumnPoints; ++i) {
    const double y = height * (1 - static_cast<double>(i) / kColumnPoints);
    const double above = y - form.waist * height;
    double radius = above > 0 ? curve.radius_at(end + above) : 0;
    radius = std::max({radius, radius_at(lower, y), least});
    const double aside = std::fabs(2 * y / height - 1);
    const double coat = form.coat * (kWaistCoat + (kEndCoat - kWaistCoat) * aside * aside * aside);
    radius = (radius + coat) * (1 + kWaves * waves.at(y));
    if (i == 0) out.emplace_back(radius, height + form.root);
    out.emplace_back(radius, y);
  }
  out.emplace_back(out.back().x, -form.root);
  out.emplace_back(0, -form.root);
  return out;
}

}  // namespace

std::vector<Vec2d> outline_of(const Form& form, const FormOptions& o,
                              const field::StalactiteCurve& curve) {
  const Waves waves(RandomKey(o.seed).at("girdles").at(static_cast<uint64_t>(form.drip)));
  if (form.kind == FormKind::column) return column(form, o, curve, waves);
  return form.kind == FormKind::stalagmite ? standing(form, waves) : hanging(form, o, curve, waves);
}

field::Field form_field(const Form& form, const FormOptions& o,
                        const field::StalactiteCurve& curve) {
  constexpr const char* kKinds[] = {"soda_straw", "stalactite", "stalagmite", "column"};
  const Vec3d axis = (form.top - form.bottom).normalized();
  const Transform placed =
      Transform::translation(form.bottom) * rotation_between(Vec3d(0, 1, 0), axis);
  return field::transformed(
      field::lathe(kKinds[static_cast<int>(form.kind)], outline_of(form, o, curve)), placed);
}

field::Field forms_field(const std::vector<Form>& forms, const FormOptions& o) {
  const field::StalactiteCurve curve = common_curve(o.girth);
  std::vector<field::Field> fields(forms.size());
  parallel_for(fields.size(), [&](size_t i) { fields[i] = form_field(forms[i], o, curve); });
  return field::unite(std::move(fields));
}

}  // namespace vug::drips
