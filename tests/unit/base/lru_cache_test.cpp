// SPDX-License-Identifier: Apache-2.0
// The cache keeps the values that were used last, within its size.
#include <vug/base/digester.h>
#include <vug/base/lru_cache.h>

#include <gtest/gtest.h>

namespace vug {
namespace {

std::shared_ptr<const int> number(int value) { return std::make_shared<const int>(value); }

TEST(LruCache, DropsTheValuesThatWereNotUsedForTheLongestTime) {
  LruCache<int> cache(30);
  for (int i = 0; i < 3; ++i) cache.insert(digest_of(i), number(i), 10);
  EXPECT_EQ(cache.bytes(), 30u);
  ASSERT_NE(cache.find(digest_of(0)), nullptr);
  cache.insert(digest_of(3), number(3), 10);
  EXPECT_EQ(cache.find(digest_of(1)), nullptr);
  for (const int i : {0, 2, 3}) {
    ASSERT_NE(cache.find(digest_of(i)), nullptr) << i;
    EXPECT_EQ(*cache.find(digest_of(i)), i);
  }
  cache.insert(digest_of(4), number(4), 20);  // Drops two.
  EXPECT_EQ(cache.find(digest_of(0)), nullptr);
  EXPECT_EQ(cache.find(digest_of(2)), nullptr);
  EXPECT_EQ(cache.bytes(), 30u);
}

TEST(LruCache, ReplacesValues) {
  LruCache<int> cache(30);
  cache.insert(digest_of(1), number(1), 10);
  const auto used = cache.find(digest_of(1));
  cache.insert(digest_of(1), number(2), 20);
  EXPECT_EQ(*cache.find(digest_of(1)), 2);
  EXPECT_EQ(*used, 1);  // Values live as long as they are used.
  EXPECT_EQ(cache.bytes(), 20u);
}

TEST(LruCache, DoesNotKeepAValueThatIsLargerThanTheCache) {
  LruCache<int> cache(30);
  cache.insert(digest_of(1), number(1), 31);
  EXPECT_EQ(cache.find(digest_of(1)), nullptr);
  EXPECT_EQ(cache.bytes(), 0u);
}

}  // namespace
}  // namespace vug
