// SPDX-License-Identifier: Apache-2.0
// Files: the content survives a round trip, the bytes are reproducible, and no damage goes
// unnoticed.
#include "solids.h"

#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/volume/fog.h>
#include <vug/volume/io.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

namespace vug::volume {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  static LevelSet solid() {
    VoxelizeOptions options;
    options.voxel = 0.07;
    return voxelize(lumpy_solid(), options);
  }
  static std::vector<Grid> grids() {
    const LevelSet rock = solid();
    return {rock.named("rock"), fog(rock).named("density")};
  }
  fs::path path(const std::string& name) const { return folder_ / name; }

  const ScratchFolder scratch_{"vug_volume"};
  const std::filesystem::path& folder_ = scratch_.path();
};

TEST_F(Files, RoundTripKeepsContentAndMetadata) {
  WriteOptions options;
  options.metadata = {{"vug:recipe", std::string("cave.vug")}, {"vug:seed", int64_t{2012}}};
  write(path("a.vdb"), grids(), options);
  const std::vector<Grid> back = read(path("a.vdb"));
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].name(), "rock");
  EXPECT_EQ(back[0].content(), solid().content());
  EXPECT_EQ(back[1].grid_class(), GridClass::fog);
  EXPECT_EQ(check(LevelSet(back[0])).fault, "");
  const Metadata metadata = back[0].metadata();
  EXPECT_EQ(std::get<std::string>(metadata.at("vug:recipe")), "cave.vug");
  EXPECT_EQ(std::get<int64_t>(metadata.at("vug:seed")), 2012);
  EXPECT_EQ(std::get<double>(metadata.at("vug:metersPerUnit")), 1.0);
  EXPECT_EQ(std::get<std::string>(metadata.at("vug:upAxis")), "y");
  EXPECT_EQ(metadata.count("creator"), 0u);
}

TEST_F(Files, SameBytesForAnyNumberOfThreadsAndEachRun) {
  write(path("a.vdb"), grids());
  const std::string first = read_text(path("a.vdb"));
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      write(path("b.vdb"), grids());
      EXPECT_TRUE(read_text(path("b.vdb")) == first) << threads;
    });
  }
  // A grid that was read with its voxels still on disk gives the same bytes too.
  write(path("c.vdb"), read(path("a.vdb")));
  EXPECT_TRUE(read_text(path("c.vdb")) == first);
  write(path("d.vdb"), {grids()[0]});
  EXPECT_NE(info(path("d.vdb")).identifier, info(path("a.vdb")).identifier);
}

TEST_F(Files, ReadersSeeOneFileWhileItIsReplaced) {
  // Like a checkpoint that is inspected during the run.
  write(path("kept.vdb"), {solid().named("a")});
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (int i = 0; !done; ++i)
      write(path("kept.vdb"), {solid().named(i % 2 == 0 ? "b" : "a")},
            {.half = i % 2 == 0, .metadata = {}});
  });
  for (int i = 0; i < 100; ++i) {
    const FileInfo file = info(path("kept.vdb"));
    EXPECT_EQ(file.grids.at(0).half, file.grids.at(0).name == "b");
    EXPECT_NO_THROW(LevelSet(read_grid(path("kept.vdb"), "")).content());
  }
  done = true;
  writer.join();
}

