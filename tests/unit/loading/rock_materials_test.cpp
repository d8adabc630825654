// SPDX-License-Identifier: Apache-2.0
// Materials of rock in scenes: names that nothing has, conflicts, and the geology of grammars.
#include <vug/field/field.h>
#include <vug/loading/load.h>

#include <gtest/gtest.h>

namespace vug::loading {
namespace {

Loaded load_rocks(const std::string& text) { return load_text(text, "rocks.vug"); }

const std::string kRock =
    "volume rock = level_set(made_of(sphere(1m), of: \"limestone\"), voxel: 20cm)\n";

/// The report of a scene of limestone whose wall has a table of materials.
std::string report_with(const std::string& table, bool usable) {
  const Loaded loaded = load_rocks(kRock + "material m = by rock { " + table +
                                   " }\nmesh wall on rock {}\nobject o on wall { material m }\n");
  EXPECT_EQ(loaded.usable(), usable) << table;
  return loaded.report();
}

TEST(RockMaterials, ANameThatNoRockHasIsAnError) {
  EXPECT_EQ(report_with("limestone -> lambert()", true), "");
  const std::string wrong = report_with("limestone -> lambert(), limestoen -> coated()", false);
  EXPECT_NE(wrong.find("no rock is made of 'limestoen'"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("'limestone'"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("rocks.vug:2:48"), std::string::npos) << wrong;
  const std::string far = report_with("limestone -> lambert(), clay -> coated()", false);
  EXPECT_NE(far.find("the rocks of the scene are limestone"), std::string::npos) << far;
}

TEST(RockMaterials, ATextThatOnlyDeclaresMaterialsIsUsable) {
  const Loaded loaded = load_rocks("material m = by rock { limestone -> lambert() }\n");
  EXPECT_TRUE(loaded.usable());
  EXPECT_NE(loaded.report().find("no rock is made of 'limestone'"), std::string::npos);
}

TEST(RockMaterials, ARockWithoutAMaterialIsAnError) {
  const std::string two =
      "volume rock = level_set(host_rock(sphere(1m), of: \"limestone\", "
      "bodies: [made_of(slab(thickness: 20cm), of: \"clay\")]), voxel: 20cm)\n"
      "mesh wall on rock {}\n";
  const Loaded missing =
      load_rocks(two + "object o on wall { material by rock { limestone -> lambert() } }\n");
  EXPECT_FALSE(missing.usable());
  EXPECT_NE(missing.report().find("'o' has no material for its rock 'clay'"), std::string::npos)
      << missing.report();
  EXPECT_NE(missing.report().find("rocks.vug:3:29"), std::string::npos) << missing.report();
  EXPECT_NE(missing.report().find("'clay -> MATERIAL'"), std::string::npos) << missing.report();
  for (const char* table : {"limestone -> lambert(), clay -> coated()",
                            "limestone -> lambert(), otherwise -> coated()"}) {
    const Loaded complete =
        load_rocks(two + "object o on wall { material by rock { " + table + " } }\n");
    EXPECT_EQ(complete.report(), "") << table;
  }
}

TEST(RockMaterials, TwoHardnessesOfOneNameAreAnError) {
  const auto report = [](const std::string& host, const std::string& bed) {
    return load_rocks("let bed = made_of(slab(thickness: 20cm), of: " + bed +
                      ")\nvolume rock = level_set(host_rock(sphere(1m), of: " + host +
                      ", bodies: [bed]), voxel: 20cm)\n")
        .report();
  };
  const auto material = [](const std::string& name, int percent) {
    return "rock_material(name: \"" + name + "\", hardness: " + std::to_string(percent) + "%)";
  };
  EXPECT_EQ(report(material("a", 20), material("a", 20)), "");
  EXPECT_EQ(report(material("a", 20), material("b", 90)), "");
  const std::string two = report(material("a", 20), material("a", 90));
  EXPECT_NE(two.find("'a' of 'rock' has two hardnesses, 20 % and 90 %"), std::string::npos) << two;
  EXPECT_NE(two.find("rocks.vug:2:51: error"), std::string::npos) << two;
  const std::string text = report("\"a\"", material("a", 90));
  EXPECT_NE(text.find("two hardnesses, 0 % and 90 %"), std::string::npos) << text;
}

TEST(RockMaterials, AMaterialThatDoesNotExistIsAnError) {
  const std::string missing = report_with("limestone -> limestome_grey", false);
  EXPECT_NE(missing.find("limestome_grey"), std::string::npos) << missing;
  EXPECT_NE(missing.find("rocks.vug:2:37"), std::string::npos) << missing;
}

TEST(RockMaterials, MasksKnowTheirAttributes) {
  const std::string paint =
      "mesh wall on rock { paint layer(under: (0, 0, 0), over: (1, 1, 1), mask: ";
  EXPECT_EQ(load_rocks(kRock + paint + "attribute(name: \"w_limestone\")) }\n").report(), "");
  EXPECT_NE(load_rocks(kRock + paint + "attribute(name: \"w_clay\")) }\n").report(), "");
}

TEST(RockMaterials, LabelsMustNotHaveTheNamesOfWeights) {
  const Loaded loaded = load_rocks(
      kRock + "mesh wall on rock { labels [label(name: \"w_limestone\", field: sphere(1m))] }\n");
  EXPECT_FALSE(loaded.usable());
  EXPECT_NE(loaded.report().find("'w_limestone'"), std::string::npos);
}

TEST(RockMaterials, TheGeologyOfAGrammarLimitsItsMorphs) {
  const auto value = [](const std::string& option) {
    const Loaded loaded = load_rocks("grammar cave {\n  " + option +
                                     "\n  axiom + sphere(1m) ~ 50% box(size: (3, 1, 1))\n}\n"
                                     "volume rock = level_set(cave, voxel: 20cm)\n");
    EXPECT_TRUE(loaded.usable()) << loaded.report();
    return loaded.shot.derivations.at(0).productions == 2
               ? loaded.shot.volumes.at(0)->field.bounds().size().x
               : 0;
  };
  const auto made_of = [](const std::string& hardness) {
    return "geology made_of(box(size: (9, 9, 9)), of: rock_material(name: \"marl\", hardness: " +
           hardness + "))";
  };
  EXPECT_EQ(value(made_of("0%")), value(""));
  const Loaded missing = load_rocks(
      "grammar cave {\n  geology sphere(1m)\n  axiom + sphere(1m)\n}\n"
      "volume rock = level_set(cave, voxel: 20cm)\n");
  EXPECT_FALSE(missing.usable());
  EXPECT_NE(missing.report().find("the solid of 'geology' has no materials"), std::string::npos);
  EXPECT_NE(missing.report().find("made_of"), std::string::npos);
  // A hardness of 1 leaves no morph: the cave is the sphere.
  EXPECT_LT(value(made_of("100%")), value("") - 0.1);
}

TEST(RockMaterials, FaultsPointAtTheirLine) {
  const Loaded loaded = load_rocks(
      "field f = made_of(sphere(1m), of: \"hard rock\")\n"
      "field g = host_rock(sphere(1m), of: \"clay\", bodies: [sphere(50cm)])\n");
  EXPECT_FALSE(loaded.usable());
  EXPECT_NE(loaded.report().find("rocks.vug:1:11"), std::string::npos) << loaded.report();
  EXPECT_NE(loaded.report().find("rocks.vug:2:11"), std::string::npos);
  EXPECT_NE(loaded.report().find("letters, digits and '_'"), std::string::npos);
}

}  // namespace
}  // namespace vug::loading
