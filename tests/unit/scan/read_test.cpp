// SPDX-License-Identifier: Apache-2.0
#include "../bytes.h"

#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/scan/read.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

namespace vug::scan {
namespace {

using testing::HasSubstr;

PointCloud read(const std::string& bytes) { return parse_cloud(bytes, "x"); }

Error fault_of(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    parse_cloud(bytes, "x", options);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::internal, "was read");
}

TEST(Xyz, AcceptsBlanksCommasAndSemicolons) {
  for (const char* text :
       {"1 2 3\n4 5 6\n", "1,2,3\r\n4,5,6", "1;2;3\n\n  4 ; 5 ; 6\n",
        "# comment\n1\t2\t+3\n// another\n4 5 6e0", "x y z\n1 2 3\n4 5 6\n", "2\n1 2 3\n4 5 6\n",
        "\xEF\xBB\xBF"
        "1 2 3\n4 5 6\n"}) {
    const PointCloud cloud = read(text);
    EXPECT_EQ(cloud.positions, (std::vector<Vec3d>{{1, 2, 3}, {4, 5, 6}})) << text;
    EXPECT_TRUE(cloud.intensities.empty() && cloud.colours.empty() && cloud.normals.empty());
  }
}

TEST(Xyz, InfersColumnsFromTheirNumber) {
  EXPECT_EQ(read("1 2 3 0.5\n1 2 3 1e-400\n").intensities, (std::vector<float>{0.5F, 0}));
  EXPECT_EQ(read("1 2 3 255 0 51\n").colours, (std::vector<Vec3f>{{1, 0, 0.2F}}));
  EXPECT_EQ(read("1 2 3 0.5 0 1\n").colours, (std::vector<Vec3f>{{0.5F, 0, 1}}));
  const PointCloud all = read("1 2 3 9 0 0 65535\n");
  EXPECT_EQ(all.intensities, (std::vector<float>{9}));
  EXPECT_EQ(all.colours, (std::vector<Vec3f>{{0, 0, 1}}));
}

TEST(Xyz, KeepsMillimetresOfLargeCoordinates) {
  EXPECT_EQ(read("32549123.457 5804321.001 54.321\n").positions[0],
            Vec3d(32549123.457, 5804321.001, 54.321));
}

TEST(Xyz, DropsAndCountsNonFinitePoints) {
  const PointCloud cloud = read("1 2 nan\n1 2 3\ninf 0 0\n1e999 0 0\n");
  EXPECT_EQ(cloud.size(), 1U);
  EXPECT_EQ(cloud.dropped, 3U);
}

TEST(Xyz, ErrorsHaveALocation) {
  struct Case {
    const char* text;
    int line, column;
    const char* message;
  };
  for (const Case& c : {Case{"1 2 3\n4 five 6\n", 2, 3, "'five' is not a number"},
                        {"1 2 3\n4 5\n", 2, 1, "2 numbers, but the previous lines have 3"},
                        {"1 2\n", 1, 1, "invalid point with 2 numbers"},
                        {"1 2 3 4 5\n", 1, 1, "invalid point with 5 numbers"},
                        {"1 2 3 4 5 6 7 8 9\n", 1, 1, "invalid point with 9 numbers"},
                        {"1 2 3 0 -1 0\n", 1, 1, "not a colour value"},
                        {"", 1, 1, "empty"},
                        {"# nothing\nx y z\n", 1, 1, "empty"},
                        {"nan nan nan\n", 1, 1, "none of the points"},
                        {"\x01\x02 1 2\n", 1, 1, "is not a number"}}) {
    const Error error = fault_of(c.text);
    EXPECT_EQ(error.code(), ErrorCode::bad_input) << c.text;
    EXPECT_EQ(error.where(), (SourceLocation{"x", c.line, c.column})) << c.text;
    EXPECT_THAT(error.what(), HasSubstr(c.message)) << c.text;
    EXPECT_FALSE(error.hint().empty()) << c.text;
  }
}

TEST(PlyCloud, ReadsAllEncodingsInAnyOrder) {
  const std::string body =
      "comment made by hand\nelement camera 1\nproperty list uchar float view\n"
      "element vertex 2\nproperty uchar green\nproperty double z\nproperty float nx\n"
      "property float ny\nproperty float nz\nproperty uchar red\nproperty double y\n"
      "property ushort intensity\nproperty uchar blue\nproperty double x\nproperty int age\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<std::string> files = {
      "ply\nformat ascii 1.0\n" + body +
      "2 0.5 0.5\n51 3.25 0 0 1 255 5804321.001 700 0 32549123.457 4\n"
      "0 nan 0 0 1 0 0 0 0 0 4\n3 0 0 0\n"};
  for (const bool big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + body;
    put(bytes, uint8_t{2}, big), put(bytes, 0.5F, big), put(bytes, 0.5F, big);
    for (const bool lost : {false, true}) {
      put(bytes, uint8_t{51}, big);
      put(bytes, lost ? std::numeric_limits<double>::quiet_NaN() : 3.25, big);
      put(bytes, 0.0F, big), put(bytes, 0.0F, big), put(bytes, 1.0F, big);
      put(bytes, uint8_t{255}, big), put(bytes, 5804321.001, big);
      put(bytes, uint16_t{700}, big), put(bytes, uint8_t{0}, big);
      put(bytes, 32549123.457, big), put(bytes, int32_t{4}, big);
    }
    files.push_back(bytes);
  }
  for (const std::string& bytes : files) {
    const PointCloud cloud = read(bytes);
    EXPECT_EQ(cloud.positions, (std::vector<Vec3d>{{32549123.457, 5804321.001, 3.25}}));
    EXPECT_EQ(cloud.colours, (std::vector<Vec3f>{{1, 0.2F, 0}}));
    EXPECT_EQ(cloud.normals, (std::vector<Vec3f>{{0, 0, 1}}));
    EXPECT_EQ(cloud.intensities, (std::vector<float>{700}));
    EXPECT_EQ(cloud.dropped, 1U);
  }
}

