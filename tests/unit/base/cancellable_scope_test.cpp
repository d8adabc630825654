// SPDX-License-Identifier: Apache-2.0
// Work without a Progress stops when that of its scope is cancelled.
#include <vug/base/cancellable_scope.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/progress.h>

#include <gtest/gtest.h>

#include <atomic>

namespace vug {
namespace {

constexpr size_t kCount = 10000;

/// The number of indices that a loop visits which cancels `progress` at its first index; -1 if it
/// ends by Error(cancelled).
int visited(Progress& progress, int threads) {
  std::atomic<int> count = 0;
  try {
    with_threads(threads, [&] {
      parallel_for(kCount, [&](size_t) {
        progress.cancel();
        ++count;
      });
    });
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
    return -1;
  }
  return count;
}

TEST(CancellableScope, StopsLoopsOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    Progress progress;
    EXPECT_EQ(visited(progress, threads), static_cast<int>(kCount));  // no scope
    Progress stopped;
    const CancellableScope scope(stopped);
    EXPECT_EQ(visited(stopped, threads), -1) << threads;
  }
}

TEST(CancellableScope, ReachesNestedLoops) {
  Progress progress;
  const CancellableScope scope(progress);
  std::atomic<int> inner = 0;
  EXPECT_THROW(with_threads(2,
                            [&] {
                              parallel_for(8, [&](size_t) {
                                parallel_for(kCount, [&](size_t) {
                                  if (++inner == 100) progress.cancel();
                                });
                              });
                            }),
               Error);
  EXPECT_LT(inner, static_cast<int>(8 * kCount));
}

TEST(CancellableScope, TheInnermostCounts) {
  Progress outer;
  const CancellableScope scope(outer);
  {
    const CancellableScope whole(Progress::none());
    EXPECT_EQ(visited(outer, 2), static_cast<int>(kCount));
    EXPECT_NO_THROW(check_cancelled());
  }
  EXPECT_THROW(check_cancelled(), Error);
}

TEST(CancellableScope, StagesAreScopes) {
  Progress progress;
  EXPECT_THROW(run_stage(progress, "digging",
                         [&] {
                           progress.cancel();
                           check_cancelled();
                           FAIL() << "the stage went on";
                         }),
               Error);
  EXPECT_NO_THROW(check_cancelled());
}

}  // namespace
}  // namespace vug
