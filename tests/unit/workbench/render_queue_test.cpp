// SPDX-License-Identifier: Apache-2.0
// The queue of renders: one at a time, in order; pause, resume and cancel; its file.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/workbench/render_queue.h>

#include <gtest/gtest.h>

namespace vug::workbench {
namespace {

QueuedRender render_of(const std::filesystem::path& output) {
  QueuedRender out;
  out.scene = "/scenes/a cave.vug";
  out.output = output;
  return out;
}

class RenderQueues : public testing::Test {
 protected:
  RenderState state(int number) const { return queue_.find(number).state; }

  ScratchFolder folder_{"vug_queue"};
  RenderQueue queue_{folder_.path()};
};

TEST_F(RenderQueues, RunsOneRenderAfterTheOther) {
  queue_.add(render_of("/tmp/a.exr"));
  queue_.add(render_of("/tmp/b.exr"));
  EXPECT_EQ(queue_.next(), 1);
  queue_.started(1);
  EXPECT_EQ(queue_.next(), std::nullopt) << "one runs";
  queue_.ended(1, 0);
  EXPECT_EQ(state(1), RenderState::done);
  EXPECT_EQ(queue_.next(), 2);
  queue_.started(2);
  queue_.ended(2, 0);
  EXPECT_EQ(queue_.next(), std::nullopt);
}

TEST_F(RenderQueues, ReadsTheProgressOfTheProgram) {
  queue_.add(render_of("/tmp/a.exr"));
  queue_.started(1);
  queue_.said(1, "\rmeshing                 [====      ]  40% 3 s left    ");
  EXPECT_EQ(queue_.find(1).stage, "meshing");
  EXPECT_EQ(queue_.find(1).fraction, 0.4);
  queue_.said(1, "\rrend");
  queue_.said(1, "ering               [==========] 100% 0.2 s\nwarning: dark\nerror: the disk is ");
  EXPECT_EQ(queue_.find(1).stage, "rendering");
  EXPECT_EQ(queue_.find(1).fraction, 1);
  queue_.said(1, "full\nhint: delete [old] pictures");
  queue_.ended(1, 3);
  EXPECT_EQ(state(1), RenderState::failed);
  EXPECT_EQ(queue_.find(1).error, "error: the disk is full\nhint: delete [old] pictures\n");
}

TEST_F(RenderQueues, AFailureWithoutAMessageHasItsCode) {
  queue_.add(render_of("/tmp/a.exr"));
  queue_.started(1);
  queue_.ended(1, 7);
  EXPECT_EQ(queue_.find(1).error, "error: the program ended with code 7\n");
  queue_.resume(1);
  EXPECT_EQ(state(1), RenderState::waiting) << "it can be tried again";
  EXPECT_EQ(queue_.find(1).error, "");
  queue_.started(1);
  queue_.ended(1, -1);
  EXPECT_EQ(queue_.find(1).error, "error: the program was killed\n");
}

TEST_F(RenderQueues, APauseLetsTheNextOneRun) {
  queue_.add(render_of("/tmp/a.exr"));
  queue_.add(render_of("/tmp/b.exr"));
  queue_.started(1);
  queue_.pause(1);
  queue_.ended(1, 3);  // stopped on request
  EXPECT_EQ(state(1), RenderState::paused);
  EXPECT_EQ(queue_.find(1).error, "");
  EXPECT_EQ(queue_.next(), 2);
  queue_.resume(1);
  EXPECT_EQ(queue_.next(), 1);
  // Resumed before the process has ended: it runs again.
  queue_.started(1);
  queue_.pause(1);
  queue_.resume(1);
  queue_.ended(1, 3);
  EXPECT_EQ(state(1), RenderState::waiting);
  queue_.started(1);
  queue_.ended(1, 0);
  EXPECT_THROW(queue_.pause(1), Error);
  EXPECT_THROW(queue_.resume(1), Error);
}

TEST_F(RenderQueues, ACancelledRenderLeavesNoCheckpoint) {
  const std::filesystem::path output = folder_.file("a.exr");
  queue_.add(render_of(output));
  write_text(queue_.find(1).checkpoint(), "samples");
  const std::filesystem::path checkpoint = queue_.find(1).checkpoint();
  queue_.started(1);
  queue_.cancel(1);
  EXPECT_TRUE(std::filesystem::exists(checkpoint)) << "its program still writes it";
  queue_.ended(1, 3);
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  EXPECT_TRUE(queue_.all().empty());
  EXPECT_THROW(queue_.cancel(1), Error);
}

TEST_F(RenderQueues, APausedRenderIsCancelledWhenItsProgramHasEnded) {
  const std::filesystem::path output = folder_.file("a.exr");
  queue_.add(render_of(output));
  const std::filesystem::path checkpoint = queue_.find(1).checkpoint();
  queue_.started(1);
  queue_.pause(1);
  queue_.cancel(1);
  EXPECT_THROW(queue_.pause(1), Error) << "that would undo the cancellation";
  write_text(checkpoint, "samples");
  queue_.ended(1, 3);
  EXPECT_FALSE(std::filesystem::exists(checkpoint));
  EXPECT_TRUE(queue_.all().empty());
}

TEST_F(RenderQueues, AFailedRenderKeepsItsFile) {
  queue_.add(render_of("/tmp/a.exr"));
  queue_.started(1);
  queue_.ended(1, 2);
  EXPECT_THROW(queue_.add(render_of("/tmp/a.exr")), Error) << "both would write one checkpoint";
}

TEST_F(RenderQueues, RefusesTwoRendersOfOneFile) {
  queue_.add(render_of("/tmp/a.exr"));
  EXPECT_THROW(queue_.add(render_of("/tmp/a.exr")), Error);
  queue_.started(1);
  queue_.ended(1, 0);
  EXPECT_EQ(queue_.add(render_of("/tmp/a.exr")), 2) << "the first one has ended";
}

TEST_F(RenderQueues, CallsTheProgram) {
  QueuedRender render = render_of("/tmp/a.exr");
  render.render = "wide";
  render.parameters = {"RADIUS=2m", "N=3"};
  const std::vector<std::string> expected = {"render",       "/scenes/a cave.vug",
                                             "-D",           "RADIUS=2m",
                                             "-D",           "N=3",
                                             "--render",     "wide",
                                             "-o",           "/tmp/a.exr",
                                             "--checkpoint", "/tmp/a.exr.checkpoint",
                                             "--resume",     "--progress"};
  EXPECT_EQ(render.arguments(), expected);
}

TEST(RenderQueueFiles, AnotherSessionContinues) {
  const ScratchFolder folder("vug_queue");
  {
    RenderQueue queue(folder.path());
    QueuedRender render = render_of("/tmp/a \"b\".exr");
    render.render = "main";
    render.parameters = {"TEXT=\"a\nb\""};
    queue.add(render);
    queue.add(render_of("/tmp/b.exr"));
    queue.add(render_of("/tmp/c.exr"));
    queue.started(1);
    queue.ended(1, 2);
    queue.started(2);
    RenderQueue second(folder.path());
    EXPECT_TRUE(second.is_held_elsewhere());
    EXPECT_TRUE(second.all().empty());
    EXPECT_THROW(second.add(render), Error);
  }
  const RenderQueue next(folder.path());
  EXPECT_FALSE(next.is_held_elsewhere());
  ASSERT_EQ(next.all().size(), 3u);
  EXPECT_EQ(next.find(1).state, RenderState::failed);
  EXPECT_EQ(next.find(1).error, "error: the program ended with code 2\n");
  EXPECT_EQ(next.find(1).render, "main");
  EXPECT_EQ(next.find(1).parameters, (std::vector<std::string>{"TEXT=\"a\nb\""}));
  EXPECT_EQ(next.find(1).output, "/tmp/a \"b\".exr");
  EXPECT_EQ(next.find(2).state, RenderState::paused) << "its program has ended with the session";
  EXPECT_EQ(next.find(3).state, RenderState::waiting);
}

}  // namespace
}  // namespace vug::workbench
