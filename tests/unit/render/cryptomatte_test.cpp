// SPDX-License-Identifier: Apache-2.0
// Cryptomatte: hashes of the specification, and coverage equal to that of the samples.
#include <vug/render/film/aovs.h>
#include <vug/render/film/cryptomatte.h>

#include <gtest/gtest.h>

#include <cstring>

#include "scenes.h"

namespace vug::render {
namespace {

// Published values of MurmurHash3_x86_32 with seed 0.
TEST(Cryptomatte, HashIsMurmur3) {
  EXPECT_EQ(murmur3(""), 0u);
  EXPECT_EQ(murmur3("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur3("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(murmur3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreNormalFloats) {
  for (int i = 0; i < 20000; ++i) {
    const uint32_t id = crypto_id("object" + std::to_string(i));
    float value = 0;
    std::memcpy(&value, &id, 4);
    ASSERT_TRUE(std::isnormal(value)) << i;
  }
}

TEST(Cryptomatte, SharesAreSortedAndEqualNamesMerged) {
  const CryptoIds ids = crypto_ids({"a", "b", "a"});
  float out[2 * kCryptoRanks];
  EXPECT_EQ(write_crypto({{0, 2}, {1, 5}, {2, 4}}, 16, ids, out), out + 2 * kCryptoRanks);
  uint32_t id = 0;
  std::memcpy(&id, &out[0], 4);
  EXPECT_EQ(id, crypto_id("a"));
  EXPECT_EQ(out[1], 6.0f / 16);
  EXPECT_EQ(out[3], 5.0f / 16);
  for (size_t i = 4; i < 2 * kCryptoRanks; ++i) EXPECT_EQ(out[i], 0);
}

TEST(Cryptomatte, MattesSplitTheAlpha) {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  mesh::Mesh wall = floor_mesh(1);
  for (Vec3f& p : wall.positions) p = {p.x, p.z, -1};
  scene.objects = {object(floor_mesh(2), 0.5), object(wall, 0.5)};
  scene.objects[0].name = "floor", scene.objects[1].name = "wall";
  Options o = options(40, 30, 16, 0);
  o.aovs = scene_aovs(scene, {"beauty", "A", "cryptomatte"});
  const image::Image picture = render(scene, o);
  const auto at = [&](int x, int y, const std::string& channel) {
    return picture.at(x, y, static_cast<size_t>(picture.find_channel(channel)));
  };
  bool mixed = false;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const float first = at(x, y, "CryptoObject00.G"), second = at(x, y, "CryptoObject00.A");
      ASSERT_EQ(first + second, at(x, y, "A"));
      ASSERT_EQ(at(x, y, "CryptoMaterial00.G"), at(x, y, "A")) << "both have the same material";
      mixed |= second > 0;
    }
  EXPECT_TRUE(mixed);
  const float id = at(20, 20, "CryptoObject00.R");
  const uint32_t expected = crypto_id("floor");
  EXPECT_EQ(std::memcmp(&id, &expected, 4), 0);
}

// From above, the left half of a floor is a door and the right half a window.
TEST(Cryptomatte, ElementsOfAMesh) {
  Scene scene;
  scene.camera = view({0, 3, 0.01}, {0, 0, 0}, 0.55);
  mesh::Mesh left = floor_mesh(1), right = floor_mesh(1);
  for (Vec3f& p : left.positions) p.x -= 1;
  for (Vec3f& p : right.positions) p.x += 1;
  const auto mask = [](mesh::Mesh& mesh, const std::string& name, float value) {
    mesh.attributes.push_back({name, 1, std::vector<float>(mesh.positions.size(), value)});
  };
  mask(left, "door", 1), mask(left, "window", 0), mask(right, "door", 0), mask(right, "window", 1);
  scene.objects = {object(left, 0.5), object(right, 0.5)};
  EXPECT_THROW(scene_aovs(scene, {"beauty", "CryptoElement"}), Error) << "it has no elements";
  EXPECT_FALSE(scene_aovs(scene, {"all"}).has("CryptoElement"));
  for (Object& object : scene.objects) object.elements = {"window", "door"};
  EXPECT_TRUE(scene_aovs(scene, {"all"}).has("CryptoElement"));

  Options o = options(41, 30, 16, 0);  // the seam runs through the pixels in the middle
  // Together with AOVs of the same attributes and those stored after them in the film.
  o.aovs = scene_aovs(
      scene, {"beauty", "A", "attribute_window", "motion", "wetness", "CryptoElement", "parts"});
  EXPECT_EQ(o.aovs.crypto_names("CryptoElement"), (std::vector<std::string>{"door", "window"}));
  const image::Image picture = render(scene, o);
  const auto at = [&](int x, int y, const std::string& channel) {
    return picture.at(x, y, static_cast<size_t>(picture.find_channel(channel)));
  };
  const auto id_at = [&](int x, int y) {
    const float value = at(x, y, "CryptoElement00.R");
    uint32_t id = 0;
    std::memcpy(&id, &value, 4);
    return id;
  };
  EXPECT_EQ(id_at(10, 15), crypto_id("door"));
  EXPECT_EQ(id_at(30, 15), crypto_id("window"));
  EXPECT_EQ(at(30, 15, "CryptoElement00.G"), 1);
  bool mixed = false;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 41; ++x) {
      const float first = at(x, y, "CryptoElement00.G"), second = at(x, y, "CryptoElement00.A");
      ASSERT_NEAR(first + second, at(x, y, "A"), 1e-6);
      mixed |= second > 0;
    }
  EXPECT_TRUE(mixed);
  const image::Metadata notes = crypto_metadata(o.aovs);
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_NE(notes[3].second.find("\"door\":"), std::string::npos) << notes[3].second;
}

}  // namespace
}  // namespace vug::render
