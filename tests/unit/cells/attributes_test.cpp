// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/attributes.h>

#include <gtest/gtest.h>

namespace vug::cells {
namespace {

TEST(Attributes, AreCreatedOnFirstUseAndStayInPlace) {
  Attributes a(5);
  Column<float>& wet = a.column<float>("wet", 0.5f);
  for (int i = 0; i < 50; ++i) a.column<int32_t>(std::to_string(i) + "th", i);
  EXPECT_EQ(&a.column<float>("wet", 7.0f), &wet);
  EXPECT_EQ(wet.now, std::vector<float>(5, 0.5f));
  EXPECT_TRUE(wet.next.empty());
  EXPECT_EQ(a.values<int32_t>("49th").at(4), 49);
  EXPECT_EQ(a.all().size(), 51u);
  EXPECT_EQ(a.all().front().type(), "number");
}

TEST(Attributes, UnknownNamesAndWrongTypesAreRefused) {
  Attributes a(3);
  a.column<Vec3f>("Cd");
  try {
    a.values<Vec3f>("Cb");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_STREQ(error.what(), "cells have no attribute 'Cb'");
    EXPECT_EQ(error.hint(), "did you mean 'Cd'?");
  }
  EXPECT_THROW(a.values<float>("Cd"), Error);
  EXPECT_THROW(a.column<int32_t>("Cd"), Error);
}

TEST(States, DetermineReadersAndVisibleCells) {
  EXPECT_TRUE(receives(CellState::active) && distributes(CellState::active));
  EXPECT_TRUE(receives(CellState::receiving) && !distributes(CellState::receiving));
  EXPECT_TRUE(!receives(CellState::distributing) && distributes(CellState::distributing));
  for (const CellState s : {CellState::sleeping, CellState::transparent})
    EXPECT_TRUE(!receives(s) && !distributes(s)) << name_of(s);
}

}  // namespace
}  // namespace vug::cells
