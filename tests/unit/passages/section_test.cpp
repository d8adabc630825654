// SPDX-License-Identifier: Apache-2.0
// Properties of every family of sections: distances against the sampled outline, slopes, areas and
// bounds. A new family is included by its line in the list of kinds.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/passages/polygon_section.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

struct SectionCase {
  std::string label;
  SectionPtr section;
  bool exact;
};

/// Each family at several sizes. Sections with rounded concave corners are not exact inside.
std::vector<SectionCase> section_cases(bool rounded) {
  std::vector<SectionCase> cases;
  for (const SectionKind* kind : sections()) {
    const std::string& name = kind->info.name;
    NamedValues parameters;
    bool exact = true;
    for (const ParamInfo& info : kind->info.params) {
      if (info.name == "tilt") parameters.push_back({"tilt", Number{0.4, Dimension::angle}});
      if (info.name != "rounding" || name == "slot") continue;
      if (rounded)
        exact = false;
      else
        parameters.push_back({"rounding", Value(0.0)});
    }
    const SectionFamilyPtr family = make_family(name, parameters);
    for (const SectionPlace& place : {SectionPlace{2, 1.5, 0}, SectionPlace{0.8, 3, 0.3},
                                      SectionPlace{6, 2, -0.1}, SectionPlace{2, 2, 0}})
      cases.push_back(
          {name + " " + std::to_string(place.width) + " x " + std::to_string(place.height),
           family->fit(place), exact});
  }
  return cases;
}

double nearest(const std::vector<Vec2d>& points, const Vec2d& p) {
  double least = kInfinity;
  for (const Vec2d& q : points) least = std::min(least, (p - q).length2());
  return std::sqrt(least);
}

bool inside(const std::vector<Vec2d>& outline, const Vec2d& p) {
  bool odd = false;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      odd = !odd;
  }
  return odd;
}

Vec2d around(const Section& section, RandomStream& random) {
  const SectionTraits& t = section.traits();
  const double u = random.uniform(1.6 * t.min.x, 1.6 * t.max.x);
  return {u, random.uniform(1.6 * t.min.y, 1.6 * t.max.y)};
}

TEST(Section, DistancesAreThoseToTheOutline) {
  for (const bool rounded : {false, true})
    for (const SectionCase& c : section_cases(rounded)) {
      const std::vector<Vec2d> outline = c.section->outline(4000);
      double spacing = 0;
      for (size_t i = 0; i < outline.size(); ++i)
        spacing = std::max(spacing, (outline[i] - outline[(i + 1) % outline.size()]).length());
      RandomStream random(RandomKey(1).at(c.label));
      for (int i = 0; i < 300; ++i) {
        const Vec2d p = around(*c.section, random);
        const double away = nearest(outline, p), value = c.section->distance(p.x, p.y);
        ASSERT_LE(std::fabs(value), away + 1e-9) << c.label << " at " << p;
        if (away > spacing) {
          ASSERT_EQ(value < 0, inside(outline, p)) << c.label << " at " << p;
        }
        if (c.exact || value > 0) {
          ASSERT_GE(std::fabs(value),
                    away - 0.5 * spacing * spacing / (away + spacing) - 0.3 * spacing)
              << c.label << " at " << p;
        }
      }
      for (size_t i = 0; i < outline.size(); i += 7)
        ASSERT_LT(std::fabs(c.section->distance(outline[i].x, outline[i].y)), 2e-4) << c.label;
    }
}

TEST(Section, DistancesHaveTheLipschitzConstantOne) {
  for (const SectionCase& c : section_cases(true)) {
    RandomStream random(RandomKey(2).at(c.label));
    for (int i = 0; i < 2000; ++i) {
      const Vec2d p = around(*c.section, random);
      const double step = std::exp2(random.uniform(-12, 1));
      const Vec2d q = p + Vec2d(random.uniform(-1, 1), random.uniform(-1, 1)) * step;
      ASSERT_LE(std::fabs(c.section->distance(p.x, p.y) - c.section->distance(q.x, q.y)),
                (p - q).length() * (1 + 1e-9) + 1e-10)
          << c.label << " between " << p << " and " << q;
    }
  }
}

TEST(Section, SlopesEqualDifferences) {
  for (const SectionCase& c : section_cases(true)) {
    RandomStream random(RandomKey(3).at(c.label));
    int smooth = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec2d p = around(*c.section, random);
      const double h = 1e-5;
      const auto value = [&](double u, double v) { return c.section->distance(u, v); };
      const double here = value(p.x, p.y);
      if (std::fabs(value(p.x + h, p.y) - 2 * here + value(p.x - h, p.y)) > 1e-3 * h ||
          std::fabs(value(p.x, p.y + h) - 2 * here + value(p.x, p.y - h)) > 1e-3 * h)
        continue;
      ++smooth;
      const PlaneDistance<double> d = c.section->at(p.x, p.y);
      ASSERT_NEAR(d.du, (value(p.x + h, p.y) - value(p.x - h, p.y)) / (2 * h), 2e-3)
          << c.label << p;
      ASSERT_NEAR(d.dv, (value(p.x, p.y + h) - value(p.x, p.y - h)) / (2 * h), 2e-3)
          << c.label << p;
    }
    EXPECT_GT(smooth, 250) << c.label;
  }
}

