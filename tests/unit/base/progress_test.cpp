// SPDX-License-Identifier: Apache-2.0
// Stages are reported to a watcher in order; overlapping workers share a Progress without a
// watcher.
#include <vug/base/error.h>
#include <vug/base/progress.h>

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace vug {
namespace {

TEST(Progress, ReportsEachPercentOnceAndEndsAt100) {
  std::vector<double> reported;
  Progress progress([&](const std::string& stage, double fraction) {
    EXPECT_EQ(stage, "digging");
    reported.push_back(fraction);
  });
  progress.begin("digging", 1000);
  for (int i = 0; i < 1000; ++i) progress.advance();
  progress.end();
  ASSERT_EQ(reported.size(), 101U);
  for (size_t i = 0; i < reported.size(); ++i)
    EXPECT_DOUBLE_EQ(reported[i], static_cast<double>(i) / 100);
}

TEST(Progress, ReportsOneAtATimeAndNeverBackwards) {
  std::atomic<int> inside{0};
  double last = -1;
  bool overlapped = false, fell = false;
  Progress progress([&](const std::string&, double fraction) {
    overlapped = overlapped || ++inside > 1;
    std::this_thread::yield();
    fell = fell || fraction <= last;
    last = fraction;
    --inside;
  });
  for (int round = 0; round < 20; ++round) {
    last = -1;
    progress.begin("digging", 4000);
    std::vector<std::thread> diggers;
    for (int i = 0; i < 8; ++i)
      diggers.emplace_back([&] {
        for (int k = 0; k < 500; ++k) progress.advance();
      });
    for (std::thread& digger : diggers) digger.join();
    progress.end();
    EXPECT_EQ(last, 1);
  }
  EXPECT_FALSE(overlapped);
  EXPECT_FALSE(fell);
}

TEST(Progress, StagesEndOnceAndNameTheirProduct) {
  std::vector<std::string> ended;
  Progress progress([&](const std::string& stage, double fraction) {
    if (fraction >= 1) ended.push_back(stage);
  });
  {
    const Progress::Product rock(progress, "rock");
    progress.begin("voxels", 2);
    progress.advance(2);
    EXPECT_TRUE(ended.empty()) << "all units are done, but the stage has not ended";
    {
      const Progress::Product wall(progress, "wall");
      EXPECT_EQ(run_stage(progress, "triangles", [] { return 7; }), 7);  // ends the voxels
    }
    run_stage(progress, "components", [] {});
    progress.end();
  }
  run_stage(progress, "rendering", [] {});
  EXPECT_EQ(ended, (std::vector<std::string>{"voxels of 'rock'", "triangles of 'wall'",
                                             "components of 'rock'", "rendering"}));
}

TEST(Progress, CancelledWorkStopsAtTheNextCheck) {
  Progress progress;
  progress.check();
  progress.cancel();
  EXPECT_THROW(progress.check(), Error);
  EXPECT_THROW(progress.begin("next", 1), Error);
}

TEST(Progress, OverlappingWorkersShareOneWithoutAWatcher) {
  std::vector<std::thread> works;
  for (int work = 0; work < 4; ++work)
    works.emplace_back([work] {
      for (int i = 0; i < 20000; ++i) {
        // Longer than the small-string buffer.
        Progress::none().begin(std::string(40 + static_cast<size_t>(work), 'x'), 10);
        Progress::none().advance();
        Progress::none().end();
      }
    });
  for (std::thread& work : works) work.join();
  EXPECT_NO_THROW(Progress::none().check());
}

}  // namespace
}  // namespace vug
