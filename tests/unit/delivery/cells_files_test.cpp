// SPDX-License-Identifier: Apache-2.0
// Files of cells, and continued runs: from a checkpoint, from a frame, from points.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/building/cell_points.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/delivery/cells_files.h>
#include <vug/loading/load.h>
#include <vug/shot/queries.h>
#include <vug/volume/io.h>

#include <fstream>

namespace vug::delivery {
namespace {

namespace fs = std::filesystem;

const std::string kBall =
    "volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock {}\n";
const std::string kLong =
    "cells crust on wall { spacing 15cm  run random_color(share: 10%), voronoi, gray_scott, "
    "sprinkle(attribute: \"v\", share: 10%), corrosion(begin: 200, loss: 0.5%)  steps 1000 }\n";
const std::string kNext =
    "cells film on wall { spacing 20cm  run sprinkle(attribute: \"alive\", whole: true), maze "
    " steps 50 }\n";

class CellFiles : public testing::Test {
 protected:
  static loading::Loaded loaded(const std::string& cells, double frame = 1,
                                loading::StaticCache* still = nullptr,
                                const std::string& file = "crust.vug") {
    loading::LoadOptions options;
    options.frame = frame;
    options.static_cache = still;
    loading::Loaded out = loading::load_text(kBall + cells, file, options);
    EXPECT_TRUE(out.usable()) << out.report();
    return out;
  }
  static Digest made(building::Builder& builder, size_t number = 0) {
    const shot::CellsPtr plan = shot::declared_cells(builder.shot()).at(number);
    return building::cell_points(*plan, *builder.cell_layer(plan), cells::PointFormat::exact)
        .content();
  }
  building::CheckpointOptions checkpoint(bool resume) const {
    building::CheckpointOptions out;
    out.file = folder_ / "kept.vdb";
    out.resume = resume;
    return out;
  }

  const ScratchFolder scratch_{"vug_cell_files"};
  const std::filesystem::path& folder_ = scratch_.path();
};

TEST_F(CellFiles, AStoppedRunContinuesToTheSameBytes) {
  const loading::Loaded scene = loaded(kNext + kLong);
  building::Builder whole(scene.shot);
  // Stopped twice; at the end the file contains both runs, and the film's run is requested last.
  for (const int stop : {300, 965}) {
    Progress stopping([&](const std::string& stage, double fraction) {
      const int steps = stop == 300 ? 1000 : 700;  // of this run
      if (stage.starts_with(fmt::format("rewriting cells, {} steps", steps)) &&
          fraction * steps > stop - (1000 - steps) - 0.5)
        stopping.cancel();
    });
    building::BuildOptions options;
    options.checkpoint =
        std::make_shared<building::CellsCheckpoint>(checkpoint(stop > 300), scene.shot);
    building::Builder builder(scene.shot, options, stopping);
    made(builder, 0);
    try {
      made(builder, 1);
      FAIL() << "the run was not stopped";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::cancelled);
      EXPECT_EQ(
          error.hint(),
          fmt::format("'{}' contains the work so far, {} of 1000 steps of 'crust'; the same "
                      "command{} continues from it",
                      checkpoint(false).file.string(), stop, stop == 300 ? " with --resume" : ""));
    }
  }
  EXPECT_THROW(building::CellsCheckpoint(checkpoint(false), scene.shot), Error);
  const volume::FileInfo kept = volume::info(checkpoint(true).file);
  ASSERT_EQ(kept.grids.size(), 2u);
  EXPECT_EQ(std::get<int64_t>(kept.grids[1].metadata.at("vug:step")), 965);
  building::BuildOptions options;
  building::CheckpointOptions often = checkpoint(true);
  often.every = 0;
  options.checkpoint = std::make_shared<building::CellsCheckpoint>(often, scene.shot);
  building::Builder resumed(scene.shot, options);
  EXPECT_EQ(made(resumed, 1), made(whole, 1));
  EXPECT_EQ(volume::info(often.file).grids.size(), 2u) << "the other run is kept";
  EXPECT_EQ(made(resumed, 0), made(whole, 0));
  options.checkpoint->remove();
  EXPECT_FALSE(fs::exists(often.file));
}

TEST_F(CellFiles, ACheckpointOfAnotherSceneIsRejected) {
  const loading::Loaded scene = loaded(kNext);
  building::CheckpointOptions often = checkpoint(false);
  often.every = 0;
  building::BuildOptions options;
  options.checkpoint = std::make_shared<building::CellsCheckpoint>(often, scene.shot);
  building::Builder builder(scene.shot, options);
  made(builder);
  EXPECT_NO_THROW(building::CellsCheckpoint(checkpoint(true), scene.shot));
  const loading::Loaded other = loaded(kNext + "# other\n");
  try {
    building::CellsCheckpoint(checkpoint(true), other.shot);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("belongs to another scene"), std::string::npos);
    EXPECT_EQ(error.hint(), "remove it to start again");
  }
}

