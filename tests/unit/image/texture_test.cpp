// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/image/texture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::image {
namespace {

/// Left half 1, right half 0.
Image halves() {
  Image picture(64, 64, {"R", "G", "B"});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 32; ++x)
      for (size_t c = 0; c < 3; ++c) picture.at(x, y, c) = 1;
  return picture;
}

std::string refusal_of_texture(const std::filesystem::path& path) {
  try {
    const Texture texture(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Texture, IsSharpForNarrowAndUniformForWideFilters) {
  const ScratchFolder scratch("vug_texture");
  const auto path = scratch.file("halves.exr");
  write_exr(path, halves());
  const Texture texture(path);
  EXPECT_NEAR(texture.at(0.25, 0.5, 0).x, 1, 1e-3);
  EXPECT_NEAR(texture.at(0.75, 0.5, 0).x, 0, 1e-3);
  EXPECT_NEAR(texture.at(-3.75, 7.5, 0).x, 1, 1e-3) << "it repeats";
  EXPECT_NEAR(texture.at(0.25, 0.5, 4).x, 0.5, 0.02) << "a look wider than the picture";
}

TEST(Texture, ReportsUnusableFiles) {
  EXPECT_NE(refusal_of_texture("no/such.exr").find("no/such.exr"), std::string::npos);
  Image bad = halves();
  bad.at(3, 5, 1) = std::numeric_limits<float>::quiet_NaN();
  const ScratchFolder scratch("vug_texture");
  const auto path = scratch.file("nan.exr");
  write_exr(path, bad);
  const std::string reason = refusal_of_texture(path);
  EXPECT_NE(reason.find("not finite"), std::string::npos) << reason;
  EXPECT_NE(reason.find("(3, 5)"), std::string::npos) << reason;
}

}  // namespace
}  // namespace vug::image
