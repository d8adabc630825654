// SPDX-License-Identifier: Apache-2.0
// The loops visit every index once and propagate exceptions, with TBB and with plain threads.
#include <vug/base/parallel.h>
#include <vug/base/parallel_sort.h>
#include <vug/base/tsan_parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

namespace vug {
namespace {

class Parallel : public testing::TestWithParam<bool> {
 protected:
  static void loop(size_t count, size_t grain, const std::function<void(size_t)>& body) {
    if (!GetParam()) return parallel_for(count, body, grain);
    detail::tsan_parallel_for(count, grain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) body(i);
    });
  }
};

TEST_P(Parallel, VisitsEachIndexOnce) {
  with_threads(7, [&] {
    for (const size_t count : {0U, 1U, 7U, 1000U})
      for (const size_t grain : {1U, 3U, 5000U}) {
        std::vector<int> visits(count);
        loop(count, grain, [&](size_t i) { ++visits[i]; });
        EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " by " << grain;
      }
  });
}

TEST_P(Parallel, NestedLoopsWork) {
  with_threads(3, [&] {
    for (int round = 0; round < 2; ++round) {
      std::vector<size_t> sums(50);
      loop(50, 1, [&](size_t i) {
        std::vector<size_t> parts(20);
        loop(20, 4, [&](size_t j) { parts[j] = i * j; });
        sums[i] = std::accumulate(parts.begin(), parts.end(), size_t{0});
      });
      for (size_t i = 0; i < 50; ++i) EXPECT_EQ(sums[i], 190 * i);
    }
  });
}

TEST_P(Parallel, PropagatesExceptions) {
  with_threads(3, [&] {
    EXPECT_THROW(loop(1000, 1,
                      [](size_t i) {
                        if (i == 500) throw std::runtime_error("500");
                      }),
                 std::runtime_error);
  });
}

TEST_P(Parallel, HasAsManyThreadsAsRequested) {
  // Each index waits until all others have started, which needs a thread for each.
  for (const int threads : {1, 2, 5, 8}) {
    std::atomic<int> started = 0;
    std::atomic<bool> all = true;
    with_threads(threads, [&] {
      EXPECT_EQ(thread_count(), threads);
      loop(static_cast<size_t>(threads), 1, [&](size_t) {
        ++started;
        const auto begin = std::chrono::steady_clock::now();
        while (started < threads) {
          if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(20)) all = false;
          if (!all) return;
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      });
    });
    EXPECT_TRUE(all) << threads;
  }
}

TEST(WithThreads, ReturnsTheResultAndRestoresTheNumber) {
  const int before = thread_count();
  EXPECT_EQ(with_threads(5, [] { return thread_count(); }), 5);
  EXPECT_THROW(with_threads(5, [] { throw std::runtime_error("work"); }), std::runtime_error);
  EXPECT_EQ(thread_count(), before);
}

INSTANTIATE_TEST_SUITE_P(Backends, Parallel, testing::Values(false, true),
                         [](const auto& backend) { return backend.param ? "plain" : "tbb"; });

#ifdef __SANITIZE_THREAD__
TEST(ThreadSanitizerDeathTest, DetectsARaceInParallelFor) {
  // Shows that tests/sanitizers/tsan.supp does not suppress races in functions called by
  // parallel_for.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto race = [] {
    with_threads(4, [&] {
      size_t sum = 0;
      parallel_for(100000, [&](size_t i) { sum += i; });
      std::exit(0);
    });
  };
  EXPECT_EXIT(race(), testing::ExitedWithCode(66), "data race");
}
#endif

TEST(OrderedSum, IsTheSameForAnyNumberOfThreads) {
  const auto sum = [](int threads) {
    return with_threads(threads, [&] {
      return ordered_sum(100000, 0.0, [](size_t i) { return 1.0 / static_cast<double>(1 + i); });
    });
  };
  const double alone = sum(1);
  EXPECT_EQ(sum(2), alone);
  EXPECT_EQ(sum(7), alone);
}

TEST(OrderedReduce, JoinsInIndexOrder) {
  // Joining texts is associative but not commutative.
  with_threads(7, [&] {
    const auto text = ordered_reduce(
        26, std::string(), [](size_t i) { return std::string(1, static_cast<char>('a' + i)); },
        [](const std::string& a, const std::string& b) { return a + b; }, 3);
    EXPECT_EQ(text, "abcdefghijklmnopqrstuvwxyz");
  });
}

TEST(ParallelSort, Sorts) {
  with_threads(7, [&] {
    std::vector<uint64_t> numbers(20000);
    for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = i * 7919 % 20011;
    std::vector<uint64_t> expected = numbers;
    std::sort(expected.begin(), expected.end());
    parallel_sort(numbers.begin(), numbers.end());
    EXPECT_EQ(numbers, expected);
  });
}

}  // namespace
}  // namespace vug
