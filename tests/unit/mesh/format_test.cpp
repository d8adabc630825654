// SPDX-License-Identifier: Apache-2.0
// Properties of every mesh format, in a loop over the registry.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/mesh/format.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/shapes.h>
#include <vug/mesh/topology.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace vug::mesh {
namespace {

std::string written(const Format& format, const Mesh& mesh) {
  std::string bytes;
  format.write(mesh, {}, [&](std::string_view more) { bytes += more; });
  return bytes;
}

Mesh painted_torus() {
  Mesh mesh = torus_mesh(2.1, 0.7, 31, 17);
  mesh.normals = vertex_normals(mesh);
  Attribute colour{std::string(kColour), 3, {}};
  for (const Vec3f& p : mesh.positions) colour.values.insert(colour.values.end(), {p.x, p.y, p.z});
  mesh.attributes.push_back(colour);
  return mesh;
}

TEST(Format, TorusSurvivesEveryFormat) {
  const Mesh mesh = painted_torus();
  for (const Format* format : formats()) {
    SCOPED_TRACE(format->info.name);
    const Mesh again = format->read(written(*format, mesh), "memory");
    EXPECT_NO_THROW(validate(again, "memory"));
    EXPECT_EQ(again.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(again.positions.size(), mesh.positions.size());
    EXPECT_EQ(bounds(again), bounds(mesh));
    const Topology topology = inspect(again);
    EXPECT_TRUE(topology.closed());
    EXPECT_EQ(topology.genus, 1U);
    // A file that was read is written again with the same bytes.
    EXPECT_EQ(written(*format, again), written(*format, format->read(written(*format, again), "")));
    if (format->info.name != "stl") {
      EXPECT_EQ(again, mesh);
    }
  }
}

TEST(Format, MeshesWithoutNormalsAndAttributesSurvive) {
  const Mesh mesh = box_mesh({Vec3d(-1), Vec3d(1e-3, 1e6, 1)});
  for (const Format* format : formats()) {
    SCOPED_TRACE(format->info.name);
    const Mesh again = format->read(written(*format, mesh), "memory");
    EXPECT_EQ(again.triangles.size(), 12U);
    EXPECT_EQ(bounds(again), bounds(mesh));
    EXPECT_TRUE(again.normals.empty());
    EXPECT_TRUE(again.attributes.empty());
  }
}

// Either the truncation is detected, or the result is a valid mesh with at most the same content.
TEST(Format, TruncatedFilesAreRefusedOrSmaller) {
  const Mesh mesh = painted_torus();
  for (const Format* format : formats()) {
    SCOPED_TRACE(format->info.name);
    const std::string bytes = written(*format, mesh);
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
      const std::string cut = bytes.substr(0, bytes.size() * static_cast<size_t>(i) / 200);
      try {
        const Mesh rest = format->read(cut, "cut");
        EXPECT_NO_THROW(validate(rest, "cut"));
        EXPECT_LE(rest.triangles.size(), mesh.triangles.size());
      } catch (const Error& error) {
        ++refused;
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        EXPECT_EQ(error.where().file, "cut");
        EXPECT_FALSE(error.hint().empty() && i > 0) << error.what();
      }
    }
    // OBJ lines have no count, so most truncations are undetectable.
    EXPECT_GE(refused, format->info.name == "obj" ? 1 : 200);
  }
}

TEST(Format, DamagedFilesAreRefusedOrValid) {
  const Mesh mesh = painted_torus();
  for (const Format* format : formats()) {
    SCOPED_TRACE(format->info.name);
    const std::string bytes = written(*format, mesh);
    RandomStream random(RandomKey(7).at(format->info.name));
    for (int trial = 0; trial < 300; ++trial) {
      std::string damaged = bytes;
      for (int i = 0; i < 8; ++i)
        damaged[random.below(trial % 2 ? 300U : static_cast<uint32_t>(bytes.size()))] =
            static_cast<char>(random.below(256));
      try {
        const Mesh rest = format->read(damaged, "damaged");
        EXPECT_NO_THROW(validate(rest, "damaged"));
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
      }
    }
  }
}

TEST(Format, GarbageIsRefusedByName) {
  for (const Format* format : formats()) {
    SCOPED_TRACE(format->info.name);
    for (const std::string& garbage :
         {std::string(),
          std::string("\x7f"
                      "ELF\x02\x01\x01"),
          std::string(1000, '\0'), std::string("<!DOCTYPE html>\n<html></html>\n")}) {
      try {
        format->read(garbage, "garbage");
        ADD_FAILURE() << "read " << garbage.size() << " bytes of garbage";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        EXPECT_EQ(error.where().file, "garbage");
      }
    }
  }
}

TEST(Format, ExtensionsMatchInAnyCase) {
  const ScratchFolder scratch("vug_format");
  const auto& folder = scratch.path();
  const Mesh mesh = box_mesh({Vec3d(0), Vec3d(1)});
  for (const Format* format : formats()) {
    std::string name = "box." + format->info.name;
    write_mesh(mesh, folder / name);
    EXPECT_EQ(read_mesh(folder / name).triangles.size(), 12U);
    EXPECT_EQ(read_text(folder / name), written(*format, mesh));
    name.back() = static_cast<char>(name.back() - 'a' + 'A');
    EXPECT_EQ(&format_of(name), format);
  }
  EXPECT_THROW(read_mesh(folder / "box.blend"), Error);
  EXPECT_THROW(read_mesh(folder / "nothing.ply"), Error);
}

TEST(Format, OnlyFiniteValuesAreWritten) {
  Mesh mesh = box_mesh({Vec3d(0), Vec3d(1)});
  mesh.positions[3].z = std::numeric_limits<float>::infinity();
  const ScratchFolder scratch("vug_format");
  const auto file = scratch.file("inf.ply");
  EXPECT_THROW(write_mesh(mesh, file), Error);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace vug::mesh
