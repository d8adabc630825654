// SPDX-License-Identifier: Apache-2.0
// `topology` of a mesh: what it removes, and what is reported.
#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>
#include <vug/mesh/topology.h>

namespace vug::building {
namespace {

struct CleanMesh {
  mesh::Mesh mesh;
  std::vector<volume::SmallFeature> small;
  std::string warning;
};

CleanMesh clean_mesh(const std::string& solid, const std::string& entries, int threads = 0) {
  const loading::Loaded loaded =
      loading::load_text("volume rock = level_set(" + solid +
                             ", voxel: 10cm)\nmesh wall on rock { " + entries + " }\n",
                         "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  CleanMesh out;
  BuildOptions options;
  options.on_warning = [&](const Diagnostics& warnings) {
    for (const Diagnostic& each : warnings.all()) out.warning += each.message + "; " + each.hint;
  };
  Builder builder(loaded.shot, options);
  const shot::MeshPtr plan = loaded.shot.meshes.at(0);
  EXPECT_TRUE(builder.small_features(plan).empty()) << "before it is made";
  out.mesh = *with_threads(threads, [&] { return builder.mesh(plan); });
  out.small = builder.small_features(plan);
  return out;
}

const std::string kPore = "sphere(1m) - sphere(6cm).translate((30cm, 20cm, 10cm))";

TEST(Topology, IsCleanByDefault) {
  const CleanMesh clean = clean_mesh(kPore, "");
  EXPECT_EQ(mesh::inspect(clean.mesh).components, 1U);
  EXPECT_EQ(clean.small.size(), 1U);
  EXPECT_EQ(clean.warning, "");
  EXPECT_EQ(clean.mesh, clean_mesh("sphere(1m)", "").mesh);
  EXPECT_EQ(clean.mesh, clean_mesh(kPore, "topology clean").mesh);
}

TEST(Topology, KeepWarnsWithThePlace) {
  const CleanMesh all = clean_mesh(kPore, "topology keep");
  EXPECT_EQ(mesh::inspect(all.mesh).components, 2U);
  EXPECT_EQ(all.warning,
            "the mesh 'wall' has features smaller than two voxels: 1 bubble, at (0.3, 0.2, 0.1); "
            "topology clean removes them");
}

TEST(Topology, IsTheSameForAnyNumberOfThreads) {
  const std::string fork =
      "capsule(a: (0, 0, 0), b: (1, 2.3, 0.4), radius: 0.3) + "
      "capsule(a: (0, 0, 0), b: (0, 2.4, 0.2), radius: 0.3)";
  const CleanMesh one = clean_mesh(fork, "", 1);
  for (const int threads : {2, 5, 8})
    EXPECT_EQ(one.mesh, clean_mesh(fork, "", threads).mesh) << threads;
}

}  // namespace
}  // namespace vug::building
