// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/workbench/undo_stack.h>

namespace vug::workbench {
namespace {

TEST(UndoStack, MovesThroughStatesAndDropsUndoneOnes) {
  UndoStack<int> stack(0);
  EXPECT_FALSE(stack.can_undo());
  stack.push("one", 1);
  stack.push("two", 2);
  EXPECT_EQ(stack.undo_name(), "two");
  EXPECT_EQ(stack.undo(5), 2u);
  EXPECT_EQ(stack.current(), 0);
  EXPECT_EQ(stack.redo_name(), "one");
  EXPECT_EQ(stack.undone(), (std::vector<int>{1, 2}));
  EXPECT_EQ(stack.redo(), 1u);
  stack.push("three", 3);
  EXPECT_FALSE(stack.can_redo());
  EXPECT_EQ(stack.before(), 1);
}

TEST(UndoStack, MergesStepsOfOneKeyButNotWithTheSavedState) {
  UndoStack<int> stack(0);
  stack.push("drag", 1, "line 1");
  stack.push("drag", 2, "line 1");
  EXPECT_EQ(stack.done(), 1u);
  stack.push("drag", 3, "line 2");
  EXPECT_EQ(stack.done(), 2u);
  stack.set_clean();
  stack.push("drag", 4, "line 2");
  EXPECT_EQ(stack.done(), 3u) << "undo must lead back to the saved state";
  stack.end_merge();
  stack.push("drag", 5, "line 2");
  EXPECT_EQ(stack.done(), 4u);
}

TEST(UndoStack, KnowsWhetherTheCurrentStateIsSaved) {
  UndoStack<int> stack(0);
  EXPECT_TRUE(stack.is_clean());
  stack.push("one", 1);
  EXPECT_FALSE(stack.is_clean());
  stack.set_clean();
  stack.undo();
  EXPECT_FALSE(stack.is_clean());
  stack.redo();
  EXPECT_TRUE(stack.is_clean());
  stack.undo();
  stack.push("other", 2);
  EXPECT_FALSE(stack.is_clean()) << "the saved state was discarded";
  stack.undo();
  EXPECT_FALSE(stack.is_clean());
}

}  // namespace
}  // namespace vug::workbench
