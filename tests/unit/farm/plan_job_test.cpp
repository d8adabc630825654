// SPDX-License-Identifier: Apache-2.0
// The tasks of a job and the files for other programs.
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/farm/engine_files.h>
#include <vug/farm/plan_job.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
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

TEST(PlanJob, DefaultChunksLoadForATwentiethOfTheirTime) {
  JobOptions many = options(0, 25);
  many.cost.render_seconds = 250;  // 10 s for each part
  many.cost.start_seconds = 2;
  EXPECT_EQ(default_chunk(many), 4);  // 2 s of 42 s; 3 parts would be 2 s of 32 s
  many.cost.start_seconds = 0.1;
  EXPECT_EQ(default_chunk(many), 1);
  many.cost.start_seconds = 60;
  EXPECT_EQ(default_chunk(many), 25) << "at most the whole picture";
  many.cost.render_seconds = 0;
  EXPECT_EQ(default_chunk(many), 25);
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

TEST(EngineFiles, ChunksContainPartsOfOnePictureOrOneTask) {
  const Job job = plan_job(options(3, 7));
  for (const size_t chunk : {1U, 3U, 7U, 100U}) {
    std::multiset<size_t> covered;
    for (const auto& level : chunked_levels(job, chunk))
      for (const ChunkedRange& range : level)
        for (size_t i = range.first; i <= range.last; i += range.chunk) {
          const size_t last = std::min(range.last, i + range.chunk - 1);
          EXPECT_LE(last - i, chunk - 1);
          EXPECT_TRUE(last == i || job.tasks[i].part_of) << "only parts share a process";
          for (size_t each = i; each <= last; ++each) {
            covered.insert(each);
            EXPECT_EQ(job.tasks[each].part_of, job.tasks[i].part_of);
          }
        }
    EXPECT_EQ(covered.size(), job.tasks.size()) << "each task once";
    EXPECT_EQ(std::set<size_t>(covered.begin(), covered.end()).size(), job.tasks.size());
  }
}

TEST(EngineFiles, ChunksOfSlurmArraysCountChunks) {
  JobOptions many = options(0, 2500);
  many.spp = 5000;
  const std::string text = slurm_file(plan_job(many), {.chunk = 2}).text;
  // 2,500 parts after the task that learns: 1,000 chunks and 250.
  for (const char* call : {"submit 0 0 1 ", "submit 1 2000 2 ", "submit 2001 2500 2 "})
    EXPECT_NE(text.find(call), text.npos) << call << text;
}

TEST(EngineFiles, NinjaRunsChunksThatDoNotNameTheirFiles) {
  const Job job = plan_job(options(0, 5));
  const std::string text = ninja_file(job, {.chunk = 2}).text;
  EXPECT_NE(text.find("build parts/cave.learned: task\n"), text.npos) << text;
  EXPECT_NE(text.find("build chunk.1-2: chunk || parts/cave.learned\n  ids = 1-2\n"), text.npos);
  EXPECT_NE(text.find("build chunk.3-4: chunk || parts/cave.learned\n  ids = 3-4\n"), text.npos);
  EXPECT_NE(text.find("build parts/cave.part04: task || parts/cave.learned\n  id = 5\n"),
            text.npos);
  EXPECT_EQ(text.find("parts/cave.part00"), text.npos);
}

// Of the extension TASK_CHUNKING: the type, and at most 150 tasks in a chunk.
TEST(EngineFiles, OpenJdChunksUseTheExtension) {
  JobOptions many = options(2, 400);
  many.spp = 800;
  const Job job = plan_job(many);
  const auto alone = nlohmann::json::parse(openjd_file(job, {}).text);
  EXPECT_FALSE(alone.contains("extensions"));
  const auto text = nlohmann::json::parse(openjd_file(job, {.chunk = 400}).text);
  EXPECT_EQ(text.at("extensions"), nlohmann::json::array({"TASK_CHUNKING"}));
  for (const auto& step : text.at("steps")) {
    const auto& parameters = step.at("parameterSpace").at("taskParameterDefinitions");
    ASSERT_EQ(parameters.size(), 1U) << "at most one chunked parameter";
    EXPECT_EQ(parameters.at(0).at("type"), "CHUNK[INT]");
    EXPECT_EQ(parameters.at(0).at("chunks").at("defaultTaskCount"), 150);
    EXPECT_EQ(parameters.at(0).at("chunks").at("rangeConstraint"), "CONTIGUOUS");
  }
}

TEST(EngineFiles, SlurmArraysStayBelowItsDefaultLimit) {
  const Job job = plan_job(options(2500, 1));
  const std::string text = slurm_file(job, {}).text;
  for (const char* call : {"submit 0 999 1 ", "submit 1000 1999 1 ", "submit 2000 2499 1 "})
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