TEST(Section, TheOutlineHasASlope) {
  for (const SectionCase& c : section_cases(false))
    for (const Vec2d& p : c.section->outline(64)) {
      const PlaneDistance<double> d = c.section->at(p.x, p.y);
      ASSERT_GT(std::hypot(d.du, d.dv), 0.9) << c.label << " at " << p;
    }
}

// Also where convergence is slowest: on the longer axis, and near the ellipse's centres of
// curvature.
TEST(Section, EllipsesInSinglePrecisionAreExactUpToRounding) {
  RandomStream random(RandomKey(6));
  for (const double ratio : {1.05, 2.0, 4.0, 10.0, 30.0, 100.0}) {
    const double b = 0.7, a = ratio * b;
    const SectionPtr tube = make_family("tube")->fit({2 * a, 2 * b, 0});
    for (int round = 0; round < 1500; ++round) {
      float u[8], v[8], found[8];
      for (int lane = 0; lane < 8; ++lane) {
        const double near = b * std::exp2(random.uniform(-20, 0));
        double x = random.uniform(-1.6, 1.6) * a, y = random.uniform(-2.6, 2.6) * b;
        if (lane % 4 == 1) y = 0;
        if (lane % 4 == 2) y = near;
        if (lane % 4 == 3) x = (a - b * b / a) * random.uniform(0.97, 1.03), y = near;
        u[lane] = static_cast<float>(x);
        v[lane] = static_cast<float>(y);
      }
      const Pack pu = Pack::load(u), pv = Pack::load(v);
      Pack out;
      tube->distances(&pu, &pv, 1, &out);
      out.store(found);
      for (int lane = 0; lane < 8; ++lane)
        ASSERT_NEAR(static_cast<double>(found[lane]),
                    tube->distance(static_cast<double>(u[lane]), static_cast<double>(v[lane])),
                    1e-6 * a)
            << ratio << " at " << u[lane] << " " << v[lane];
    }
  }
}

TEST(Section, FlatLensesInSinglePrecisionAreExactUpToRounding) {
  // The arcs of the flattest lens have a radius of 2.5e8 m.
  for (const double ratio : {2.0, 30.0, 1e4, 1e8}) {
    const double half = 5;
    const SectionPtr lens = make_family("lens")->fit({2 * half, 2 * half / ratio, 0});
    RandomStream random(RandomKey(7));
    for (int round = 0; round < 200; ++round) {
      float u[8], v[8], found[8];
      for (int lane = 0; lane < 8; ++lane) {
        u[lane] = static_cast<float>(random.uniform(-1.5, 1.5) * half);
        v[lane] = static_cast<float>(random.uniform(-1, 1) * (lane < 4 ? half : half / ratio));
      }
      const Pack pu = Pack::load(u), pv = Pack::load(v);
      Pack out;
      lens->distances(&pu, &pv, 1, &out);
      out.store(found);
      for (int lane = 0; lane < 8; ++lane) {
        const double x = static_cast<double>(u[lane]), y = static_cast<double>(v[lane]);
        ASSERT_NEAR(static_cast<double>(found[lane]), lens->distance(x, y), 2e-6 * half)
            << ratio << " at " << x << " " << y;
        // A very flat lens is the segment between its tips.
        if (ratio > 1e7) {
          ASSERT_NEAR(lens->distance(x, y), std::hypot(std::max(std::fabs(x) - half, 0.0), y),
                      1e-6 * half);
        }
      }
    }
  }
}

TEST(Section, BatchesAgreeWithScalars) {
  for (const SectionCase& c : section_cases(true)) {
    RandomStream random(RandomKey(4).at(c.label));
    for (int round = 0; round < 40; ++round) {
      float u[8], v[8], value[8], same[8];
      for (int lane = 0; lane < 8; ++lane) {
        const Vec2d p = around(*c.section, random);
        u[lane] = static_cast<float>(p.x);
        v[lane] = static_cast<float>(p.y);
      }
      const Pack pu = Pack::load(u), pv = Pack::load(v);
      Pack out;
      PlaneDistance<Pack> slopes;
      c.section->distances(&pu, &pv, 1, &out);
      c.section->slopes(&pu, &pv, 1, &slopes);
      out.store(value);
      slopes.value.store(same);
      for (int lane = 0; lane < 8; ++lane) {
        const double expected =
            c.section->distance(static_cast<double>(u[lane]), static_cast<double>(v[lane]));
        ASSERT_NEAR(static_cast<double>(value[lane]), expected, 1e-5) << c.label;
        ASSERT_EQ(value[lane], same[lane]) << c.label;
      }
    }
  }
}

