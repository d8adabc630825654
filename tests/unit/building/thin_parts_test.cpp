// SPDX-License-Identifier: Apache-2.0
// Warnings about parts of a solid that are thinner than a voxel.
#include <gtest/gtest.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>

namespace vug::building {
namespace {

std::vector<Diagnostic> thin_warnings(const std::string& solid, const std::string& before = "",
                                      const std::string& voxel = "10cm") {
  const loading::Loaded loaded = loading::load_text(
      before + "volume rock = level_set(" + solid + ", voxel: " + voxel + ")\n", "t.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  std::vector<Diagnostic> found;
  BuildOptions options;
  options.on_warning = [&](const Diagnostics& warnings) {
    for (const Diagnostic& each : warnings.all())
      if (each.message.find("thick at") != std::string::npos ||
          each.message.find("thinner than its voxels") != std::string::npos)
        found.push_back(each);
  };
  options.where_of = [&](const field::NodePtr& node) {
    const scene::Provenance* made = loaded.provenance.find(node);
    return made ? made->where : SourceLocation();
  };
  Builder builder(loaded.shot, options);
  builder.level_set(loaded.shot.volumes.at(0));
  return found;
}

TEST(ThinParts, APlateIsReportedWithNameAndPlaceAnywhereOnTheLattice) {
  for (const char* height : {"0m", "1.53m", "-2.05m"}) {
    const auto found = thin_warnings(
        std::string("sphere(1m).translate((4, 0, 0)) + box((2, 1mm, 2)).translate((0, ") + height +
        ", 0))");
    ASSERT_EQ(found.size(), 1U) << height;
    EXPECT_NE(found[0].message.find("the box in the volume 'rock' is 0.001 m thick at (0, "),
              std::string::npos)
        << found[0].message;
    EXPECT_EQ(found[0].hint, "use voxels of at most 0.0005 m, or a thicker solid");
    EXPECT_EQ(found[0].where.line, 1);
    EXPECT_GT(found[0].where.column, 26) << "the box, not the volume";
  }
}

TEST(ThinParts, AllShapesAreMeasuredInAnyOrientation) {
  for (const char* shape :
       {"box((2, 2, 3cm))", "cylinder(radius: 1m, height: 2cm)", "cylinder(radius: 2cm, height: 3)",
        "capsule(radius: 2cm, a: (0, 0, 0), b: (1, 2, 1))", "torus(radius: 1m, tube: 3cm)",
        "prism(radius: 1m, height: 2cm)", "(slab(thickness: 5cm) & sphere(2m))",
        "sphere(10cm).scale(0.2)", "shell(sphere(1m), thickness: 2cm)",
        "shell(box((1, 1, 1)) + sphere(80cm), thickness: 5cm)"}) {
    EXPECT_EQ(thin_warnings(std::string("sphere(1m).translate((9, 0, 0)) + ") + shape +
                            ".rotate(axis: (1, 2, 3), angle: 40deg)")
                  .size(),
              1U)
        << shape;
  }
}

TEST(ThinParts, ThickSolidsCutsAndEmbeddedPartsAreNot) {
  for (const char* solid : {
           "sphere(1m) + box((2, 12cm, 2))",
           "sphere(1m) - box((3, 1mm, 3))",
           "sphere(1m) + box((50cm, 1mm, 50cm))",
           "torus(radius: 1m, tube: 20cm)",
           "shell(sphere(1m), thickness: 12cm)",
       })
    EXPECT_EQ(thin_warnings(solid).size(), 0U) << solid;
}

TEST(ThinParts, NarrowPassagesAreReportedWithTheirShare) {
  const std::string plan =
      "network plan = graph(names: [\"a\", \"b\", \"c\"], at: [(0, 0, 0), (8, 0, 0), (16, 0, 0)], "
      "paths: [\"a b c\"], widths: [WIDTHS], heights: [1m, 1m, 1m])\n";
  const auto warnings = [&](const std::string& widths, const std::string& solid) {
    std::string text = plan;
    text.replace(text.find("WIDTHS"), 6, widths);
    return thin_warnings(solid, text, "50cm");
  };
  for (const char* solid :
       {"passages(of: plan, smooth: false)",
        "box((30, 9, 9)).translate((8, 0, 0)) - passages(of: plan, smooth: false)",
        "displace(complement(passages(of: plan, smooth: false)), noise: fbm(), "
        "amount: 1cm) & box((30, 9, 9)).translate((8, 0, 0))"}) {
    const auto found = warnings("1m, 1m, 4cm", solid);
    ASSERT_EQ(found.size(), 1U) << solid;
    EXPECT_NE(found[0].message.find("of the length of the passages in the volume 'rock'"),
              std::string::npos)
        << found[0].message;
    EXPECT_NE(found[0].message.find("0.3 m at (16"), std::string::npos) << found[0].message;
    EXPECT_NE(found[0].hint.find("'least_width'"), std::string::npos);
    EXPECT_EQ(warnings("1m, 1m, 80cm", solid).size(), 0U) << solid;
  }
}

TEST(ThinParts, AreReportedBeforeTheVoxelsAreMade) {
  const loading::Loaded loaded =
      loading::load_text("volume plate = level_set(box((50, 1mm, 50)), voxel: 10cm)\n", "t.vug");
  bool warned = false, warned_before_voxels = false;
  Progress progress([&](const std::string& stage, double) {
    if (stage.find("voxels of") == 0) warned_before_voxels = warned;
  });
  BuildOptions options;
  options.on_warning = [&](const Diagnostics&) { warned = true; };
  Builder builder(loaded.shot, options, progress);
  builder.level_set(loaded.shot.volumes.at(0));
  EXPECT_TRUE(warned_before_voxels);
}

}  // namespace
}  // namespace vug::building
