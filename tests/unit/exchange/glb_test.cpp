// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/exchange/format.h>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "sample.h"

namespace vug::exchange {
namespace {

class Glb : public testing::Test {
 protected:
  tinygltf::Model round_trip(const Assembly& assembly, const Space& space = {},
                             const FormatOptions& options = {}) {
    written_ = write(format("glb"), assembly, space, folder_ / "a.glb", options);
    tinygltf::Model model;
    std::string errors, warnings;
    EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &errors, &warnings,
                                                        (folder_ / "a.glb").string()))
        << errors << warnings;
    return model;
  }
  const ScratchFolder scratch_{"vug_glb"};
  const std::filesystem::path& folder_ = scratch_.path();
  WriteReport written_;
};

const tinygltf::Node& node(const tinygltf::Model& model, const std::string& name) {
  for (const tinygltf::Node& each : model.nodes)
    if (each.name == name) return each;
  ADD_FAILURE() << "no node " << name;
  return model.nodes.front();
}

TEST_F(Glb, ACubeOfAMetreIsOneMetreInEverySpace) {
  for (const Space& space : {Space{UpAxis::y, 1}, Space{UpAxis::z, 0.01}}) {
    const tinygltf::Model model = round_trip(sample(), space);
    const auto& position = model.accessors.at(
        static_cast<size_t>(model.meshes.at(0).primitives.at(0).attributes.at("POSITION")));
    EXPECT_EQ(position.minValues, (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(position.maxValues, (std::vector<double>{1, 1, 1}));
    EXPECT_EQ(position.count, 8u);
    EXPECT_EQ(node(model, "main").translation, (std::vector<double>{0, 1.5, 4}));
  }
}

TEST_F(Glb, EachRockIsAPrimitiveWithItsMaterial) {
  Assembly all = sample();
  Prototype& cube = all.prototypes[0];
  cube.mesh = two_rocks(*cube.mesh);
  EXPECT_EQ(round_trip(all).meshes.at(0).primitives.size(), 1u);
  cube.rocks = {{"limestone", cube.look}, {"shale", cube.look}};
  cube.rocks[1].look.roughness = 0.125;
  const tinygltf::Model model = round_trip(all);
  const std::vector<tinygltf::Primitive>& parts = model.meshes.at(0).primitives;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].attributes, parts[1].attributes) << "the vertices are shared";
  size_t corners = 0;
  for (size_t i = 0; i < 2; ++i) {
    const tinygltf::Material& material = model.materials.at(static_cast<size_t>(parts[i].material));
    EXPECT_EQ(material.name, cube.material + "_" + cube.rocks[i].rock);
    EXPECT_NEAR(material.pbrMetallicRoughness.roughnessFactor, cube.rocks[i].look.roughness, 1e-12);
    corners += model.accessors.at(static_cast<size_t>(parts[i].indices)).count;
  }
  EXPECT_EQ(corners, 3 * cube.mesh->triangles.size());
}

TEST_F(Glb, PartialOpacityIsExported) {
  Assembly all = sample();
  all.prototypes[0].look.opacity = 0.25;
  tinygltf::Model model = round_trip(all);
  EXPECT_EQ(model.materials.at(0).alphaMode, "BLEND");
  EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorFactor.at(3), 0.25);
  mesh::Mesh veiled = *all.prototypes[0].mesh;
  std::vector<float> opacity(veiled.positions.size(), 1);
  opacity[2] = 0.5f;
  veiled.attributes.push_back({"opacity", 1, opacity});
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>(veiled);
  model = round_trip(all);
  EXPECT_EQ(model.materials.at(0).alphaMode, "BLEND");
  EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorFactor.at(3), 1);
  const tinygltf::Accessor& colors = model.accessors.at(
      static_cast<size_t>(model.meshes.at(0).primitives.at(0).attributes.at("COLOR_0")));
  ASSERT_EQ(colors.type, TINYGLTF_TYPE_VEC4);
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<size_t>(colors.bufferView));
  const auto alpha = [&](size_t vertex) {
    uint16_t value = 0;
    std::memcpy(&value, &model.buffers.at(0).data.at(view.byteOffset + 8 * vertex + 6), 2);
    return value;
  };
  EXPECT_EQ(alpha(1), 65535);
  EXPECT_EQ(alpha(2), 32768);
}

