// SPDX-License-Identifier: Apache-2.0
// The scene bench: one undo stack for all changes, parameters in the text, picks, the journal.
#include <vug/base/atomic_file.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/workbench/recovery.h>
#include <vug/workbench/scene_query.h>

#include <gtest/gtest.h>

#include <set>

namespace vug::workbench {
namespace {

const std::string kText =
    "# A ball.\n"
    "param RADIUS = 50cm   in 10cm..90cm  \"radius\"  # not too large\n"
    "volume ball = level_set(sphere(RADIUS), voxel: 5cm)\n"
    "mesh ball on ball { }\n"
    "object ball on ball { }\n"
    "camera main { eye (0, 0, 4)  # far\n"
    "  target (0, 0, 0) }\n";

class SceneBenches : public testing::Test {
 protected:
  void SetUp() override {
    write_text(file_, kText);
    bench_.open(file_);
    bench_.viewport().set_size(64, 36);
  }
  void run(const std::string& line) { run_command(bench_, line); }
  void build() {
    bench_.build();
    bench_.viewport().wait();
  }
  std::string refusal(const std::string& line) {
    try {
      run(line);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  std::string edit_line(const std::string& before, const std::string& after) const {
    const size_t at = bench_.text().find(before);
    return "edit " + std::to_string(at) + " " + std::to_string(before.size()) + " " + quoted(after);
  }

  ScratchFolder folder_{"vug_scene_bench"};
  std::filesystem::path file_ = folder_.file("scene.vug");
  SceneBench bench_;
};

TEST_F(SceneBenches, ARegionEndsByItsCommandOrByStop) {
  const auto is_whole = [&] { return !bench_.viewport().request().region; };
  run("region 0.2 0.3 0.6 0.5");
  expect(bench_, {"region", "=", "0.20 0.30 0.60 0.50"});
  run("stop");
  EXPECT_TRUE(is_whole());
  EXPECT_FALSE(bench_.status().stopped) << "the whole picture follows";
  run("region 0.2 0.3 0.6 0.5");
  run("region");
  EXPECT_TRUE(is_whole());
  EXPECT_NE(refusal("region 0.2 0.3 0.6").find("two corners"), std::string::npos);
  EXPECT_NE(refusal("region 0.2 0.3 0.6 1.5").find("outside of the picture"), std::string::npos);
  EXPECT_TRUE(is_whole());
}

TEST_F(SceneBenches, TheTextOfAKeptPictureReturnsAsOneStep) {
  build();
  run("keep_picture");
  run("param RADIUS 70cm");
  build();
  run("keep_picture");
  expect(bench_, {"kept_pictures", "=", "1 2"});
  run("reference_picture 1");
  expect(bench_, {"comparison", "=", "0 wipe 1"});
  expect(bench_, {"difference", "above", "0"});
  run("reference_picture 2");
  expect(bench_, {"difference", "=", "0"});
  std::vector<std::string> journal;
  bench_.journal = [&](const std::string& line) { journal.push_back(line); };
  const std::string changed = bench_.text();
  run("restore_text 1");
  EXPECT_EQ(bench_.text(), kText);
  EXPECT_EQ(bench_.stack().undo_name(), "Restore picture 1");
  ASSERT_EQ(journal.size(), 1u) << "a change that a journal can repeat without pictures";
  EXPECT_EQ(journal[0].substr(0, 5), "edit ");
  run("undo");
  EXPECT_EQ(bench_.text(), changed);
  EXPECT_NE(refusal("restore_text 3"), "");
  run("compare difference");
  run("compare");
  expect(bench_, {"comparison", "=", "0 off 2"});
  run("open " + quoted(file_.string()));
  EXPECT_TRUE(bench_.history().all().empty()) << "pictures belong to a document";
}

TEST_F(SceneBenches, TheQueueRendersTheSavedFile) {
  EXPECT_NE(refusal("queue_render a.exr"), "") << "without a queue";
  RenderQueue queue(folder_.path());
  bench_.queue = &queue;
  run("queue_render cave.exr main RADIUS=40cm");
  const QueuedRender& render = queue.find(1);
  EXPECT_EQ(render.scene, std::filesystem::absolute(file_));
  EXPECT_EQ(render.output, std::filesystem::absolute("cave.exr"));
  EXPECT_EQ(render.render, "main");
  EXPECT_EQ(render.parameters, std::vector<std::string>{"RADIUS=40cm"});
  run("pause_render 1");
  expect(bench_, {"renders", "=", "1 paused"});
  run("resume_render 1");
  run("cancel_render 1");
  EXPECT_TRUE(queue.all().empty());
  EXPECT_NE(refusal("queue_render cave.png").find("written to an .exr"), std::string::npos);
  EXPECT_NE(refusal("queue_render cave.exr main RADIUS").find("does not set a parameter"),
            std::string::npos);
  run("param RADIUS 70cm");
  EXPECT_NE(refusal("queue_render cave.exr").find("not saved"), std::string::npos);
}

TEST_F(SceneBenches, SlidersWriteIntoTheTextAndUndoRestoresItsBytes) {
  ASSERT_EQ(bench_.params().size(), 1u);
  run("param RADIUS 62cm drag");
  run("param RADIUS 70cm drag");
  std::string expected = kText;
  expected.replace(expected.find("50cm"), 4, "70cm");
  EXPECT_EQ(bench_.text(), expected);
  EXPECT_EQ(bench_.stack().undo_name(), "Set RADIUS");
  run("undo");
  EXPECT_EQ(bench_.text(), kText) << "a drag is one step";
  EXPECT_FALSE(bench_.is_modified());
  run("redo");
  EXPECT_EQ(bench_.text(), expected);
  EXPECT_NE(refusal("param RADIU 3cm"), "");
}

TEST_F(SceneBenches, OneStackHoldsTypingAndSliders) {
  run("edit 0 0 x Typing typing");
  run("edit 1 0 y Typing typing");
  run("param RADIUS 60cm drag");
  run("end_step");
  run("param RADIUS 61cm drag");
  run("edit 2 0 z Typing typing");
  run("edit 0 1 \"\" Typing typing");
  std::vector<std::string> texts = {bench_.text()};
  while (bench_.stack().can_undo()) {
    run("undo");
    texts.push_back(bench_.text());
  }
  ASSERT_EQ(texts.size(), 6u) << "adjacent typing is one step, another place is another one";
  EXPECT_EQ(texts.back(), kText);
  EXPECT_EQ(texts[4], "xy" + kText);
  for (size_t i = texts.size() - 1; i-- > 0;) {
    run("redo");
    EXPECT_EQ(bench_.text(), texts[i]);
  }
  EXPECT_EQ(refusal("redo"), "'redo' is not available: there is nothing to redo");
}

TEST_F(SceneBenches, ATextWithErrorsKeepsThePicture) {
  build();
  const viewport::PreviewPtr good = bench_.status().picture;
  ASSERT_TRUE(good) << bench_.status().report;
  EXPECT_NO_THROW(expect(bench_, {"stale", "=", "no"}));
  run(edit_line("sphere(RADIUS)", "spher(RADIUS)"));
  EXPECT_TRUE(bench_.needs_build());
  build();
  EXPECT_EQ(bench_.status().picture, good);
  EXPECT_NO_THROW(expect(bench_, {"stale", "=", "yes"}));
  EXPECT_NO_THROW(expect(bench_, {"problem", "contains", "3:25: "}));
  run("undo");
  build();
  EXPECT_NO_THROW(expect(bench_, {"problems", "=", "0"}));
  EXPECT_FALSE(bench_.stale());
}

TEST_F(SceneBenches, APickSelectsTheDeclarationsInTurn) {
  build();
  run("pick 0.5 0.5");
  EXPECT_NO_THROW(expect(bench_, {"picked", "=", "ball"}));
  std::vector<int> lines;
  for (int i = 0; i < 4; ++i) {
    EXPECT_NO_THROW(expect(bench_, {"selected", "=", "ball"}));
    lines.push_back(bench_.selection().line);
    run("pick 0.5 0.5");
  }
  EXPECT_EQ(lines, (std::vector<int>{5, 4, 3, 5}));
  run("pick 0.01 0.01");
  EXPECT_NO_THROW(expect(bench_, {"picked", "=", ""}));
}

TEST_F(SceneBenches, TheViewIsWrittenIntoTheCamera) {
  build();
  run("orbit 90");
  bench_.viewport().wait();
  run("write_view");
  EXPECT_NE(bench_.text().find("# far"), std::string::npos) << bench_.text();
  build();
  const viewport::View view = bench_.viewport().view();
  run("home");
  bench_.viewport().wait();
  EXPECT_LT((bench_.viewport().view().eye - view.eye).length(), 1e-3) << bench_.text();
  EXPECT_EQ(bench_.stack().undo_name(), "Write view");
  run("undo");
  EXPECT_EQ(bench_.text(), kText);
}

TEST_F(SceneBenches, SavingKeepsTheLineEndsOfTheFile) {
  write_text(file_, "# a\r\n# b\r\n");
  bench_.open(file_);
  EXPECT_EQ(bench_.text(), "# a\n# b\n");
  run("edit 3 0 c");
  EXPECT_TRUE(bench_.is_modified());
  run("save");
  EXPECT_FALSE(bench_.is_modified());
  EXPECT_EQ(read_text(file_), "# ac\r\n# b\r\n");
}

TEST_F(SceneBenches, RefuseWithAReason) {
  SceneBench empty;
  try {
    run_command(empty, "undo");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "'undo' is not available: no scene is open");
  }
  EXPECT_EQ(refusal("mode wire"), "unknown mode 'wire' of the viewport");
  EXPECT_NE(refusal("edit 5000 0 x"), "");
  EXPECT_NE(refusal("edit 0 1.5 x"), "");
  EXPECT_NE(refusal("dolly 0"), "");
  EXPECT_NE(refusal("open " + folder_.file("missing.vug").string()), "");
  EXPECT_EQ(bench_.text(), kText);
}

TEST_F(SceneBenches, ADraggedHandleChangesOnlyItsNumbers) {
  const std::string lamp = "light lamp = sphere(center: (-1.0m, 50cm, 0),  radius: 4cm)  # left\n";
  run("edit " + std::to_string(kText.size()) + " 0 " + quoted(lamp));
  build();
  run("end_step");
  run("go 8 3");
  EXPECT_NO_THROW(expect(bench_, {"handles", "=", "center radius"}));
  EXPECT_NO_THROW(expect(bench_, {"gizmos", "=", "lamp*"}));
  const Vec2d before = bench_.overlay().handles.at(0).at;
  std::vector<std::string> lines;
  bench_.journal = [&](const std::string& line) { lines.push_back(line); };
  run("drag_handle center 2 -1 - \"drag 1\"");
  run("drag_handle center 7 -3 - \"drag 1\"");
  run("end_step");
  EXPECT_LT((bench_.overlay().handles.at(0).at - before - Vec2d(7, -3)).length(), 1)
      << "offsets count from the beginning of the drag";
  const std::string after = bench_.text();
  EXPECT_EQ(after.substr(0, kText.size()), kText);
  EXPECT_NE(after.find("),  radius: 4cm)  # left\n"), std::string::npos) << after;
  EXPECT_NE(after.find("sphere(center: (-0."), std::string::npos) << after;
  EXPECT_NE(after.find("cm, "), std::string::npos) << "the unit of the second number stays";
  EXPECT_EQ(bench_.stack().undo_name(), "Drag center");
  // The journal contains edits, which need no picture.
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].substr(0, 5), "edit ");
  run("undo");
  EXPECT_EQ(bench_.text(), kText + lamp) << "a drag is one step";
  run("drag_handle center 0 -4 y");
  EXPECT_NE(bench_.text().find("(-1.0m, "), std::string::npos) << bench_.text();
  EXPECT_NE(bench_.text().find("cm, 0),"), std::string::npos) << bench_.text();
  EXPECT_NE(refusal("drag_handle center 1 1 up"), "");
  EXPECT_NE(refusal("drag_handle centre 1 1"), "");
  run("go 3");
  EXPECT_NO_THROW(expect(bench_, {"no_handle", "radius", "=", "it is an expression"}));
  EXPECT_EQ(refusal("drag_handle radius 1 1"), "'radius' has no handle: it is an expression");
}

TEST_F(SceneBenches, ADraggedLampBuildsNothing) {
  run("edit " + std::to_string(kText.size()) + " 0 \"light lamp = sphere(center: (-1, 1, 0))\n\"");
  run("mode path");
  build();
  const viewport::ViewportStatus before = bench_.status();
  run("go 8");
  run("drag_handle center 3 2");
  build();
  const viewport::ViewportStatus after = bench_.status();
  EXPECT_EQ(after.counters.scenes, before.counters.scenes + 1);
  EXPECT_EQ(after.counters.products, before.counters.products);
  EXPECT_EQ(after.counters.trees, before.counters.trees);
  EXPECT_NE(after.picture->rgb, before.picture->rgb);
}

TEST_F(SceneBenches, ChangedParamsCanBeReset) {
  EXPECT_NO_THROW(expect(bench_, {"changed", "=", ""}));
  run("param RADIUS 70cm");
  EXPECT_NO_THROW(expect(bench_, {"changed", "=", "RADIUS"}));
  run("reset RADIUS");
  EXPECT_EQ(bench_.text(), kText);
  EXPECT_NO_THROW(expect(bench_, {"changed", "=", ""}));
  EXPECT_EQ(bench_.stack().undo_name(), "Reset RADIUS");
  run("param RADIUS 70cm");
  run("save");
  EXPECT_NO_THROW(expect(bench_, {"changed", "=", ""})) << "the saved text counts";
  EXPECT_NE(refusal("reset RADIUX"), "");
}

TEST_F(SceneBenches, PresetsSetAllParamsInOneStep) {
  bench_.preset_folder = folder_.file("state");
  run("save_preset small");
  run("param RADIUS 80cm");
  run("save_preset big");
  run("preset small");
  EXPECT_EQ(bench_.text(), kText);
  EXPECT_EQ(bench_.stack().undo_name(), "Preset small");
  run("undo");
  run("lock_preset big");
  EXPECT_NO_THROW(expect(bench_, {"presets", "=", "big* small"}));
  EXPECT_EQ(refusal("save_preset big"), "cannot replace the preset 'big': it is locked");
  EXPECT_EQ(refusal("delete_preset big"), "cannot delete the preset 'big': it is locked");
  // Another window of the same scene has them.
  SceneBench other;
  other.preset_folder = bench_.preset_folder;
  other.open(file_);
  run_command(other, "preset big");
  EXPECT_EQ(other.param("RADIUS").text, "80cm");
  EXPECT_NE(refusal("preset bi"), "");
}

TEST_F(SceneBenches, AFileThatAnotherWindowSavedIsNotReplaced) {
  SceneBench other;
  other.open(file_);
  run("param RADIUS 70cm");
  run_command(other, "param RADIUS 80cm");
  run_command(other, "save");
  EXPECT_NO_THROW(expect(bench_, {"changed_on_disk", "=", "line 2"}));
  const std::string refused = refusal("save");
  EXPECT_NE(refused.find("another program has changed line 2 of"), std::string::npos) << refused;
  EXPECT_EQ(read_text(file_), other.text());
  EXPECT_TRUE(bench_.is_modified());
  run("reload");
  EXPECT_EQ(bench_.text(), other.text());
  EXPECT_FALSE(bench_.is_modified());
  EXPECT_NO_THROW(expect(bench_, {"changed_on_disk", "=", ""}));
  run("undo");
  EXPECT_EQ(bench_.param("RADIUS").text, "70cm") << "no text is lost";
  run("save");
  EXPECT_EQ(read_text(file_), bench_.text());
  EXPECT_NE(other.changed_on_disk(), "");
  run_command(other, "overwrite");
  EXPECT_EQ(read_text(file_), other.text());
  std::filesystem::remove(file_);
  EXPECT_EQ(bench_.changed_on_disk(), "") << "a removed file holds no work";
  EXPECT_NE(refusal("reload"), "");
  run("save");
  EXPECT_EQ(read_text(file_), bench_.text());
}

TEST_F(SceneBenches, TheSameTextFromAnotherWindowIsNoConflict) {
  SceneBench other;
  other.open(file_);
  for (SceneBench* each : {&bench_, &other}) run_command(*each, "param RADIUS 70cm");
  run_command(other, "save");
  EXPECT_EQ(refusal("save"), "");
}

TEST_F(SceneBenches, AnotherWindowOfTheSameSceneIsNoticed) {
  SceneBench other, elsewhere;
  SceneRecorder first(bench_, folder_.file("state")), second(other, folder_.file("state")),
      third(elsewhere, folder_.file("state"));
  write_text(folder_.file("other.vug"), kText);
  const std::string open = "open " + quoted(file_.string());
  first.run(open);
  EXPECT_FALSE(first.is_open_elsewhere());
  third.run("open " + quoted(folder_.file("other.vug").string()));
  EXPECT_FALSE(third.is_open_elsewhere());
  second.run(open);
  EXPECT_TRUE(first.is_open_elsewhere());
  EXPECT_TRUE(second.is_open_elsewhere());
}

TEST_F(SceneBenches, APixelLeadsToItsMaterial) {
  run("edit " + std::to_string(kText.size()) +
      " 0 \"material stone = lambert(albedo: (0.5, 0.4, 0.3))\n\"");
  run(edit_line("object ball on ball { }", "object ball on ball { material stone }"));
  build();
  EXPECT_NO_THROW(expect(bench_, {"inspected", "=", ""}));
  EXPECT_NE(refusal("go_material"), "");
  run("inspect 0.5 0.5");
  EXPECT_NO_THROW(expect(bench_, {"inspected", "contains", "object ball, material stone"}));
  run("go_material");
  EXPECT_NO_THROW(expect(bench_, {"selected", "=", "stone"}));
  run("inspect 0.01 0.01");
  EXPECT_NO_THROW(expect(bench_, {"inspected", "contains", "no object"}));
}

TEST_F(SceneBenches, TheDisplayIsRefusedWithAReason) {
  build();
  run("exposure 1.5");
  run("tone standard");
  EXPECT_EQ(bench_.viewport().request().display, (viewport::DisplayChoice{1.5, "standard"}));
  run("tone scene");
  EXPECT_EQ(bench_.viewport().request().display, (viewport::DisplayChoice{1.5, ""}));
  EXPECT_NE(refusal("tone sepia"), "");
  EXPECT_NE(refusal("exposure 99"), "");
  EXPECT_EQ(bench_.viewport().request().display, (viewport::DisplayChoice{1.5, ""}));
}

TEST(SceneCommands, HaveDocumentationAndNoSharedKeys) {
  std::set<std::string> keys;
  for (const SceneCommand* each : scene_commands()) {
    EXPECT_NE(each->title, "") << each->name;
    EXPECT_NE(each->doc, "") << each->name;
    if (each->keys.empty()) continue;
    EXPECT_TRUE(keys.insert(each->keys).second) << each->name;
  }
  for (const SceneQuery* each : scene_queries()) EXPECT_NE(each->doc, "") << each->name;
}

TEST_F(SceneBenches, AJournalGivesTheTextOfAKilledProgram) {
  const std::filesystem::path journals = folder_.file("journals");
  RandomStream random{RandomKey(7)};
  std::string expected;
  std::vector<std::string> lines;
  {
    SceneBench killed;
    SceneRecorder recorder(killed, journals);
    recorder.run("open " + quoted(file_.string()));
    for (int i = 0; i < 120; ++i) {
      const size_t size = killed.text().size();
      const uint32_t which = random.below(6);
      if (which == 0 && killed.stack().can_undo())
        recorder.run("undo");
      else if (which == 1 && killed.stack().can_redo())
        recorder.run("redo");
      else if (which == 2)
        recorder.run("end_step");
      else if (which == 3)
        recorder.run("edit 0 1 \"#\"");
      else
        recorder.run("edit " + std::to_string(size) + " 0 " +
                     quoted(which == 4 ? "\n# \"a\\b\"\n" : "# \u00e4") + " Typing typing");
      if (i == 60) recorder.run("save");
    }
    expected = killed.text();
    // The program is killed: its journal stays, without its lock.
    for (const auto& entry : std::filesystem::directory_iterator(journals))
      std::filesystem::copy_file(entry.path(), folder_.file("copy.vugjournal"));
  }
  std::filesystem::rename(folder_.file("copy.vugjournal"), journals / "1-0.vugjournal");
  const std::vector<LostJournal> lost = lost_journals(journals);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_TRUE(is_scene_journal(lost.front()));
  // Another program has changed the file: the journal has the text to which its edits belong.
  write_text(file_, "# other\n");
  SceneBench bench;
  SceneRecorder recorder(bench, journals);
  recorder.recover(lost.front());
  EXPECT_EQ(bench.text(), expected);
  EXPECT_TRUE(bench.is_modified());
  while (bench.stack().can_undo()) bench.undo();
  EXPECT_EQ(bench.text(), "# other\n");
}

}  // namespace
}  // namespace vug::workbench
