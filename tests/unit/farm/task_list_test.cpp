// SPDX-License-Identifier: Apache-2.0
// Lists of task numbers.
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/farm/task_list.h>

namespace vug::farm {
namespace {

using Tasks = std::vector<size_t>;

TEST(TaskList, HasTheFormsOfSlurmAndOpenJd) {
  EXPECT_EQ(parse_tasks("3"), Tasks({3}));
  EXPECT_EQ(parse_tasks("1-1"), Tasks({1}));
  EXPECT_EQ(parse_tasks("0-4"), Tasks({0, 1, 2, 3, 4}));
  EXPECT_EQ(parse_tasks("7-20:5"), Tasks({7, 12, 17}));
  EXPECT_EQ(parse_tasks("1,3,7-9"), Tasks({1, 3, 7, 8, 9}));
  EXPECT_EQ(parse_tasks("5,1-6:2,5"), Tasks({5, 1, 3})) << "each once, in the order of the text";
}

TEST(TaskList, RefusesOtherTexts) {
  for (const char* text : {"", ",", "1,", "a", "-1", "3-1", "1-", "1-5:", "1-5:0", "1:2", "1 2",
                           "1-9999999999", "99999999999999999999999", "0-999999,1000000"})
    EXPECT_THROW(parse_tasks(text), Error) << text;
  EXPECT_EQ(parse_tasks("0-999998").size(), 999999U);
}

}  // namespace
}  // namespace vug::farm