TEST_F(Glb, EverythingIsThereOnce) {
  const tinygltf::Model model = round_trip(sample());
  EXPECT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.materials.size(), 1u);
  EXPECT_EQ(model.cameras.size(), 2u);
  EXPECT_EQ(model.cameras[0].extras.Get("vug:size").Get(0).GetNumberAsInt(), 640);
  EXPECT_EQ(model.lights.size(), 5u);
  EXPECT_EQ(model.nodes.size(), 2u + 2 + 5);
  const auto& instancing = node(model, "strewn").extensions.at("EXT_mesh_gpu_instancing");
  const int moves = instancing.Get("attributes").Get("TRANSLATION").GetNumberAsInt();
  EXPECT_EQ(model.accessors.at(static_cast<size_t>(moves)).count, 3u);
  const auto& attributes = model.meshes[0].primitives[0].attributes;
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0", "_WETNESS", "_FLOW"})
    EXPECT_EQ(attributes.count(name), 1u) << name;
  EXPECT_EQ(model.asset.extras.Get("vug:recipe").Get<std::string>(), sample().provenance.recipe);
}

TEST_F(Glb, WithoutInstancingEveryPlaceIsANode) {
  FormatOptions options;
  options.instancing = false;
  const tinygltf::Model model = round_trip(sample(), {}, options);
  EXPECT_EQ(model.nodes.size(), 4u + 2 + 5);
  EXPECT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(node(model, "strewn.2").translation, (std::vector<double>{4, 0, -1}));
  EXPECT_EQ(model.extensionsUsed.end(),
            std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(),
                      "EXT_mesh_gpu_instancing"));
}

