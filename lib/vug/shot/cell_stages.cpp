// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>
#include <vug/shot/cell_stages.h>

#include <algorithm>
#include <deque>

namespace vug::shot {
namespace {

constexpr int kMaxSteps = 1000000;

Schema<CellStage> stage_schema(const std::string& rule) {
  Schema<CellStage> s(rule, "rule");
  s.param("begin", &CellStage::begin,
          {.doc = "first step, counted from 0", .min = 0, .max = kMaxSteps})
      .param("steps", &CellStage::steps,
             {.doc = "number of steps; default: to the end of the run, or 1 for rules that act "
                     "once",
              .min = 1,
              .max = kMaxSteps})
      .param("where", &CellStage::where,
             {.doc = "mask that gives the probability of rewriting each cell; evaluated in each "
                     "step if it reads attributes"});
  return s;
}

}  // namespace

Kind<CellStagePtr> stage_kind(const cells::RuleKind& rule) {
  const Schema<CellStage> schema = stage_schema(rule.info.name);
  KindInfo info = rule.info;
  const std::vector<ParamInfo>& own = schema.info().params;
  info.params.insert(info.params.end(), own.begin(), own.end());
  const auto make = [&rule, schema](const Arguments& arguments, const SourceLocation& where,
                                    Diagnostics& diagnostics) -> std::optional<CellStagePtr> {
    Arguments of_rule, of_stage;
    for (const Argument& each : arguments) {
      const std::vector<ParamInfo>& known = schema.info().params;
      const bool staged = std::any_of(known.begin(), known.end(), [&](const ParamInfo& param) {
        return param.name == each.name;
      });
      (staged ? of_stage : of_rule).push_back(each);
    }
    const auto made = rule.make(of_rule, where, diagnostics);
    auto stage = schema.bind(of_stage, where, diagnostics);
    if (!made || !stage) return std::nullopt;
    stage->rule = *made;
    stage->name = rule.info.name;
    stage->location = where;
    return std::make_shared<const CellStage>(std::move(*stage));
  };
  return {std::move(info), make};
}

const Kinds<CellStagePtr>& cell_stages() {
  static const std::deque<Kind<CellStagePtr>> made = [] {
    std::deque<Kind<CellStagePtr>> all;
    for (const cells::RuleKind* rule : cells::rules()) all.push_back(stage_kind(*rule));
    return all;
  }();
  static const Kinds<CellStagePtr> kinds = [] {
    Kinds<CellStagePtr> all;
    for (const auto& kind : made) all.push_back(&kind);
    return all;
  }();
  return kinds;
}

}  // namespace vug::shot
