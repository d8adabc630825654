// SPDX-License-Identifier: Apache-2.0
// Boxes are found by place, whatever their sizes.
#include <gtest/gtest.h>
#include <vug/base/box_index.h>
#include <vug/base/rng.h>

namespace vug {
namespace {

Box3d random_box(RandomStream& random) {
  Vec3d middle, half;
  for (int axis = 0; axis < 3; ++axis) middle[axis] = random.uniform(-50, 50);
  // Most are small, some are as large as the space between them.
  const double size = std::ldexp(1.0, static_cast<int>(random.below(12)) - 6);
  for (int axis = 0; axis < 3; ++axis) half[axis] = size * random.uniform();
  return {middle - half, middle + half};
}

std::vector<int> found(const BoxIndex& index, const Box3d& box) {
  std::vector<int> numbers;
  index.any_meeting(box, [&](int number) {
    numbers.push_back(number);
    return false;
  });
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(BoxIndex, FindsExactlyTheBoxesThatMeetOne) {
  RandomStream random(RandomKey(3));
  std::vector<Box3d> boxes;
  BoxIndex index;
  for (int i = 0; i < 400; ++i) {
    boxes.push_back(random_box(random));
    index.add(i, boxes.back());
    const Box3d query = random_box(random);
    std::vector<int> expected;
    for (int k = 0; k <= i; ++k)
      if (boxes[static_cast<size_t>(k)].intersects(query)) expected.push_back(k);
    EXPECT_EQ(found(index, query), expected);
  }
}

TEST(BoxIndex, InfiniteBoxesAreEverywhereAndEmptyOnesNowhere) {
  BoxIndex index;
  index.add(0, Box3d());
  index.add(1, {Vec3d(-kInfinity), Vec3d(kInfinity)});
  index.add(2, Box3d(Vec3d(1e300)));
  index.add(3, Box3d(Vec3d(0.0)));
  EXPECT_EQ(found(index, Box3d(Vec3d(0.0))), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(found(index, Box3d(Vec3d(5.0))), (std::vector<int>{1, 2}));
  EXPECT_TRUE(index.any_meeting(Box3d(Vec3d(0.0)), [](int number) { return number == 3; }));
}

}  // namespace
}  // namespace vug
