// SPDX-License-Identifier: Apache-2.0
#include <vug/language/expectation.h>
#include <vug/loading/kind_registry.h>
#include <vug/loading/reader.h>
#include <vug/scene/evaluator.h>

#include <algorithm>

namespace vug::language {
namespace {

const scene::Def* find_function(const scene::Document& document, const std::string& name) {
  for (const scene::Def& def : document.defs)
    if (def.name == name) return &def;
  return nullptr;
}

bool accepts(const KindInfo& info, const OpenCall& call) {
  return std::all_of(call.given.begin(), call.given.end(),
                     [&](const std::string& name) { return find_param(info, 0, name); });
}

/// The type of the value of a declaration's "=" or of a value after `on`.
std::string declared_type(const Context& context) {
  if (context.target) {
    const loading::DeclarationKind* kind = loading::find_declaration_kind(context.keyword);
    return kind ? kind->target_type : std::string();
  }
  return loading::find_registry(context.keyword) ? context.keyword : std::string();
}

/// The type that the call at an index of the open calls must have.
std::string type_of_call(const Context& context, const scene::Document& document, size_t index) {
  Context outer = context;
  outer.calls.resize(index);
  return expectation_at(outer, document).type;
}

}  // namespace

std::vector<CallMeaning> meanings_of(const OpenCall& call, const scene::Document& document,
                                     const std::string& expected) {
  const scene::Def* def = find_function(document, call.name);
  if (!call.receiver.empty())
    if (const scene::Def* member = find_function(document, call.receiver + "." + call.name))
      def = member;
  if (def) {
    CallMeaning function{scene::info_of(*def), "", true};
    // The receiver of a method is its first argument; a module is not an argument.
    if (call.method && document.find_module(call.receiver))
      function.info.params.insert(function.info.params.begin(), ParamInfo());
    return {std::move(function)};
  }
  std::vector<CallMeaning> fitting, others;
  for (const CallableKind& kind : callable_kinds(call.name))
    (accepts(*kind.info, call) ? fitting : others).push_back({*kind.info, kind.type, false});
  std::vector<CallMeaning>& all = fitting.empty() ? others : fitting;
  std::stable_partition(all.begin(), all.end(),
                        [&](const CallMeaning& each) { return each.type == expected; });
  return std::move(all);
}

std::vector<CallMeaning> meanings_at(const Context& context, const scene::Document& document) {
  if (context.calls.empty()) return {};
  return meanings_of(context.calls.back(), document,
                     type_of_call(context, document, context.calls.size() - 1));
}

Expectation expectation_at(const Context& context, const scene::Document& document) {
  Expectation expectation;
  if (const OpenCall* call = context.call()) {
    for (const CallMeaning& each : meanings_at(context, document))
      if (const ParamInfo* param = find_param(each.info, call->position, call->argument))
        expectation.params.push_back(*param);
  } else if (context.in_block) {
    const std::string& keyword = context.grammar.empty() ? context.keyword : context.grammar;
    for (const ParamInfo* param : block_params(keyword, context.kind))
      if (param->name == context.key) expectation.params.push_back(*param);
    if (context.key == "kind") expectation.type = context.keyword;
  } else {
    expectation.type = declared_type(context);
  }
  if (!expectation.params.empty() && expectation.type.empty())
    expectation.type = std::string(element_type(expectation.params.front().type));
  if (context.in_vector && (expectation.type == "vector" || expectation.type == "paint"))
    expectation.type = "number";
  return expectation;
}

std::vector<ParamInfo> missing_entries(const Context& context, const scene::Document& document) {
  std::vector<ParamInfo> missing;
  const auto add = [&](const ParamInfo& param) {
    if (!context.keys.count(param.name)) missing.push_back(param);
  };
  const auto add_params = [&](const std::string& prefix) {
    for (const scene::Param& param : document.params) {
      if (!param.name.starts_with(prefix)) continue;
      ParamInfo info;
      info.name = param.name.substr(prefix.size());
      info.doc = param.doc;
      if (info.name.find('.') == std::string::npos) add(info);
    }
  };
  if (context.keyword == "variant") {
    add_params("");
  } else if (context.keyword == "include") {
    add_params(context.name + ".");
  } else {
    const std::string& keyword = context.grammar.empty() ? context.keyword : context.grammar;
    for (const ParamInfo* param : block_params(keyword, context.kind)) add(*param);
  }
  return missing;
}

}  // namespace vug::language
