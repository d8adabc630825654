// SPDX-License-Identifier: Apache-2.0
// Lower bounds of a segment's values, for every family of sections.
#include <vug/base/rng.h>
#include <vug/passages/sweep/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

Segment random_segment(const SectionFamily& family, RandomStream& random) {
  const auto frame = [&](const Vec3d& at) {
    SectionFrame out;
    out.position = at;
    const double turn = random.uniform(-0.3, 0.3);
    out.right = {std::cos(turn), 0, std::sin(turn)};
    out.section = family.fit({random.uniform(0.5, 4), random.uniform(0.5, 8), 0.05});
    return out;
  };
  const Vec3d start(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50));
  return Segment(frame(start), frame(start + Vec3d(random.uniform(-1, 1), random.uniform(-1, 1),
                                                   random.uniform(1, 6))));
}

TEST(SegmentBounds, NoValueIsBelowItsBound) {
  for (const SectionKind* kind : sections()) {
    RandomStream random(RandomKey(61).at(kind->info.name));
    if (kind->info.name == "filled") continue;  // Its section depends on another one.
    const SectionFamilyPtr family = make_family(kind->info.name);
    for (int n = 0; n < 20; ++n) {
      const Segment segment = random_segment(*family, random);
      for (int i = 0; i < 200; ++i) {
        const double far = i % 2 ? 1 : 4;
        const Vec3d p = 0.5 * (segment.start() + segment.end()) +
                        Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) *
                            (far * segment.reach());
        const double value = segment.value(field::point(p)), bound = segment.least(p);
        ASSERT_LE(bound, value + segment.rounding(p)) << kind->info.name << " at " << p;
        const Point<Pack> at = field::constant<Pack>(p);
        Pack packed;
        segment.least(&at, 1, &packed);
        float lanes[Pack::kLanes];
        packed.store(lanes);
        ASSERT_NEAR(static_cast<double>(lanes[0]), bound, 1e-4 * segment.reach()) << p;
      }
    }
  }
}

TEST(SegmentBounds, TallSectionsAreBoundedAlongTheirWidth) {
  SectionFrame from, to;
  from.section = to.section = make_family("trapezoid")->fit({2, 10, 0});
  to.position = {0, 0, 5};
  const Segment segment(from, to);
  EXPECT_GT(segment.least({4, 0, 2.5}), 2.9);  // A circle around the section has a radius above 5.
  EXPECT_GT(segment.least({0, 7, 2.5}), 1.9);
}

}  // namespace
}  // namespace vug::passages
