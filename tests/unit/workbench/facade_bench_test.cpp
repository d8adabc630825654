// SPDX-License-Identifier: Apache-2.0
// Documents of the facade bench: undo, drags, scale, files, score and fit.
#include "bench.h"

#include <vug/base/atomic_file.h>
#include <vug/facade/tree_output.h>
#include <vug/session/facade_model.h>
#include <vug/workbench/export_facade.h>

#include <filesystem>

namespace vug::workbench {
namespace {

namespace fs = std::filesystem;

std::string new_paris() { return "photo " + paris_photo() + " 15m"; }

TEST(FacadeBench, FortyUndosAndRedosGiveTheSameBytes) {
  FacadeBench bench;
  run(bench, {new_paris(), "apply 0 rows heights=3.6", "act 0.1 RegularGrid columns=4 rows=3"});
  for (int i = 0; i < 40; ++i) run(bench, {"set 0.1.0 columns=" + std::to_string(2 + i % 5)});
  std::vector<std::string> texts = {text_of(bench)};
  const auto tree = [&] { return facade::tree_json(bench.state().tree()); };
  std::vector<std::string> trees = {tree()};
  for (int i = 0; i < 40; ++i) run(bench, {"undo"}), trees.push_back(tree());
  const std::string undone = text_of(bench);
  EXPECT_NE(undone, texts[0]);
  EXPECT_NE(undone.find("\"done\": 2"), std::string::npos) << "undone edits are saved";
  for (int i = 40; i-- > 0;) {
    run(bench, {"redo"});
    EXPECT_EQ(tree(), trees[static_cast<size_t>(i)]);
  }
  EXPECT_EQ(text_of(bench), texts[0]);
}

TEST(FacadeBench, OpensAndSavesASessionByteForByte) {
  const ScratchFolder folder("vug_bench");
  FacadeBench bench;
  bench.open(paris_session());
  EXPECT_EQ(text_of(bench), read_text(paris_session()));
  EXPECT_TRUE(bench.stack().is_clean());
  EXPECT_EQ(bench.document().checkpoints().at("ground floor"), 5u);
  run(bench, {"undo 2", "checkpoint few"});
  bench.save(folder.file("copy.json"));
  FacadeBench again;
  again.open(folder.file("copy.json"));
  EXPECT_TRUE(fs::exists(again.photo())) << "the path of the photo follows the file";
  EXPECT_EQ(facade::tree_json(again.state().tree()), facade::tree_json(bench.state().tree()));
}

TEST(FacadeBench, RestoresCheckpointsAsAStep) {
  FacadeBench bench;
  bench.open(paris_session());
  run(bench, {"restore \"ground floor\""});
  EXPECT_EQ(bench.document().edit_count(), 5u);
  run(bench, {"undo"});
  EXPECT_EQ(bench.document().edit_count(), 9u);
}

TEST(FacadeBench, PreviewsChangeNothing) {
  FacadeBench bench;
  bench.open(paris_session());
  const std::string before = text_of(bench);
  modeller::Edit move{"move", "0.1.1.0", "", {{"line", {1}}, {"to", {3.1}}}};
  EXPECT_TRUE(bench.preview(move));
  EXPECT_NE(facade::tree_json(bench.state().tree()),
            facade::tree_json(bench.document().state().tree()));
  move.numbers["to"] = {300};
  EXPECT_FALSE(bench.preview(move));
  bench.end_preview();
  EXPECT_EQ(text_of(bench), before);
}

TEST(FacadeBench, NudgesOfOneHandleAreOneStep) {
  FacadeBench bench;
  run(bench, {new_paris(), "act 0 RegularGrid columns=3 rows=2", "cycle"});
  ASSERT_TRUE(bench.handle());
  const double at = bench.handle()->at;
  const size_t steps = bench.stack().done();
  run(bench, {"nudge 10cm", "nudge 10cm", "nudge 10cm"});
  EXPECT_EQ(bench.stack().done(), steps + 1);
  EXPECT_NEAR(bench.handle()->at, at + 0.3, 1e-9);
  run(bench, {"cycle", "nudge 10cm"});
  EXPECT_EQ(bench.stack().done(), steps + 2);
}

TEST(FacadeBench, ScaleKeepsEverythingOnThePhoto) {
  FacadeBench bench;
  bench.open(paris_session());
  const auto shares = [&] {
    std::vector<double> out;
    for (const Shape& each : shapes(bench.state()))
      for (const double x : {each.rect.x, each.rect.right()})
        out.push_back(x / bench.state().canvas().width);
    return out;
  };
  const std::vector<double> before = shares();
  run(bench, {"scale 0 0 3 4 10m"});
  EXPECT_NEAR(bench.state().canvas().width, 30, 1e-9);
  const std::vector<double> after = shares();
  ASSERT_EQ(after.size(), before.size());
  for (size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9);
  run(bench, {"undo"});
  EXPECT_EQ(text_of(bench), read_text(paris_session()));
  EXPECT_NE(refusal(bench, "scale 1 1 1 1 2m"), "");
}

TEST(FacadeBench, SelectionSurvivesEditsAndFallsBackToAncestors) {
  FacadeBench bench;
  run(bench,
      {new_paris(), "apply 0 rows heights=3.6", "select 0.1", "act 0.1 Grid", "select 0.1.0.0"});
  run(bench, {"undo"});
  EXPECT_EQ(bench.state().path(bench.selected()), "0.1");
  run(bench, {"select previous"});
  EXPECT_EQ(bench.state().path(bench.selected()), "0.0");
  run(bench, {"select parent", "select open"});
  EXPECT_EQ(bench.state().path(bench.selected()), "0.0");
  run(bench, {"select open"});
  EXPECT_EQ(bench.state().path(bench.selected()), "0.1");
}

TEST(FacadeBench, ScoresEachStateAndComparesSessions) {
  FacadeBench bench;
  run(bench, {new_paris()});
  ASSERT_TRUE(wait(bench));
  ASSERT_TRUE(bench.score()) << bench.score_reason();
  const fit::FacadeScore wall = *bench.score();
  bench.open(paris_session());
  ASSERT_TRUE(wait(bench));
  const fit::FacadeScore model = *bench.score();
  EXPECT_GT(model.complexity, wall.complexity);
  EXPECT_LT(model.differing, wall.differing);
  EXPECT_GT(model.score, wall.score) << "windows explain more than they cost";
  bench.compare(paris_session());
  EXPECT_DOUBLE_EQ(bench.scorer()->score(bench.comparisons()[0].state.tree()).score, model.score);
  run(bench, {"separate 0.1"});
  EXPECT_FALSE(bench.score());
  EXPECT_NE(bench.score_reason(), "");
}

TEST(FacadeBench, TheResultOfAFitIsOneStepThatCanBeContinued) {
  FacadeBench bench;
  std::vector<std::string> lines;
  run(bench, {new_paris(), "act 0 Grid"});
  bench.journal = [&](const std::string& line) { lines.push_back(line); };
  run(bench, {"fit 2000"});
  EXPECT_NE(refusal(bench, "fit"), "") << "one fit at a time";
  ASSERT_TRUE(wait(bench));
  bench.poll();
  EXPECT_EQ(bench.stack().undo_name(), "Fit");
  EXPECT_GT(facade::element_instances(bench.state().tree()).size(), 10u);
  EXPECT_NE(bench.fit_note().find("the rules approximate the tree"), std::string::npos);
  ASSERT_EQ(lines.size(), 1u);
  FacadeBench replayed;
  run(replayed, {new_paris(), "act 0 Grid", lines[0]});
  EXPECT_EQ(text_of(replayed), text_of(bench));
  run(bench, {"undo"});
  EXPECT_EQ(bench.document().edit_count(), 1u);
}

TEST(FacadeBench, ExportsAllKindsOfFiles) {
  const ScratchFolder folder("vug_bench");
  FacadeBench bench;
  bench.open(paris_session());
  for (const ExportKind& each : export_kinds()) {
    const fs::path file = folder.file(each.name + each.extension);
    export_facade(bench, each.name, file);
    EXPECT_GT(fs::file_size(file), 100u) << each.name;
  }
  EXPECT_EQ(read_text(folder.file("json.json")), facade::tree_json(bench.state().tree()));
  EXPECT_THROW(export_facade(bench, "svg", folder.file("a.png")), Error);
  EXPECT_THROW(export_facade(bench, "gif", folder.file("a.gif")), Error);
  EXPECT_THROW(export_facade(bench, "session", paris_session()), Error) << "its own input";
}

}  // namespace
}  // namespace vug::workbench
