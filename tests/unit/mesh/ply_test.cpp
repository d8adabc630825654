// SPDX-License-Identifier: Apache-2.0
#include "../bytes.h"
#include "faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace vug::mesh {
namespace {

Mesh read_ply_text(const std::string& text) { return format_of("x.ply").read(text, "x.ply"); }

TEST(Ply, ReadsAnyOrderOfPropertiesInText) {
  const Mesh mesh = read_ply_text(
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement vertex 3\r\nproperty uchar green\r\n"
      "property double z\r\nproperty list uchar int spare\r\nproperty float x\r\n"
      "property uchar blue\r\nproperty float age\r\nproperty uchar red\r\nproperty short y\r\n"
      "element thing 2\r\nproperty int i\r\nelement face 1\r\nproperty uchar flag\r\n"
      "property list uint8 uint32 vertex_index\r\nend_header\r\n"
      "0 0.5 2 7 7 0 255 9 255 0\r\n51 0.5 0 1 0 8 0 0\r\n0 0.5 1 3 0 0 7 102 1\r\n"
      "1\r\n2\r\n0 3 0 1 2\r\n");
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0.5F}, {1, 0, 0.5F}, {0, 1, 0.5F}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  ASSERT_NE(find_attribute(mesh, kColour, 3), nullptr);
  EXPECT_EQ(find_attribute(mesh, kColour, 3)->values,
            (std::vector<float>{1, 0, 1, 0, 0.2F, 0, 0.4F, 0, 0}));
  ASSERT_NE(find_attribute(mesh, "age", 1), nullptr);
  EXPECT_EQ(find_attribute(mesh, "age", 1)->values, (std::vector<float>{9, 8, 7}));
}

TEST(Ply, ReadsBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                        "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
                        "property int16 z\nelement face 1\nproperty list ushort uint8 "
                        "vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i) {
      put(bytes, static_cast<double>(i == 1 || i == 2), big);
      put(bytes, static_cast<float>(i >= 2), big);
      put(bytes, static_cast<int16_t>(-300), big);
    }
    put(bytes, static_cast<uint16_t>(4), big);
    bytes.append({0, 1, 2, 3});
    const Mesh mesh = read_ply_text(bytes);
    EXPECT_EQ(mesh.positions,
              (std::vector<Vec3f>{{0, 0, -300}, {1, 0, -300}, {1, 1, -300}, {0, 1, -300}}));
    EXPECT_EQ(mesh.triangles.size(), 2U);
  }
}

TEST(Ply, AttributesOfAnyArityComeBack) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.attributes = {{"moss", 1, {1, 2, 3}},
                     {"flow", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}},
                     {"uv", 2, {0, 0, 1, 0, 0, 1}}};
  std::string bytes;
  format_of("x.ply").write(mesh, {}, [&](std::string_view more) { bytes += more; });
  EXPECT_EQ(read_ply_text(bytes), mesh);
  mesh.attributes.push_back({"moss", 1, {0, 0, 0}});
  EXPECT_THROW(format_of("x.ply").write(mesh, {}, [](std::string_view) {}), Error);
}

TEST(Ply, CountsBeyondTheFileAreRefusedBeforeAllocation) {
  const std::string point = "property float x\nproperty float y\nproperty float z\n";
  for (const std::string encoding : {"ascii", "binary_little_endian"}) {
    const std::string head = "ply\nformat " + encoding + " 1.0\n";
    EXPECT_THROW(read_ply_text(head + "element vertex 4000000000\n" + point + "end_header\n"),
                 Error);
    EXPECT_THROW(
        read_ply_text(head + "element vertex 99999999999999999999\n" + point + "end_header\n"),
        Error);
    EXPECT_THROW(read_ply_text(head + "element vertex -1\n" + point + "end_header\n"), Error);
  }
  EXPECT_THROW(read_ply_text("ply\nformat ascii 1.0\nelement vertex 1\n" + point +
                             "element face 1\nproperty list uint int vertex_index\nend_header\n"
                             "0 0 0\n4000000000 0 0 0\n"),
               Error);
}

TEST(Ply, FaultsNameTheirLine) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  expect_faults("ply",
                {
                    {"plyx\n", 1, "begin with 'ply'"},
                    {"ply\nformat ascii 2.0\n", 2, "unsupported PLY version"},
                    {"ply\nformat utf8 1.0\n", 2, "unknown PLY encoding"},
                    {"ply\nelement vertex 1\nproperty quad x\n", 3, "unknown PLY type"},
                    {"ply\nproperty float x\n", 2, "precedes the first element"},
                    {"ply\nformat ascii 1.0\nelement vertex 0\n", 4, "end_header"},
                    {"ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", 3, "lack x, y or z"},
                    {"ply\nformat ascii 1.0\nend_header\n", 1, "no vertices"},
                    {head + "0 0 zero\n3 0 0 0\n", 10, "'zero' is not a number"},
                    {head + "0 0 inf\n3 0 0 0\n", 10, "not a finite"},
                    {head + "0 0 0\n3 0 0 1\n", 11, "uses vertex 1 of 1"},
                    {head + "0 0 0\n3 0 0 -1\n", 11, "uses vertex -1 of 1"},
                    {head + "0 0 0\n2 0 0\n", 11, "2 corners"},
                    {head + "0 0 0\n3 0 0", 11, "ends inside a list"},
                    {head + "0 0 0\n3 0 0   ", 11, "is missing"},
                });
}

}  // namespace
}  // namespace vug::mesh