TEST(PlyCloud, InvalidFilesAreRejected) {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex ";
  EXPECT_THAT(fault_of(head + "1\nproperty float x\nend_header\n0\n").what(),
              HasSubstr("have no x, y or z"));
  const std::string xyz = "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  EXPECT_THAT(fault_of(head + "0" + xyz).what(), HasSubstr("empty"));
  EXPECT_THAT(fault_of(head + "2" + xyz + "1 2 3 4\n").what(), HasSubstr("do not fit into"));
  const Error word = fault_of(head + "2" + xyz + "1 2 3\n4 five 6\n");
  EXPECT_THAT(word.what(), HasSubstr("'five' is not a number"));
  EXPECT_EQ(word.where().line, 9);
  EXPECT_THAT(fault_of("ply\nformat ascii 1.0\nend_header\n").what(), HasSubstr("no vertices"));
}

TEST(Clouds, MemoryIsCheckedInAdvance) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "1 2 3\n";
  const Error error = fault_of(text, {.memory = 10000});
  EXPECT_EQ(error.code(), ErrorCode::too_large);
  EXPECT_THAT(error.what(), HasSubstr("the cloud of x would take"));
}

TEST(Clouds, RenderedPicturesAreScans) {
  image::Image picture(3, 1, {"R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z"});
  picture.pixels = {1, 1, 1, 5,     0, 0, 1, 1, 2, 3,  // A wall.
                    1, 1, 1, 1e10f, 0, 0, 0, 0, 0, 0,  // The sky.
                    1, 1, 1, 6,     0, 1, 0, 4, 5, NAN};
  const ScratchFolder scratch("vug_scan");
  const auto& folder = scratch.path();
  image::write_exr(folder / "scan.exr", picture);
  const PointCloud cloud = read_clouds({folder / "scan.exr"});
  ASSERT_EQ(cloud.size(), 1U);
  EXPECT_EQ(cloud.positions[0], Vec3d(1, 2, 3));
  EXPECT_EQ(cloud.normals[0], Vec3f(0, 0, 1));
  EXPECT_EQ(cloud.dropped, 1U);
  EXPECT_THROW(read_picture(folder / "scan.exr", {.memory = 50}), Error);

  image::write_exr(folder / "flat.exr", image::Image(2, 2, {"R", "G", "B"}));
  try {
    read_clouds({folder / "flat.exr"});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.hint(), HasSubstr("layers"));
  }
}

TEST(Clouds, ConcatenationKeepsCommonAttributes) {
  const PointCloud both = concatenated(read("1 2 3 7\nnan 0 0 0\n"), read("4 5 6 8\n"));
  EXPECT_EQ(both.intensities, (std::vector<float>{7, 8}));
  EXPECT_EQ(both.dropped, 1U);
  const PointCloud less = concatenated(both, read("4 5 6\n"));
  EXPECT_EQ(less.size(), 3U);
  EXPECT_TRUE(less.intensities.empty());
  EXPECT_EQ(concatenated(PointCloud{}, both).intensities, both.intensities);
  EXPECT_THROW(read_clouds({}), Error);
  EXPECT_THROW(read_clouds({"no/such/file.xyz"}), Error);
}

}  // namespace
}  // namespace vug::scan
