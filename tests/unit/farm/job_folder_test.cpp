// SPDX-License-Identifier: Apache-2.0
// The states of tasks according to the files of a job, and claims.
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/farm/claim.h>
#include <vug/farm/job_folder.h>
#include <vug/farm/plan_job.h>

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

namespace vug::farm {
namespace {

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    JobOptions options;
    options.scene = "/cave.vug";
    options.name = "cave";
    options.spp = 4;
    options.parts = 2;
    write_text(scratch_.file(kJobFile), to_json(plan_job(options)));
    job_ = std::make_unique<JobFolder>(scratch_.path());
  }
  const Task& task(size_t i) const { return job_->job().tasks.at(i); }
  void make(size_t i) { write_text(job_->file(task(i).makes), "x"); }
  void end(size_t i, Ending ending) { job_->add_run(task(i), {ending, 1.5, "node:1"}); }

  const ScratchFolder scratch_{"vug_job_folder"};
  std::unique_ptr<JobFolder> job_;
};

TEST_F(Folder, TasksWaitForThoseTheyNeed) {
  EXPECT_EQ(job_->state(0), TaskState::ready);
  EXPECT_EQ(job_->state(1), TaskState::waiting);
  make(0);
  EXPECT_EQ(job_->state(0), TaskState::done);
  EXPECT_EQ(job_->state(1), TaskState::ready);
  make(1);
  EXPECT_FALSE(job_->complete(job_->job().pictures[0]));
  make(2);
  EXPECT_TRUE(job_->complete(job_->job().pictures[0]));
  EXPECT_FALSE(job_->finished());
  write_text(job_->file("cave.exr"), "x");
  EXPECT_TRUE(job_->finished());
}

TEST_F(Folder, PartsOfAFinishedPictureMayBeRemoved) {
  write_text(job_->file("cave.exr"), "x");
  EXPECT_EQ(job_->state(1), TaskState::done);
  EXPECT_EQ(job_->state(2), TaskState::done);
}

TEST_F(Folder, TasksFailForGoodAfterThreeFailuresOrByTheirInput) {
  for (int i = 0; i < kMostFailures; ++i) {
    EXPECT_EQ(job_->state(0), TaskState::ready) << i;
    end(0, i % 2 ? Ending::killed : Ending::failed);
  }
  EXPECT_EQ(job_->state(0), TaskState::failed);
  make(0);
  EXPECT_EQ(job_->state(0), TaskState::done);
  end(1, Ending::unusable);
  EXPECT_EQ(job_->state(1), TaskState::failed);
  for (int i = 0; i < 2 * kMostFailures; ++i) end(2, Ending::stopped);
  EXPECT_EQ(job_->state(2), TaskState::ready);
}

TEST_F(Folder, RunsAreKeptInTheirOrder) {
  end(0, Ending::stopped);
  end(0, Ending::done);
  const std::vector<farm::Run> runs = job_->runs(task(0));
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].ending, Ending::stopped);
  EXPECT_EQ(runs[1].ending, Ending::done);
  EXPECT_EQ(runs[1].seconds, 1.5);
  EXPECT_EQ(runs[1].where, "node:1");
}

TEST_F(Folder, DamagedPartsAreRemoved) {
  make(1);
  EXPECT_EQ(job_->remove_damaged_parts(job_->job().pictures[0]),
            (std::vector<std::string>{task(1).makes, task(2).makes}));  // one damaged, one missing
  EXPECT_FALSE(job_->made(task(1)));
}

TEST_F(Folder, OneProcessAtATimeClaimsATask) {
  const auto file = job_->state_file(task(0), "claim");
  {
    const auto claim = Claim::take(file);
    ASSERT_TRUE(claim);
    EXPECT_FALSE(Claim::take(file));
    EXPECT_EQ(job_->state(0), TaskState::running);
  }
  EXPECT_EQ(job_->state(0), TaskState::ready);
  EXPECT_TRUE(Claim::take(file));
}

TEST_F(Folder, TheClaimOfADeadProcessIsTakenOver) {
  const auto file = job_->state_file(task(0), "claim");
  write_text(file, "node:1\n");
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(file, now - 2 * kDeadAfter);
  EXPECT_EQ(job_->state(0), TaskState::ready);
  std::vector<std::unique_ptr<Claim>> claims(8);
  std::vector<std::thread> threads;
  for (auto& claim : claims) threads.emplace_back([&] { claim = Claim::take(file); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::count_if(claims.begin(), claims.end(), [](const auto& c) { return c != nullptr; }),
            1);
}

TEST_F(Folder, AClaimIsKeptAliveByItsHeart) {
  const auto file = job_->state_file(task(0), "claim");
  const auto claim = Claim::take(file);
  ASSERT_TRUE(claim);
  const auto old = std::filesystem::file_time_type::clock::now() - 2 * kDeadAfter;
  std::filesystem::last_write_time(file, old);
  std::this_thread::sleep_for(kHeartbeat + std::chrono::milliseconds(500));
  EXPECT_TRUE(is_alive(file));
}

}  // namespace
}  // namespace vug::farm
