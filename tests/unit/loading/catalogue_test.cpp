// SPDX-License-Identifier: Apache-2.0
// The catalogue of `vug list` matches what a scene may contain.
#include <gtest/gtest.h>
#include <vug/loading/catalogue.h>
#include <vug/loading/resolver.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace vug::loading {
namespace {

const KindInfo& declaration(const std::string& name) {
  for (const KindInfo* kind : find_kinds("declaration"))
    if (kind->name == name) return *kind;
  throw Error(ErrorCode::internal, "no declaration " + name);
}

const ParamInfo* find_param(const KindInfo& kind, const std::string& name) {
  for (const ParamInfo& param : kind.params)
    if (param.name == name) return &param;
  return nullptr;
}

Dimension dimension_of(const Value& value) {
  if (const Number* n = value.get<Number>()) return n->dimension;
  if (const auto* v = value.get<Value::Vector>()) return v->dimension;
  if (const List* list = value.get<List>(); list && !list->empty())
    return dimension_of(list->front());
  return Dimension::none;
}

bool is_zero(const Value& value) {
  if (const List* list = value.get<List>()) return std::all_of(list->begin(), list->end(), is_zero);
  if (const Number* n = value.get<Number>()) return n->value == 0;
  if (const auto* v = value.get<Value::Vector>()) return v->value == Vec3d(0);
  return false;
}

TEST(Catalogue, DefaultsAreSceneTextInTheUnitOfTheirDimension) {
  int numbers = 0;
  for (const KindInfo* kind : find_kinds())
    for (const ParamInfo& param : kind->params) {
      if (param.fallback.empty() || param.dimension == Dimension::none) continue;
      SCOPED_TRACE(kind->name + " " + param.name + " " + param.fallback);
      Diagnostics diagnostics;
      const scene::Document document =
          scene::parse("let x = " + param.fallback + "\n", "t", diagnostics);
      ASSERT_TRUE(diagnostics.all().empty());
      Resolver resolver;
      scene::Evaluator evaluator(document, resolver, diagnostics);
      const Value value = evaluator.eval(*document.lets.at(0).value, RandomKey(0));
      ASSERT_TRUE(diagnostics.all().empty());
      if (!is_zero(value)) {
        EXPECT_EQ(dimension_of(value), param.dimension);
      }
      ++numbers;
    }
  EXPECT_GT(numbers, 30);
}

TEST(Catalogue, DefaultsThatAreObjectsHaveASpelling) {
  for (const KindInfo* kind : find_kinds())
    for (const ParamInfo& param : kind->params)
      EXPECT_EQ(param.fallback.find('<'), std::string::npos) << kind->name << " " << param.name;
  EXPECT_EQ(describe(*find_param(*find_kinds("displace").at(0), "noise")), "noise, default fbm");
}

TEST(Catalogue, TheWordOfADeclarationFindsItsKinds) {
  for (const KindRegistry& registry : kind_registries()) {
    const std::vector<const KindInfo*> found = find_kinds(registry.type);
    for (const RegisteredKind& kind : registry.kinds)
      EXPECT_EQ(std::count(found.begin(), found.end(), kind.info), 1)
          << registry.type << " " << kind.info->name;
  }
  const std::vector<const KindInfo*> materials = find_kinds("material");
  ASSERT_GE(materials.size(), 3u);
  EXPECT_EQ(materials.front()->category, "declaration");
}

TEST(Catalogue, MeasuresOfPicturesAreListed) {
  const std::vector<const KindInfo*> measures = find_kinds("measure");
  EXPECT_GE(measures.size(), 9u);
  for (const KindInfo* kind : measures) EXPECT_FALSE(kind->doc.empty()) << kind->name;
}

TEST(Catalogue, AnglesAreInDegrees) {
  const ParamInfo& fov = *find_param(*find_kinds("perspective").at(0), "fov");
  EXPECT_EQ(fov.fallback, "60deg");
  EXPECT_EQ(describe(fov),
            "number (angle), at least 5.72958e-05deg, at most 177.617deg, default 60deg");
  const auto all = catalogue_json(find_kinds("perspective"));
  const auto& params = all.at(0).at("params");
  const auto found = std::find_if(params.begin(), params.end(),
                                  [](const auto& param) { return param.at("name") == "fov"; });
  ASSERT_NE(found, params.end());
  const auto& json = *found;
  EXPECT_EQ(json.at("default"), "60deg");
  EXPECT_EQ(json.at("unit"), "rad");
  EXPECT_EQ(json.at("max"), 3.1);
}

TEST(Catalogue, DeclarationsHaveParameters) {
  for (const KindInfo* kind : find_kinds("declaration")) {
    EXPECT_FALSE(kind->params.empty()) << kind->name;
    for (const ParamInfo& param : kind->params) EXPECT_FALSE(param.doc.empty()) << param.name;
  }
  const KindInfo& camera = declaration("camera");
  for (const char* name : {"kind", "eye", "target", "up", "fov", "aperture", "focus"})
    EXPECT_TRUE(find_param(camera, name)) << name;
  EXPECT_EQ(describe(*find_param(camera, "kind")),
            "one of orthographic, panoramic, perspective, default perspective");
  EXPECT_TRUE(find_param(declaration("volume"), "voxel"));
  EXPECT_TRUE(find_param(declaration("material"), "albedo"));
  EXPECT_TRUE(find_param(declaration("render"), "spp"));
  const std::vector<std::string>& lights = find_param(declaration("light"), "kind")->choices;
  EXPECT_TRUE(std::find(lights.begin(), lights.end(), "rect") != lights.end());
  EXPECT_TRUE(find_param(declaration("light"), "kind")->required);
  EXPECT_TRUE(find_param(declaration("grammar"), "overlap"));
}

}  // namespace
}  // namespace vug::loading
