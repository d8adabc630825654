// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/store/store.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace vug::store {
namespace {

struct DefaultFolder : testing::Test {
  DefaultFolder() {
    for (const char* name : {"VUG_CACHE", "XDG_CACHE_HOME", "VUG_CACHE_SIZE"}) unsetenv(name);
    setenv("HOME", "/folder", 1);
  }
};

TEST_F(DefaultFolder, FollowsTheEnvironment) {
  EXPECT_EQ(default_folder(), "/folder/.cache/vug");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(default_folder(), "/folder/.cache/vug");
  setenv("XDG_CACHE_HOME", "/fast", 1);
  EXPECT_EQ(default_folder(), "/fast/vug");
  setenv("VUG_CACHE", "/shared/vug", 1);
  EXPECT_EQ(default_folder(), "/shared/vug");
  setenv("VUG_CACHE", "off", 1);
  EXPECT_EQ(default_folder(), "");
}

TEST_F(DefaultFolder, NeedsAHome) {
  unsetenv("HOME");
  EXPECT_EQ(default_folder(), "");
}

TEST_F(DefaultFolder, ReadsTheLimit) {
  EXPECT_EQ(default_max_bytes(), 0u);
  setenv("VUG_CACHE_SIZE", "2M", 1);
  EXPECT_GE(default_max_bytes(), 2'000'000u);
  setenv("VUG_CACHE_SIZE", "much", 1);
  EXPECT_THROW(default_max_bytes(), Error);
}

}  // namespace
}  // namespace vug::store