TEST_F(Glb, WattsAreCandelaOver683) {
  const tinygltf::Model model = round_trip(sample());
  const tinygltf::Light& ball = model.lights.at(0);
  // The power derived by programs that assume 683 lumens per watt, such as Blender, is that of the
  // light.
  const double watts = ball.intensity / 683 * 4 * kPi;
  for (size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(watts * ball.color[c], power(sample().lights[0])[static_cast<int>(c)], 1e-9);
  EXPECT_EQ(ball.type, "point");
  EXPECT_EQ(model.lights.at(3).type, "spot");
  EXPECT_NEAR(model.lights.at(3).spot.outerConeAngle, 0.5, 1e-12);
  EXPECT_NEAR(model.lights.at(3).spot.innerConeAngle, 0.4, 1e-12);
  EXPECT_EQ(model.lights.at(4).type, "directional");
}

TEST_F(Glb, UnsupportedDataIsReported) {
  Assembly all = sample();
  all.volumes.push_back({"fog", "sample_fog.vdb", {{"density", "fog volume"}}, Box3d()});
  all.lights[3].profile = "lamp.ies";
  round_trip(all);
  ASSERT_EQ(written_.unsupported.size(), 1u);  // A volume is written separately and not lost.
  EXPECT_NE(written_.unsupported[0].find("profile of the light 'lamp3'"), std::string::npos);
  std::string told;
  for (const std::string& each : written_.notes) told += each + "\n";
  for (const char* what : {"sky 'lamp5'", "size of the light 'lamp1'", "depth of field"})
    EXPECT_NE(told.find(what), std::string::npos) << what << " in\n" << told;
}

TEST_F(Glb, SkiesAndMediaAreStoredInTheExtras) {
  Assembly all = sample();
  image::Image picture(4, 2, {"R", "G", "B"});
  picture.pixels.assign(picture.pixels.size(), 0.5F);
  Light second = all.lights.back();
  second.name = "heaven";
  second.place = Transform::rotation({0, 1, 0}, 0.5 * kPi);
  second.picture = std::make_shared<const image::Image>(picture);
  all.lights.push_back(second);
  all.volumes.push_back({"fog",
                         "a_fog.vdb",
                         {{"density", "fog volume"}, {"flame", "fog volume"}},
                         Box3d(),
                         Medium{2, Vec3d(0.5), 0.25, Vec3d(1, 2, 3), 1}});
  all.space.metres_per_unit = 0.01;
  const tinygltf::Model model = round_trip(all);
  const tinygltf::Value& skies = model.scenes[0].extras.Get("vug:skies");
  ASSERT_EQ(skies.ArrayLen(), 2u);
  EXPECT_EQ(skies.Get(0).Get("radiance").Get(0).GetNumberAsDouble(), 4);
  EXPECT_FALSE(skies.Get(0).Has("file"));
  EXPECT_EQ(skies.Get(1).Get("file").Get<std::string>(), "a_heaven.exr");
  EXPECT_NEAR(skies.Get(1).Get("rotation").Get(1).GetNumberAsDouble(), std::sqrt(0.5), 1e-12);
  ASSERT_EQ(written_.files.size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(written_.files[1]));
  // The file's unit is the metre.
  const tinygltf::Value& cloud = model.scenes[0].extras.Get("vug:volumes").Get(0);
  EXPECT_NEAR(cloud.Get("extinction").GetNumberAsDouble(), 200, 1e-9);
  EXPECT_NEAR(cloud.Get("emission").Get(2).GetNumberAsDouble(), 300, 1e-9);
  EXPECT_NEAR(cloud.Get("heat").GetNumberAsDouble(), 100, 1e-9);
  EXPECT_EQ(cloud.Get("grids").Get(1).Get<std::string>(), "flame");
}

TEST_F(Glb, ShearedAndMirroredInstancesAreInPlace) {
  Assembly all = sample();
  const Transform shear = Transform::scaling({1, 2, 1}) * Transform::rotation({0, 0, 1}, 0.5);
  all.groups = {{"sheared", 0, {shear}}, {"mirrored", 0, {Transform::scaling({-1, 1, 1})}}};
  const tinygltf::Model model = round_trip(all);
  ASSERT_EQ(model.meshes.size(), 2u);
  const auto& mesh = model.meshes.at(static_cast<size_t>(node(model, "sheared").mesh));
  const auto& position =
      model.accessors.at(static_cast<size_t>(mesh.primitives.at(0).attributes.at("POSITION")));
  const Box3d box = shear.box(Box3d(Vec3d(0.0), Vec3d(1.0)));
  for (size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(position.maxValues[i], box.max[static_cast<int>(i)], 1e-6);
  EXPECT_EQ(node(model, "mirrored").scale, (std::vector<double>{-1, 1, 1}));
}

TEST_F(Glb, TheSameBytesAgain) {
  round_trip(sample());
  const std::string first = read_text(folder_ / "a.glb");
  round_trip(sample());
  EXPECT_EQ(first, read_text(folder_ / "a.glb"));
}

TEST_F(Glb, AFullDiskLeavesTheOldFile) {
  round_trip(sample());
  const std::string before = read_text(folder_ / "a.glb");
  Assembly all = sample();
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(write(format("glb"), all, {}, folder_ / "a.glb", {}, cancelled), Error);
  EXPECT_EQ(before, read_text(folder_ / "a.glb"));
  std::filesystem::create_directories(folder_ / "b.glb");
  EXPECT_THROW(write(format("glb"), all, {}, folder_ / "b.glb"), Error);
}

TEST_F(Glb, AnEmptySceneIsAFile) {
  Assembly none;
  none.name = "none";
  const tinygltf::Model model = round_trip(none);
  EXPECT_TRUE(model.nodes.empty());
}

}  // namespace
}  // namespace vug::exchange