TEST_F(CellFiles, ARunContinuesFromFrameToFrame) {
  const auto steps = [](const std::string& count) {
    return "cells crust on wall { spacing 15cm  run random_color(share: 10%), gray_scott, "
           "sprinkle(attribute: \"v\", share: 10%)  steps " +
           count + " }\n";
  };
  loading::StaticCache still;
  const loading::Loaded first = loaded(steps("10 * frame"), 3, &still);
  building::Builder before(first.shot);
  made(before);
  const loading::Loaded second = loaded(steps("10 * frame"), 4, &still);
  int steps_done = 0;
  Progress counting([&](const std::string& stage, double) {
    if (stage.rfind("rewriting cells", 0) == 0) ++steps_done;
  });
  building::Builder after(second.shot, {}, counting);
  after.reuse_from(std::move(before));
  const Digest went_on = made(after);
  EXPECT_LE(steps_done, 12) << "ten steps, and not forty";
  EXPECT_GE(steps_done, 10);
  const loading::Loaded alone = loaded(steps("10 * frame"), 4);
  building::Builder whole(alone.shot);
  EXPECT_EQ(went_on, made(whole));
  // It restarts for earlier frames and for rules that depend on the frame.
  const loading::Loaded back = loaded(steps("10 * frame"), 2, &still);
  building::Builder again(back.shot);
  again.reuse_from(std::move(after));
  EXPECT_EQ(again.cell_layer(shot::declared_cells(back.shot)[0])->simulation.step(), 20);
  const std::string moving = "cells crust on wall { spacing 15cm + 1mm * frame  run gray_scott }\n";
  EXPECT_FALSE(shot::declared_cells(loaded(moving, 3).shot)[0]->resumable);
}

TEST_F(CellFiles, ARunContinuesFromPointsOfAFile) {
  const loading::Loaded scene = loaded(kLong);
  building::Builder whole(scene.shot);
  const std::string half = std::string(kLong).replace(kLong.find("1000 }"), 4, " 400");
  const loading::Loaded begun = loaded(half);
  building::Builder first(begun.shot);
  const shot::CellsPtr plan = shot::declared_cells(begun.shot)[0];
  for (const auto keep : {cells::PointFormat::exact, cells::PointFormat::interchange}) {
    const fs::path file = folder_ / "begun.vdb";
    volume::write(file, {building::cell_points(*plan, *first.cell_layer(plan), keep)});
    const std::string more =
        std::string(kLong).replace(kLong.find("steps 1000"), 0, "from \"begun.vdb\"  ");
    const loading::Loaded scene_on = loaded(more, 1, nullptr, (folder_ / "crust.vug").string());
    building::Builder second(scene_on.shot);
    const building::CellLayerPtr on = second.cell_layer(shot::declared_cells(scene_on.shot)[0]);
    EXPECT_EQ(on->simulation.step(), 1000);
    if (keep == cells::PointFormat::exact)
      EXPECT_EQ(made(second), made(whole));
    else  // only colours had 16 bits
      EXPECT_EQ(on->simulation.attributes().values<float>("v"),
                whole.cell_layer(shot::declared_cells(scene.shot)[0])
                    ->simulation.attributes()
                    .values<float>("v"));
  }
  const std::string other =
      "cells crust on wall { spacing 20cm  from \"begun.vdb\"  run gray_scott }\n";
  const loading::Loaded scene_off = loaded(other, 1, nullptr, (folder_ / "crust.vug").string());
  building::Builder off(scene_off.shot);
  try {
    made(off);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("cannot continue from '", 0), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find(" points, but "), std::string::npos);
    EXPECT_EQ(error.where().line, 3);
  }
}

TEST_F(CellFiles, TheTableHasALineForEachCell) {
  const loading::Loaded scene = loaded(kLong);
  building::Builder builder(scene.shot);
  const building::CellLayerPtr layer = builder.cell_layer(shot::declared_cells(scene.shot)[0]);
  write_table(folder_ / "crust.csv", *layer);
  std::ifstream in(folder_ / "crust.csv");
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line.rfind("id,x,y,z,N_x,N_y,N_z,pscale,Cd_x,Cd_y,Cd_z,seed,u,v,", 0), 0u) << line;
  EXPECT_EQ(line.substr(line.size() - 6), ",state");
  const auto commas = std::count(line.begin(), line.end(), ',');
  size_t lines = 0;
  while (std::getline(in, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas);
    const float x = std::stof(line.substr(line.find(',') + 1));
    EXPECT_EQ(x, layer->network().position[lines].x);
    ++lines;
  }
  EXPECT_EQ(lines, layer->network().size());
}

TEST_F(CellFiles, GridsHoldTheAttributesOfCellsInTheBand) {
  const loading::Loaded scene = loaded(kLong);
  building::Builder builder(scene.shot);
  const std::vector<volume::Grid> grids = cell_grids(builder, shot::declared_cells(scene.shot)[0]);
  std::string names;
  for (const volume::Grid& grid : grids) {
    names += grid.name() + ' ' + grid.value_type() + '\n';
    EXPECT_EQ(grid.statistics().active_voxels,
              builder.level_set(scene.shot.volumes[0]).statistics().active_voxels);
  }
  EXPECT_EQ(names,
            "crust_Cd vec3s\ncrust_seed float\ncrust_u float\ncrust_v float\n"
            "crust_potential float\ncrust_transparent float\n");
}

TEST_F(CellFiles, UnknownFilesAreRejected) {
  const loading::Loaded scene = loading::load_text(
      kBall + "cells crust on wall { spacing 20cm  run maze  files [\"obj\"] }\n", "a.vug");
  EXPECT_FALSE(scene.usable());
  EXPECT_NE(scene.report().find("unknown file of cells 'obj'"), std::string::npos)
      << scene.report();
}

}  // namespace
}  // namespace vug::delivery