TEST_F(Files, NothingIsPrintedOnStandardOutput) {
  write(path("a.vdb"), {solid().named("rock")});
  const LevelSet rock(read_grid(path("a.vdb"), "rock"));
  fs::last_write_time(path("a.vdb"), fs::last_write_time(path("a.vdb")) + std::chrono::minutes(1));
  testing::internal::CaptureStdout();
  EXPECT_EQ(rock.content(), solid().content());  // OpenVDB's log reports a newer file.
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(Files, HalfPrecisionPassesTheChecksToo) {
  for (const double voxel : {0.07, 0.1, 0.013}) {
    VoxelizeOptions fine;
    fine.voxel = voxel;
    const LevelSet original = voxelize(lumpy_solid(), fine);
    write(path("full.vdb"), {original.named("rock")});
    write(path("half.vdb"), {original.named("rock")}, {.half = true, .metadata = {}});
    EXPECT_LT(fs::file_size(path("half.vdb")), fs::file_size(path("full.vdb")));
    const LevelSet half(read_grid(path("half.vdb"), "rock"));
    EXPECT_TRUE(half.saved_as_half());
    EXPECT_EQ(check(half).fault, "");
    double worst = 0;
    each_lattice_point(original, [&](const Vec3d& p, double value) {
      if (std::fabs(value) < original.background())
        worst = std::max(worst, std::fabs(half.value(p) - value));
    });
    EXPECT_LE(worst, original.background() / 2048);  // 11 bits of mantissa.
    EXPECT_EQ(original.content(), voxelize(lumpy_solid(), fine).content());
  }
}

TEST_F(Files, EachGridHasItsOwnPrecision) {
  const LevelSet original = voxelize(lumpy_solid(), {});
  write(path("a.vdb"), {original.named("fine"), original.named("coarse").stored_as_half(true)});
  const LevelSet fine(read_grid(path("a.vdb"), "fine")), coarse(read_grid(path("a.vdb"), "coarse"));
  EXPECT_FALSE(fine.saved_as_half());
  EXPECT_TRUE(coarse.saved_as_half());
  EXPECT_EQ(fine.content(), original.content());
  EXPECT_NE(coarse.content(), original.content());
  EXPECT_EQ(check(coarse).fault, "");
  // Grids keep their storage precision when read, and it can be changed.
  write(path("b.vdb"), {coarse, fine.stored_as_half(true)});
  EXPECT_TRUE(read_grid(path("b.vdb"), "coarse").saved_as_half());
  EXPECT_TRUE(read_grid(path("b.vdb"), "fine").saved_as_half());
}

TEST_F(Files, EmptyGridsCanBeWritten) {
  write(path("a.vdb"), {voxelize(field::empty(), {}).named("air")});
  EXPECT_TRUE(LevelSet(read_grid(path("a.vdb"), "air")).empty());
}

TEST_F(Files, InfoDescribesTheContent) {
  write(path("a.vdb"), grids());
  const FileInfo file = info(path("a.vdb"));
  EXPECT_EQ(file.bytes, fs::file_size(path("a.vdb")));
  EXPECT_EQ(file.identifier.size(), 36u);
  ASSERT_EQ(file.grids.size(), 2u);
  EXPECT_EQ(file.grids[0].name, "rock");
  EXPECT_EQ(file.grids[0].statistics.active_voxels, solid().statistics().active_voxels);
  EXPECT_EQ(file.grids[0].voxel_size, Vec3d(0.07));
  EXPECT_EQ(file.metadata.count("vug:version"), 1u);
}

TEST_F(Files, GridsAreFoundByName) {
  write(path("a.vdb"), {grids()[1], grids()[0]});
  EXPECT_EQ(read_grid(path("a.vdb"), "").name(), "rock");  // The first level set.
  EXPECT_EQ(read_grid(path("a.vdb"), "density").name(), "density");
  try {
    read_grid(path("a.vdb"), "rok");
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(e.hint().find("rock"), std::string::npos);
  }
}

TEST_F(Files, NamesMustExistAndBeUnique) {
  EXPECT_THROW(write(path("a.vdb"), {solid()}), Error);
  EXPECT_THROW(write(path("a.vdb"), {solid().named("a"), solid().named("a")}), Error);
  EXPECT_FALSE(fs::exists(path("a.vdb")));
  EXPECT_TRUE(fs::is_empty(folder_));
}

void put(const fs::path& file, std::string_view bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void expect_refused(const fs::path& file, const std::string& what) {
  for (const bool verify : {true, false}) try {
      read(file, {.delayed = false, .verify = verify});
      if (verify) FAIL() << what;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::bad_input) << what;
      EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos) << what;
    }
}

TEST_F(Files, EveryTruncationIsRefused) {
  write(path("whole.vdb"), grids());
  const std::string whole = read_text(path("whole.vdb"));
  std::vector<size_t> lengths;
  for (size_t n = 0; n < 400; ++n) lengths.push_back(n);
  RandomStream random(RandomKey(9));
  for (int i = 0; i < 100; ++i)
    lengths.push_back(random.below(static_cast<uint32_t>(whole.size())));
  lengths.push_back(whole.size() - 1);
  for (const size_t n : lengths) {
    put(path("cut.vdb"), std::string_view(whole).substr(0, n));
    EXPECT_THROW(read(path("cut.vdb"), {.delayed = true, .verify = false}), Error) << n;
    expect_refused(path("cut.vdb"), std::to_string(n));
    EXPECT_THROW(info(path("cut.vdb")), Error);
  }
}

TEST_F(Files, EveryChangedByteIsDetected) {
  write(path("whole.vdb"), grids());
  const std::string whole = read_text(path("whole.vdb"));
  RandomStream random(RandomKey(10));
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    const size_t at =
        i < 150 ? static_cast<size_t>(i) : random.below(static_cast<uint32_t>(whole.size()));
    if (at >= 21 && at < 57) continue;  // The hash itself, which may then look random.
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.below(8)));
    put(path("damaged.vdb"), damaged);
    EXPECT_THROW(read(path("damaged.vdb")), Error) << at;
  }
}

TEST_F(Files, GarbageIsRefused) {
  RandomStream random(RandomKey(11));
  for (int i = 0; i < 50; ++i) {
    std::string garbage(random.below(5000), '\0');
    for (char& c : garbage) c = static_cast<char>(random.bits());
    if (i % 2 && garbage.size() > 60)
      garbage.replace(0, 8, std::string("\x20\x42\x44\x56\0\0\0\0", 8));
    if (i % 4 == 3 && garbage.size() > 60) garbage.replace(8, 4, std::string("\xe0\0\0\0", 4));
    put(path("garbage.vdb"), garbage);
    expect_refused(path("garbage.vdb"), std::to_string(i));
  }
  expect_refused(path("missing.vdb"), "missing");
  expect_refused(folder_, "a folder");
}

TEST_F(Files, AFailedWritePreservesTheOldFile) {
  write(path("a.vdb"), grids());
  const std::string before = read_text(path("a.vdb"));
  VoxelizeOptions tiny;
  tiny.voxel = 1.6e-5;
  const LevelSet small = voxelize(field::make("sphere", {{"radius", 1e-4}}), tiny);
  EXPECT_THROW(write(path("a.vdb"), {small.named("a")}, {.half = true, .metadata = {}}), Error);
  EXPECT_TRUE(read_text(path("a.vdb")) == before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace vug::volume
