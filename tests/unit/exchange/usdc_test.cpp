// SPDX-License-Identifier: Apache-2.0
// Binary USD files as read by the reader of the tests; tests/dcc compares them with text by
// third-party readers.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/exchange/format.h>
#include <vug/exchange/program.h>
#include <vug/exchange/usd_crate.h>
#include <vug/exchange/usd_tiles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <functional>
#include <map>

#include "crate_file.h"
#include "sample.h"

namespace vug::exchange {
namespace {

constexpr uint64_t kInlined = uint64_t{1} << 62;

/// The bytes of a layer that `write` fills.
std::string layer_bytes(const std::function<void(UsdLayer&)>& write) {
  std::string bytes;
  const mesh::ByteSink sink = [&](std::string_view more) { bytes += more; };
  UsdCrate layer(sink);
  layer.header({"a", {"r", 7, 1, "v"}, {}});
  write(layer);
  layer.finish();
  const std::string header = layer.file_header();
  EXPECT_EQ(header.size(), 88u);
  return header + bytes.substr(header.size());
}

uint64_t float_payload(float value) {
  uint32_t bits = 0;
  std::memcpy(&bits, &value, 4);
  return bits;
}
uint64_t inlined(uint64_t type, uint64_t payload) { return kInlined | type << 48 | payload; }

// Everything up to the sections, derived by hand from the format.
TEST(Usdc, BytesOfATinyLayer) {
  const std::string bytes = layer_bytes([](UsdLayer& layer) {
    layer.begin_prim("Xform", "a", {usd_kind("assembly"), usd_api_schema("S")});
    const int32_t numbers[] = {5, 6};
    layer.attribute({"int", "n"}, UsdArray{numbers, 2});
    layer.end();
  });
  CrateFile file(bytes);
  EXPECT_EQ(bytes.substr(0, 16), std::string("PXR-USDC\0\x08\0\0\0\0\0\0", 16));
  EXPECT_EQ(bytes.substr(24, 64), std::string(64, '\0'));
  EXPECT_EQ(file.end, bytes.size());
  // Tokens in the order of their first use.
  const std::vector<std::string> first = {";-)",      "vug:frame",   "vug:recipe",
                                          "r",        "7",           "v",
                                          "vug:seed", "vug:version", "customLayerData"};
  for (const std::string& each : first)
    EXPECT_NE(std::find(file.tokens.begin(), file.tokens.end(), each), file.tokens.end()) << each;
  const auto string_of = [&](const std::string& text) {
    for (uint32_t i = 0; i < file.strings.size(); ++i)
      if (file.string(i) == text) return i;
    return ~0u;
  };
  std::string expected;
  const auto put = [&](uint64_t value, size_t size) {
    for (size_t i = 0; i < size; ++i) expected += static_cast<char>(value >> (8 * i));
  };
  put(4, 8);  // entries of customLayerData, by name
  const std::pair<const char*, uint64_t> entries[] = {{"vug:frame", inlined(9, float_payload(1))},
                                                      {"vug:recipe", inlined(10, string_of("r"))},
                                                      {"vug:seed", inlined(10, string_of("7"))},
                                                      {"vug:version", inlined(10, string_of("v"))}};
  for (const auto& [name, value] : entries) {
    put(string_of(name), 4);
    put(8, 8);  // the value follows the distance
    put(value, 8);
  }
  const size_t list = 88 + expected.size();
  put(32, 1);  // prepended items
  put(1, 8);
  put(static_cast<uint64_t>(std::find(file.tokens.begin(), file.tokens.end(), "S") -
                            file.tokens.begin()),
      4);
  while ((88 + expected.size()) % 8 != 0) expected += '\0';
  const size_t array = 88 + expected.size();
  put(2, 8);
  put(5, 4);
  put(6, 4);
  EXPECT_EQ(bytes.substr(88, expected.size()), expected);
  EXPECT_EQ(file.rep("/", "customLayerData"), uint64_t{31} << 48 | 88);
  EXPECT_EQ(file.rep("/a", "apiSchemas"), uint64_t{32} << 48 | list);
  EXPECT_EQ(file.rep("/a.n", "default"), uint64_t{1} << 63 | uint64_t{3} << 48 | array);
  EXPECT_EQ(file.token("/a", "kind"), "assembly");
  EXPECT_EQ(file.token("/a", "typeName"), "Xform");
  EXPECT_EQ(file.rep("/a", "specifier"), inlined(42, 0));
  EXPECT_EQ(file.token("/a.n", "typeName"), "int[]");
  EXPECT_EQ(file.token("/", "defaultPrim"), "a");
  EXPECT_EQ(file.token("/", "upAxis"), "Y");
  EXPECT_EQ(file.rep("/", "metersPerUnit"), inlined(9, float_payload(1)));
  EXPECT_EQ(file.token_vector(file.rep("/", "primChildren")), std::vector<std::string>{"a"});
  EXPECT_EQ(file.token_vector(file.rep("/a", "properties")), std::vector<std::string>{"n"});
  EXPECT_EQ(file.specs.size(), 3u);
  EXPECT_EQ(file.specs.at("/").type, 7);
  EXPECT_EQ(file.specs.at("/a").type, 6);
  EXPECT_EQ(file.specs.at("/a.n").type, 1);
}

TEST(Usdc, ValuesAreInlinedIfTheyFit) {
  UsdMatrix scaling = {};
  for (size_t i = 0; i < 4; ++i) scaling[5 * i] = i == 3 ? 1 : -2;
  UsdMatrix moved = scaling;
  moved[12] = 3;
  UsdMatrix fraction = scaling;
  fraction[0] = 0.5;
  const float turn[] = {0.5f, 1, 2, 3};  // the real part first
  std::vector<int32_t> many(16, 4);
  CrateFile file(layer_bytes([&](UsdLayer& layer) {
    layer.begin_prim("Xform", "a");
    layer.attribute({"float", "f"}, 0.1);
    layer.attribute({"float", "between"}, 1.2999998927116394);
    layer.attribute({"double", "whole"}, 0.5);
    layer.attribute({"double", "fine"}, 0.1);
    layer.attribute({"int", "i"}, -2);
    layer.attribute({"bool", "one"}, 1);
    layer.attribute({"bool", "yes", true}, true);
    layer.attribute({"color3f", "small"}, UsdTuple{1, -2, 127});
    layer.attribute({"color3f", "half"}, UsdTuple{1, 0.5, 0});
    layer.attribute({"color3f", "large"}, UsdTuple{128, 0, 0});
    layer.attribute({"matrix4d", "scaling"}, scaling);
    layer.attribute({"matrix4d", "moved"}, moved);
    layer.attribute({"matrix4d", "fraction"}, fraction);
    layer.attribute({"quatf", "turn"}, UsdArray{turn, 1, 4});
    layer.attribute({"quath", "halves"}, UsdArray{turn, 1, 4});
    layer.attribute({"float3", "empty"}, UsdArray{static_cast<const float*>(nullptr), 0, 3});
    layer.attribute({"float3", "box"}, UsdTuples{Vec3d(kUsdEmptyExtent), Vec3d(0.25)});
    layer.attribute({"int", "many"}, UsdArray{many.data(), many.size()});
    layer.attribute({"token", "declared"}, {});
    layer.attribute({.type = "float", .name = "d", .custom = true}, 2.0);
    layer.attribute({.type = "float", .name = "p", .interpolation = "vertex", .element_size = 5},
                    UsdArray{turn, 4});
    layer.attribute({"asset", "file"}, UsdAsset{"./b.vdb"});
    layer.attribute({"string", "text"}, UsdString{"two words"});
    layer.end();
  }));
  const auto value = [&](const std::string& name) { return file.rep("/a." + name, "default"); };
  EXPECT_EQ(value("f"), inlined(8, float_payload(0.1f)));
  // Half-way between two floats, of which text readers take the lower one.
  EXPECT_EQ(value("between"), inlined(8, float_payload(1.29999983f)));
  EXPECT_EQ(value("whole"), inlined(9, float_payload(0.5f)));
  EXPECT_EQ(file.get_at<double>(CrateFile::payload(value("fine"))), 0.1);
  EXPECT_EQ(value("fine") >> 48, 9u);
  EXPECT_EQ(value("i"), inlined(3, 0xfffffffe));
  EXPECT_EQ(value("one"), inlined(1, 1));
  EXPECT_EQ(value("yes"), inlined(1, 1));
  EXPECT_EQ(file.rep("/a.yes", "variability"), inlined(44, 1));
  EXPECT_EQ(value("small"), inlined(24, 0x7ffe01));
  EXPECT_EQ(value("half") >> 48, 24u);
  EXPECT_EQ(file.get_at<float>(CrateFile::payload(value("half")) + 4), 0.5f);
  EXPECT_EQ(value("large") >> 48, 24u);
  EXPECT_EQ(value("scaling"), inlined(15, 0x01fefefe));
  EXPECT_EQ(value("moved") >> 48, 15u);
  EXPECT_EQ(file.get_at<double>(CrateFile::payload(value("moved")) + 12 * 8), 3);
  EXPECT_EQ(value("fraction") >> 48, 15u);
  EXPECT_EQ(file.array<float>(value("turn"), 4), (std::vector<float>{1, 2, 3, 0.5f}));
  EXPECT_EQ(file.array<uint16_t>(value("halves"), 4),
            (std::vector<uint16_t>{0x3c00, 0x4000, 0x4200, 0x3800}));
  EXPECT_EQ(value("empty"), uint64_t{1} << 63 | uint64_t{24} << 48);
  EXPECT_EQ(file.array<float>(value("box"), 3),
            (std::vector<float>{FLT_MAX, FLT_MAX, FLT_MAX, 0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(value("many") >> 61, 5u) << "compressed";
  EXPECT_EQ(file.integers(value("many")), many);
  EXPECT_EQ(CrateFile::payload(value("box")) % 8, 0u) << "arrays can be mapped";
  EXPECT_FALSE(file.has("/a.declared", "default"));
  EXPECT_EQ(file.rep("/a.d", "custom"), inlined(1, 1));
  EXPECT_EQ(file.token("/a.p", "interpolation"), "vertex");
  EXPECT_EQ(file.rep("/a.p", "elementSize"), inlined(3, 5));
  EXPECT_EQ(file.token("/a.file", "default"), "./b.vdb");
  EXPECT_EQ(file.string(CrateFile::payload(value("text"))), "two words");
}

class UsdcFile : public testing::Test {
 protected:
  CrateFile file_of(const Assembly& assembly, const FormatOptions& options = {}) {
    write(format("usdc"), assembly, {}, path_, options);
    return CrateFile(read_text(path_));
  }
  /// The paths of a relationship or a connection.
  static std::vector<std::string> targets(const CrateFile& file, uint64_t rep) {
    std::vector<std::string> out;
    for (const std::string& each : file.list(rep, 3, 4)) {
      uint32_t index = 0;
      std::memcpy(&index, each.data(), 4);
      out.push_back(file.paths.at(index));
    }
    return out;
  }
  const ScratchFolder scratch_{"vug_usdc"};
  const std::filesystem::path path_ = scratch_.path() / "a.usdc";
};

TEST_F(UsdcFile, HasThePrimsOfTheText) {
  Assembly all = sample();
  all.prototypes[0].mesh = two_rocks(*all.prototypes[0].mesh);
  CrateFile file = file_of(all);
  write(format("usda"), all, {}, scratch_.path() / "a.usda");
  const std::string text = read_text(scratch_.path() / "a.usda");
  std::map<std::string, int> by_type, in_text;
  for (const auto& [path, spec] : file.specs)
    if (spec.type == 6) ++by_type[file.token(path, "typeName")];
  for (size_t at = text.find("def "); at != std::string::npos; at = text.find("def ", at + 1))
    ++in_text[text.substr(at + 4, text.find(' ', at + 4) - at - 4)];
  EXPECT_EQ(by_type, in_text);
  EXPECT_EQ(targets(file, file.rep("/sample/cube/mesh.material:binding", "targetPaths")),
            std::vector<std::string>{"/sample/materials/rock"});
  EXPECT_EQ(targets(file, file.rep("/sample/materials/rock.outputs:surface", "connectionPaths")),
            std::vector<std::string>{"/sample/materials/rock/surface.outputs:surface"});
  const mesh::Mesh& cube = *all.prototypes[0].mesh;
  const std::vector<float> points =
      file.array<float>(file.rep("/sample/cube/mesh.points", "default"), 3);
  ASSERT_EQ(points.size(), 3 * cube.positions.size());
  for (size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i], cube.positions[i / 3][static_cast<int>(i % 3)]);
  const std::vector<int32_t> indices =
      file.integers(file.rep("/sample/cube/mesh.faceVertexIndices", "default"));
  ASSERT_EQ(indices.size(), 3 * cube.triangles.size());
  for (size_t i = 0; i < indices.size(); ++i)
    EXPECT_EQ(static_cast<uint32_t>(indices[i]), cube.triangles[i / 3][i % 3]);
  // The second use of the mesh is a reference to the first one, without a file.
  const std::vector<std::string> references =
      file.list(file.rep("/sample/strewn/Prototypes/mesh", "references"), 32, 32);
  ASSERT_EQ(references.size(), 1u);
  uint32_t indices_of[2];
  std::memcpy(indices_of, references[0].data(), 8);
  EXPECT_EQ(file.string(indices_of[0]), "");
  EXPECT_EQ(file.paths.at(indices_of[1]), "/sample/cube/mesh");
}

TEST_F(UsdcFile, LevelsAreVariants) {
  Assembly all = sample();
  all.prototypes[0].coarser.push_back({all.prototypes[0].mesh, 0.25});
  const CrateFile file = file_of(all);
  const std::string mesh = "/sample/cube/mesh";
  EXPECT_EQ(file.specs.at(mesh + "{levelOfDetail=}").type, 11);
  EXPECT_EQ(file.specs.at(mesh + "{levelOfDetail=lod1}").type, 10);
  EXPECT_EQ(file.token_vector(file.rep(mesh, "variantSetChildren")),
            std::vector<std::string>{"levelOfDetail"});
  EXPECT_EQ(file.token_vector(file.rep(mesh + "{levelOfDetail=}", "variantChildren")),
            (std::vector<std::string>{"full", "lod1"}));
  EXPECT_EQ(file.rep(mesh + "{levelOfDetail=lod1}.vug:distance", "default"),
            inlined(9, float_payload(0.25f)));
  EXPECT_EQ(file.token(mesh + "{levelOfDetail=full}shape", "typeName"), "Mesh");
  const uint64_t selection = CrateFile::payload(file.rep(mesh, "variantSelection"));
  EXPECT_EQ(file.get_at<uint64_t>(selection), 1u);
  EXPECT_EQ(file.string(file.get_at<uint32_t>(selection + 8)), "levelOfDetail");
  EXPECT_EQ(file.string(file.get_at<uint32_t>(selection + 12)), "full");
  // The levels have equal meshes here, which are stored once.
  EXPECT_EQ(file.rep(mesh + "{levelOfDetail=full}shape.points", "default"),
            file.rep(mesh + "{levelOfDetail=lod1}shape.points", "default"));
}

TEST_F(UsdcFile, TilesArePayloads) {
  const mesh::Mesh hull = mesh::box_mesh(Box3d(Vec3d(0.25), Vec3d(0.5)));
  const Box3d box(Vec3d(0.0), Vec3d(1.0));
  write_usd_tiles("cave", {{"t", box, {{"t.usdc", 0}, {"t_lod1.usdc", 0.125}}, hull}},
                  {"r", 7, 1, "0"}, path_);
  const CrateFile file(read_text(path_));
  const std::vector<std::string> payloads =
      file.list(file.rep("/cave/t{levelOfDetail=lod1}", "payload"), 32, 24);
  ASSERT_EQ(payloads.size(), 1u);
  uint32_t indices[2];
  std::memcpy(indices, payloads[0].data(), 8);
  EXPECT_EQ(file.string(indices[0]), "./t_lod1.usdc");
  EXPECT_EQ(file.paths.at(indices[1]), "") << "the default prim";
  double time[2];
  std::memcpy(time, payloads[0].data() + 8, 16);
  EXPECT_EQ(time[0], 0);
  EXPECT_EQ(time[1], 1);
  write_usd_tile(hull, {"r", 7, 1, "0"}, path_);
  EXPECT_EQ(CrateFile(read_text(path_)).token("/tile/shape.purpose", "default"), "render");
}

TEST_F(UsdcFile, TheProvenanceIsReadBack) {
  file_of(sample());
  const std::string bytes = read_text(path_);
  const Format& usdc = format("usdc");
  const auto found = usdc.read_metadata(bytes, "a.usdc");
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"vug:recipe", "seed 7\n# a \"recipe\"\n"}, {"vug:seed", "7"}, {"vug:version", "0"}};
  EXPECT_EQ(found, expected);
  EXPECT_EQ(read_metadata(path_), expected);
  for (size_t left = 0; left < bytes.size(); left += 1 + left / 50)
    EXPECT_THROW(usdc.read_metadata(bytes.substr(0, left), "a.usdc"), Error) << left;
  // A damaged byte gives another text or an error with the name of the file.
  for (size_t at = 0; at < bytes.size(); at += at < 88 ? 1 : 7)
    for (const int change : {1, 128}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      try {
        usdc.read_metadata(damaged, "a.usdc");
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        EXPECT_EQ(error.where().file, "a.usdc");
      }
    }
}

TEST_F(UsdcFile, VariantsShareEqualArrays) {
  Assembly all = sample();
  mesh::Mesh sphere = mesh::sphere_mesh({0, 0, 0}, 1, 5);
  all.prototypes[0].mesh = std::make_shared<const mesh::Mesh>(std::move(sphere));
  file_of(all);
  const size_t alone = std::filesystem::file_size(path_);
  Assembly wet = all;
  wet.prototypes[0].look.thin = true;  // the same mesh in another prim
  FormatOptions options;
  options.variants.push_back({"wet", std::make_shared<const Assembly>(wet)});
  const CrateFile file = file_of(all, options);
  EXPECT_LT(std::filesystem::file_size(path_), alone + 10000);
  EXPECT_TRUE(file.has("/sample{variant=wet}cube/mesh.doubleSided", "default"));
  EXPECT_FALSE(file.has("/sample{variant=default}cube/mesh.doubleSided", "default"));
}

TEST_F(UsdcFile, FilesAreCompleteOrAbsent) {
  file_of(sample());
  const std::string before = read_text(path_);
  file_of(sample());
  EXPECT_EQ(before, read_text(path_));
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(write(format("usdc"), sample(), {}, path_, {}, cancelled), Error);
  EXPECT_EQ(before, read_text(path_));
  Assembly zero = sample();
  zero.provenance.recipe += '\0';
  EXPECT_THROW(write(format("usdc"), zero, {}, path_), Error);
  EXPECT_EQ(before, read_text(path_));
  std::filesystem::create_directories(scratch_.path() / "b.usdc");
  EXPECT_THROW(write(format("usdc"), sample(), {}, scratch_.path() / "b.usdc"), Error);
}

TEST(Programs, HaveBinaryFormatsOfUsd) {
  EXPECT_EQ(with_usd_format(program("maya"), "usdc").formats, std::vector<std::string>{"usdc"});
  EXPECT_EQ(with_usd_format(program("maya"), "usda").formats, program("maya").formats);
  EXPECT_THROW(with_usd_format(program("blender"), "usdc"), Error);
  EXPECT_THROW(with_usd_format(program("usd"), "glb"), Error);
}

}  // namespace
}  // namespace vug::exchange