TEST(Section, TraitsBoundTheInside) {
  for (const SectionCase& c : section_cases(true)) {
    const SectionTraits& t = c.section->traits();
    const std::vector<Vec2d> outline = c.section->outline(4000);
    double reach = 0;
    Vec2d low(0), high(0);
    for (const Vec2d& p : outline) {
      reach = std::max(reach, p.length());
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    EXPECT_LE(reach, t.reach + 1e-9) << c.label;
    EXPECT_LT((low - t.min).length() + (high - t.max).length(), 5e-3 * t.reach) << c.label;
    EXPECT_NEAR(0.5 * twice_area(outline), t.area, 2e-3 * t.area) << c.label;
    RandomStream random(RandomKey(5).at(c.label));
    int in = 0;
    constexpr int kCount = 40000;
    for (int i = 0; i < kCount; ++i) {
      const double u = random.uniform(t.min.x, t.max.x);
      const double value = c.section->distance(u, random.uniform(t.min.y, t.max.y));
      in += value < 0;
      ASSERT_GE(value, -t.depth - 1e-12) << c.label;
    }
    EXPECT_NEAR(t.width() * t.height() * in / kCount, t.area, 0.03 * t.area) << c.label;
    EXPECT_GT(t.core, 0) << c.label;
    for (int i = 0; i < 64; ++i) {
      const double angle = 2 * kPi * i / 64;
      EXPECT_LE(
          c.section->distance(0.999 * t.core * std::cos(angle), 0.999 * t.core * std::sin(angle)),
          1e-9)
          << c.label;
    }
  }
}

TEST(Section, IntervalsContainSamples) {
  for (const SectionCase& c : section_cases(true)) {
    RandomStream random(RandomKey(6).at(c.label));
    for (int i = 0; i < 200; ++i) {
      const Vec2d p = around(*c.section, random), q = around(*c.section, random);
      const Interval u(std::min(p.x, q.x), std::max(p.x, q.x)),
          v(std::min(p.y, q.y), std::max(p.y, q.y));
      const Interval range = c.section->interval(u, v);
      for (int k = 0; k < 20; ++k) {
        const double at = random.uniform(u.lo, u.hi);
        EXPECT_TRUE(range.contains(c.section->distance(at, random.uniform(v.lo, v.hi)))) << c.label;
      }
    }
  }
}

TEST(Section, TubesFillTheirWidthAndHeight) {
  const SectionPtr tube = make_family("tube")->fit({3, 2, 0});
  EXPECT_NEAR(tube->distance(1.5, 0), 0, 1e-12);
  EXPECT_NEAR(tube->distance(0, 1), 0, 1e-12);
  EXPECT_NEAR(tube->distance(0, 5), 4, 1e-12);
  EXPECT_NEAR(tube->traits().area, kPi * 1.5, 1e-12);
}

TEST(Section, CanyonsMigrateTowardsTheOuterBank) {
  const SectionFamilyPtr canyon = make_family("canyon");
  const auto floor_middle = [&](double curvature) {
    const SectionPtr section = canyon->fit({1, 8, curvature});
    double low = kInfinity, high = -kInfinity;
    for (const Vec2d& p : section->outline(2000))
      if (p.y < -3.8) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
      }
    return 0.5 * (low + high);
  };
  EXPECT_NEAR(floor_middle(0), 0, 1e-9);
  EXPECT_GT(floor_middle(0.4), 0.2);  // A bend to the left: the outer bank is on the right.
  EXPECT_LT(floor_middle(-0.4), -0.2);
}

TEST(Section, InvalidSizesAreRefused) {
  for (const SectionKind* kind : sections()) {
    const SectionFamilyPtr family = make_family(kind->info.name);
    for (const double bad : {0.0, -1.0, kInfinity, std::nan("")}) {
      EXPECT_THROW(family->fit({bad, 1, 0}), Error) << kind->info.name;
      EXPECT_THROW(family->fit({1, bad, 0}), Error) << kind->info.name;
    }
    EXPECT_THROW(family->fit({1, 1, std::nan("")}), Error) << kind->info.name;
  }
  EXPECT_THROW(polygon_section({{0, 0}, {1, 0}}), Error);
  EXPECT_THROW(polygon_section({{1, 1}, {2, 1}, {1, 2}}), Error);      // The origin is outside.
  EXPECT_THROW(polygon_section({{-1, -1}, {-1, 2}, {2, -1}}), Error);  // Clockwise.
}

}  // namespace
}  // namespace vug::passages
