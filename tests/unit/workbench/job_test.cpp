// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/workbench/job.h>

#include <chrono>
#include <thread>

namespace vug::workbench {
namespace {

template <class Result>
typename Job<Result>::Update wait(Job<Result>& job) {
  while (job.running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return job.poll();
}

TEST(Job, DeliversItsLastResult) {
  std::atomic<int> notified{0};
  Job<int> job([&] { ++notified; });
  job.start([](Progress&, const auto& publish) {
    for (int i = 0; i < 5; ++i) publish(i);
    return 7;
  });
  const auto update = wait(job);
  EXPECT_TRUE(update.ended);
  EXPECT_EQ(update.result, 7);
  EXPECT_EQ(update.generation, 1u);
  EXPECT_GE(notified, 6);
}

TEST(Job, AReplacedComputationLeavesNothing) {
  Job<int> job;
  job.start([](Progress& progress, const auto& publish) {
    publish(1);
    while (!progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return 1;
  });
  job.start([](Progress&, const auto&) { return 2; });
  const auto update = wait(job);
  EXPECT_EQ(update.generation, 2u);
  EXPECT_EQ(update.result, 2);
}

TEST(Job, ReportsErrorsButNotCancellation) {
  Job<int> job;
  job.start([](Progress&, const auto&) -> int {
    throw Error(ErrorCode::bad_input, "the photo is empty");
  });
  EXPECT_EQ(wait(job).error, "the photo is empty");
  job.start([](Progress& progress, const auto&) -> int {
    while (true) progress.check(), std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  job.cancel();
  const auto update = wait(job);
  EXPECT_TRUE(update.ended);
  EXPECT_FALSE(update.error);
  EXPECT_FALSE(update.result);
}

}  // namespace
}  // namespace vug::workbench
