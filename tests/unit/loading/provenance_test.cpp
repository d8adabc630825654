// SPDX-License-Identifier: Apache-2.0
// Fields and declarations report the text that made them, through includes, names and rules.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/load.h>

#include <algorithm>

namespace vug::loading {
namespace {

class Provenance : public testing::Test {
 protected:
  Loaded loaded(const std::string& text) {
    Loaded loaded = load_text(text, (folder_.path() / "cave.vug").generic_string());
    EXPECT_TRUE(loaded.usable()) << loaded.report();
    return loaded;
  }
  /// The description of the first node of that name in a volume's field, without the folder.
  std::string of_node(const Loaded& loaded, const std::string& name) {
    std::vector<field::NodePtr> nodes = {loaded.shot.volumes.at(0)->field.node()};
    for (size_t i = 0; i < nodes.size(); ++i) {
      const scene::Provenance* found = loaded.provenance.find(nodes[i]);
      if (!found) return "node without provenance: " + nodes[i]->name();
      if (nodes[i]->name() == name) return plain(loaded.provenance.describe(*found));
      for (const field::NodePtr& child : nodes[i]->children()) nodes.push_back(child);
    }
    return "no node " + name;
  }
  std::string plain(std::string text) const {
    const std::string folder = folder_.path().generic_string() + "/";
    for (size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
  }

  ScratchFolder folder_{"vug_provenance"};
};

TEST_F(Provenance, OfANodeThroughNamesAndIncludes) {
  write_text(folder_.path() / "parts.vug", "let ball = sphere(1m)\n");
  const Loaded made = loaded(
      "include \"parts.vug\"\n"
      "field both = union([ball, box(size: (1m, 1m, 1m))])\n"
      "volume rock = level_set(both, voxel: 20cm)\n");
  EXPECT_EQ(of_node(made, "sphere"),
            "parts.vug:1:12-1:22, in let 'ball' at parts.vug:1:5, included from cave.vug:1:9");
  EXPECT_EQ(of_node(made, "box"), "cave.vug:2:27-2:50, in field 'both' at cave.vug:2:7");
}

TEST_F(Provenance, OfASolidIncludesTheFunctionsThatWereCalled) {
  write_text(folder_.path() / "kit.vug", "def slab(at) =\n  box(size: (1, 1, 1)).translate(at)\n");
  const Loaded made = loaded(
      "include \"kit.vug\" as kit\n"
      "def pair(at) = kit.slab(at) + sphere(1m)\n"
      "volume rock = level_set(pair((0, 0, 0)), voxel: 20cm)\n");
  EXPECT_EQ(of_node(made, "box"),
            "kit.vug:2:3-2:23, in def 'kit.slab' at cave.vug:2:20, in def 'pair' at cave.vug:3:25, "
            "in volume 'rock' at cave.vug:3:8, included from cave.vug:1:9");
  EXPECT_EQ(of_node(made, "sphere"),
            "cave.vug:2:31-2:41, in def 'pair' at cave.vug:3:25, in volume 'rock' at cave.vug:3:8");
  ASSERT_NE(made.provenance.find("def", "kit.slab"), nullptr);
  EXPECT_EQ(plain(range_text(made.provenance.find("def", "kit.slab")->where)), "kit.vug:1:1-2:37");
}

TEST_F(Provenance, OfAShapeIsTheRuleThatMadeIt) {
  const Loaded made = loaded(
      "grammar cave {\n  axiom Room(2)\n  Room(n) -> + sphere(1m)\n}\n"
      "volume rock = level_set(cave, voxel: 20cm)\n");
  EXPECT_EQ(of_node(made, "sphere"),
            "cave.vug:3:16-3:26, in rule 'Room(2)' at cave.vug:3:14, in grammar 'cave' at "
            "cave.vug:5:25, in volume 'rock' at cave.vug:5:8");
  const ProvenanceTable::Declared* rule = made.provenance.find("rule", "cave/Room");
  ASSERT_NE(rule, nullptr);
  EXPECT_EQ(plain(range_text(rule->where)), "cave.vug:3:3-3:26");
  ASSERT_EQ(made.shot.derivations.size(), 1u);
  EXPECT_EQ(made.shot.derivations[0].tree.productions.back().where, rule->where);
}

TEST_F(Provenance, OfDeclarations) {
  const Loaded made =
      loaded("light lamp = sphere(center: (0, 3, 0))\ncamera main {\n  eye (0, 0, 4)\n}\n");
  ASSERT_EQ(made.provenance.declared().size(), 2u);
  EXPECT_EQ(plain(range_text(made.provenance.find("light", "lamp")->where)), "cave.vug:1:1-1:39");
  EXPECT_EQ(plain(range_text(made.provenance.find("camera", "main")->where)), "cave.vug:2:1-4:2");
  EXPECT_EQ(made.provenance.find("light", "main"), nullptr);
}

}  // namespace
}  // namespace vug::loading
