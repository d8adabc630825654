// SPDX-License-Identifier: Apache-2.0
#include <vug/language/describe.h>
#include <vug/language/signature.h>
#include <vug/scene/functions.h>

#include <fmt/format.h>

namespace vug::language {
namespace {

Signature signature_of(const CallMeaning& meaning, const OpenCall& call) {
  Signature out;
  out.label = signature_text(meaning);
  out.doc = meaning.info.doc;
  const ParamInfo* active = find_param(meaning.info, call.position, call.argument);
  size_t at = meaning.info.name.size() + 1;
  for (const ParamInfo& param : meaning.info.params) {
    if (param.name.empty()) continue;
    const size_t type = param.type.empty() ? 0 : 2 + param.type.size();
    const size_t length = param.name.size() + type + (param.required ? 0 : 2);
    if (&param == active) out.active = static_cast<int>(out.parameters.size());
    out.parameters.push_back({at, at + length, describe(param)});
    at += length + 2;
  }
  return out;
}

}  // namespace

std::vector<Signature> signatures_at(const Analysis& analysis, const Position& position) {
  const Context context = context_at(analysis, position);
  std::vector<Signature> all;
  const OpenCall* call = context.call();
  if (!call) return all;
  for (const CallMeaning& each : meanings_at(context, analysis.document))
    all.push_back(signature_of(each, *call));
  if (const scene::Function* function = scene::find_function(call->name))
    all.push_back({fmt::format("{}({})", function->name, function->takes), function->doc, {}, -1});
  if (const LanguageWord* word = find_word(value_words(), call->name))
    all.push_back({word->use, word->doc, {}, -1});
  return all;
}

}  // namespace vug::language
