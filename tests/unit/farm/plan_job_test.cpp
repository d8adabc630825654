// SPDX-License-Identifier: Apache-2.0
// The tasks of a job and the files for other programs.
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/farm/engine_files.h>
#include <vug/farm/plan_job.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace vug::farm {
namespace {

JobOptions options(int frames, int parts) {
  JobOptions out;
  out.scene = "/scenes/cave.vug";
  out.name = "cave";
  out.render_arguments = {"--quiet", "--size", "64x40"};
  for (int i = 0; i < frames; ++i) out.frames.push_back(i + 1);
  out.spp = 30;
  out.parts = parts;
  out.cost.build_seconds = 60;
  out.cost.learn_seconds = 10;
  out.cost.render_seconds = 4000;
  out.cost.bytes = 2e9;
  out.inputs = {{"/scenes/cave.vug", "0123"}};
  return out;
}

/// The value that follows a word in the arguments.
std::string value_of(const Task& task, const std::string& word) {
  const auto at = std::find(task.arguments.begin(), task.arguments.end(), word);
  return at == task.arguments.end() ? "" : *(at + 1);
}

TEST(PlanJob, PartsCoverEachSampleOnce) {
  for (const int parts : {2, 3, 7, 30}) {
    const Job job = plan_job(options(2, parts));
    ASSERT_EQ(job.pictures.size(), 2U);
    for (const Picture& picture : job.pictures) {
      uint32_t next = 0;
      for (const size_t part : picture.parts) {
        uint32_t begin = 0, end = 0;
        const std::string samples = value_of(job.tasks[part], "--samples");
        ASSERT_EQ(std::sscanf(samples.c_str(), "%u..%u", &begin, &end), 2) << samples;
        EXPECT_EQ(begin, next);
        EXPECT_GT(end, begin);
        next = end;
      }
      EXPECT_EQ(next, 30U);
    }
  }
}

TEST(PlanJob, TasksReadOnlyFilesOfTasksThatTheyNeed) {
  const Job job = plan_job(options(3, 4));
  std::set<std::string> names, files;
  for (size_t i = 0; i < job.tasks.size(); ++i) {
    const Task& task = job.tasks[i];
    EXPECT_TRUE(names.insert(task.name).second) << task.name;
    EXPECT_TRUE(files.insert(task.makes).second) << task.makes;
    const std::string learned = value_of(task, "--guiding");
    if (task.part_of) {
      ASSERT_EQ(task.needs.size(), 1U);
      EXPECT_EQ(job.tasks[task.needs[0]].makes, learned);
    }
    for (const size_t needed : task.needs) EXPECT_LT(needed, i);
  }
  EXPECT_EQ(job.tasks.size(), 3U * (1 + 4));
}

TEST(PlanJob, AnUndividedPictureIsOneTaskThatMakesIt) {
  const Job job = plan_job(options(3, 1));
  ASSERT_EQ(job.tasks.size(), 3U);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(job.tasks[i].makes, job.pictures[i].file);
    EXPECT_EQ(value_of(job.tasks[i], "-o"), job.pictures[i].file);
    EXPECT_TRUE(job.pictures[i].parts.empty());
  }
}

TEST(PlanJob, RefusesEmptyParts) {
  EXPECT_THROW(plan_job(options(1, 0)), Error);
  EXPECT_THROW(plan_job(options(1, 31)), Error);
}

TEST(PlanJob, DefaultPartsLeaveEachTaskMinutesAndSamples) {
  JobOptions still = options(0, 1);
  EXPECT_EQ(default_parts(still, 4), 4);
  EXPECT_EQ(default_parts(still, 1000), 7);  // 30 samples / 4
  still.cost.render_seconds = 250;
  EXPECT_EQ(default_parts(still, 1000), 2);
  still.cost.render_seconds = 1;
  EXPECT_EQ(default_parts(still, 1000), 1);
  EXPECT_EQ(default_parts(options(240, 1), 16), 1);
}

TEST(Job, IsTheSameAfterWritingAndReading) {
  const ScratchFolder folder("vug_job");
  const Job job = plan_job(options(2, 3));
  std::ofstream(folder.file(kJobFile)) << to_json(job);
  EXPECT_EQ(read_job(folder.path()), job);
  EXPECT_EQ(to_json(read_job(folder.path())), to_json(job));
}

TEST(Job, BrokenFilesAreRefused) {
  const ScratchFolder folder("vug_job");
  EXPECT_THROW(read_job(folder.path()), Error);
  Job job = plan_job(options(2, 3));
  job.tasks[0].needs = {5};
  std::ofstream(folder.file(kJobFile)) << to_json(job);
  EXPECT_THROW(read_job(folder.path()), Error);
  for (const char* text : {"", "[]", "{}", "{\"version\": 3}"}) {
    std::ofstream(folder.file(kJobFile)) << text;
    EXPECT_THROW(read_job(folder.path()), Error) << text;
  }
}

TEST(EngineFiles, LevelsRunEachTaskOnceAfterItsNeeds) {
  const Job job = plan_job(options(3, 4));
  std::set<size_t> done;
  for (const auto& ranges : levels(job)) {
    std::set<size_t> now;
    for (const auto& [first, last] : ranges)
      for (size_t i = first; i <= last; ++i) {
        for (const size_t needed : job.tasks[i].needs) EXPECT_TRUE(done.count(needed));
        EXPECT_TRUE(now.insert(i).second);
      }
    done.insert(now.begin(), now.end());
  }
  EXPECT_EQ(done.size(), job.tasks.size());
}

TEST(EngineFiles, SlurmArraysStayBelowItsDefaultLimit) {
  const Job job = plan_job(options(2500, 1));
  const std::string text = slurm_file(job, {}).text;
  for (const char* call : {"submit 0 1000 ", "submit 1000 1000 ", "submit 2000 500 "})
    EXPECT_NE(text.find(call), text.npos) << call;
}

// Limits of the specification, version 2023-09: lengths of names, and the form of ranges.
TEST(EngineFiles, OpenJdTemplatesKeepTheLimits) {
  const Job job = plan_job(options(3, 4));
  const auto text = nlohmann::json::parse(openjd_file(job, {}).text);
  EXPECT_EQ(text.at("specificationVersion"), "jobtemplate-2023-09");
  EXPECT_LE(text.at("name").get<std::string>().size(), 128U);
  EXPECT_LE(text.at("parameterDefinitions").size(), 50U);
  std::set<std::string> steps;
  for (const auto& step : text.at("steps")) {
    const auto name = step.at("name").get<std::string>();
    EXPECT_LE(name.size(), 64U);
    for (const auto& each : step.value("dependencies", nlohmann::json::array()))
      EXPECT_TRUE(steps.count(each.at("dependsOn").get<std::string>()));
    EXPECT_TRUE(steps.insert(name).second);
    const auto& range = step.at("parameterSpace").at("taskParameterDefinitions").at(0).at("range");
    EXPECT_EQ(range.get<std::string>().find_first_not_of("0123456789-,"), std::string::npos);
    const auto& run = step.at("script").at("actions").at("onRun");
    EXPECT_LE(run.at("cancelation").at("notifyPeriodInSeconds").get<int>(), 600);
  }
}

}  // namespace
}  // namespace vug::farm
