// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/carve.h>
#include <vug/facade/derive.h>
#include <vug/field/registry.h>
#include <vug/loading/facade_binding.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

struct FacadeBlock {
  double width = facade::DeriveOptions().width;
  double height = facade::DeriveOptions().height;
  double thickness = 0.6;
  Vec3d at{0, 0, 0};
  double yaw = 0;
  int steps = static_cast<int>(facade::DeriveOptions().limits.productions);
  int limit = static_cast<int>(facade::DeriveOptions().limits.symbols);
  std::optional<int> seed;

  static void describe(Schema<FacadeBlock>& s) {
    s.doc("A facade that rules subdivide: grammar NAME: facade { axiom ...  SYMBOL -> rows(...) }.")
        .cite("ripperda2009")
        .param("width", &FacadeBlock::width, positive_length("width of the whole facade"))
        .param("height", &FacadeBlock::height, positive_length("height of the whole facade"))
        .param("thickness", &FacadeBlock::thickness,
               positive_length("thickness of the wall into which a standalone facade is carved"))
        .param("at", &FacadeBlock::at, any_length("the centre of its base"))
        .param("yaw", &FacadeBlock::yaw,
               {.doc = "rotation about the vertical axis; at 0 it faces +z",
                .dimension = Dimension::angle})
        .param("steps", &FacadeBlock::steps, {.doc = "maximum number of applied rules", .min = 1})
        .param("limit", &FacadeBlock::limit, {.doc = "maximum number of symbols", .min = 1})
        .param("seed", &FacadeBlock::seed, {.doc = "seed instead of the scene's", .min = 0});
  }
};

const Schema<FacadeBlock>& facade_schema() {
  static const Schema<FacadeBlock> made = [] {
    Schema<FacadeBlock> s("facade", "declaration");
    FacadeBlock::describe(s);
    return s;
  }();
  return made;
}

/// Evaluates the options of the block; nothing if one of them has no value.
std::optional<FacadeBlock> read_facade_block(const scene::Grammar& grammar, RandomKey key,
                                             ReadContext& context) {
  Arguments arguments;
  bool sound = true;
  for (const scene::Entry& entry : grammar.options) {
    const std::vector<Value> values = context.evaluator.eval(entry, key);
    sound = sound && std::none_of(values.begin(), values.end(),
                                  [](const Value& value) { return value.empty(); });
    arguments.push_back({entry.key,
                         values.size() == 1 ? values[0] : Value(List(values.begin(), values.end())),
                         entry.extent});
  }
  if (!sound) return std::nullopt;
  Diagnostics found;
  auto block = facade_schema().bind(arguments, grammar.where, found);
  context.evaluator.report(found, arguments);
  return block;
}

}  // namespace

const KindInfo& facade_info() { return facade_schema().info(); }

Value bind_facade(const scene::Grammar& grammar, ReadContext& context) {
  RandomKey key = context.evaluator.root().at("grammar").at(grammar.name);
  const std::optional<FacadeBlock> block = read_facade_block(grammar, key, context);
  Diagnostics found;
  const facade::Rules rules = facade::read_rules(context.document, grammar, found);
  context.diagnostics.append(found);
  if (!block || grammar.broken || found.has_errors()) return {};
  if (block->seed) key = RandomKey(static_cast<uint64_t>(*block->seed)).at("facade");
  try {
    const auto derived = facade::derive(rules, context.evaluator,
                                        {.width = block->width,
                                         .height = block->height,
                                         .limits = {block->steps, block->limit},
                                         .key = key});
    if (!derived) return {};
    const auto tree = std::make_shared<const facade::Tree>(derived->tree);
    context.shot.derivations.push_back(
        {grammar.name, derived->derivation, derived->derivation.applied, tree});
    Value wall = field::as_value(facade::wall(tree, {block->at, block->yaw}, block->thickness));
    context.resolver.record(wall, grammar.extent);
    return wall;
  } catch (const Error& error) {
    context.diagnostics.add(error, grammar.where);
    return {};
  }
}

}  // namespace vug::loading
