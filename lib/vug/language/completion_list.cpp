// SPDX-License-Identifier: Apache-2.0
#include <vug/language/completion_list.h>
#include <vug/language/describe.h>
#include <vug/loading/kind_registry.h>
#include <vug/scene/evaluator.h>
#include <vug/scene/functions.h>
#include <vug/scene/units.h>

#include <fmt/format.h>

namespace vug::language {
namespace {

constexpr int kFirst = 0, kNames = 1, kCalls = 2, kOthers = 3;

/// A value that can stand for an argument until it is replaced.
std::string placeholder(const ParamInfo& param) {
  return param.fallback.empty() ? param.name : param.fallback;
}

/// Whether a value of the type is made of numbers, so that functions and operators compute it.
bool is_arithmetic(const std::string& type) {
  return type.empty() || type == "number" || type == "whole number" || type == "vector" ||
         type == "paint" || type == "true or false";
}

}  // namespace

std::string call_snippet(const KindInfo& info, size_t skipped) {
  std::string text = info.name + "(";
  int field = 0;
  for (size_t i = skipped; i < info.params.size(); ++i) {
    const ParamInfo& param = info.params[i];
    if (!param.required) continue;
    ++field;
    text += fmt::format("{}{}: ${{{}:{}}}", field > 1 ? ", " : "", param.name, field,
                        placeholder(param));
  }
  return text + (field == 0 ? "$0)" : ")");
}

void CompletionList::add(Completion item) {
  if (item.snippet.empty()) item.snippet = item.label;
  if (known_.emplace(item.label, item.kind).second) items_.push_back(std::move(item));
}

void CompletionList::add_words(const std::vector<LanguageWord>& words,
                               const std::set<std::string>& chosen, int rank) {
  for (const LanguageWord& word : words)
    if (chosen.empty() || chosen.count(word.name))
      add({word.name, CompletionKind::keyword, word.use, word.doc, "", rank});
}

void CompletionList::add_statements() {
  for (const LanguageWord& word : statement_words())
    add({word.name, CompletionKind::keyword, word.use, word.doc, std::string(word.name) + " $0",
         kFirst});
  for (const std::string& word : declaration_words())
    add({word, CompletionKind::keyword, "declaration", find_declaration(word)->doc, word + " $0",
         kFirst});
}

void CompletionList::add_keys() {
  for (const ParamInfo& param : missing_entries(context_, analysis_.document))
    add({param.name, CompletionKind::argument, param.type, describe(param), param.name + " $0",
         kFirst});
  if (context_.grammar.empty()) return;
  add_words(inner_words(), {"axiom"}, kFirst);
  if (context_.grammar == "lsystem")
    for (const char* word :
         {"table", "schedule", "decompose", "interpret", "ignore", "consider", "ages"})
      add({word, CompletionKind::keyword, "part of an L-system", "", "", kFirst});
  add_symbols();
}

void CompletionList::add_symbols() {
  for (const Symbol* symbol : analysis_.symbols.visible_at(analysis_.file, position_))
    if (symbol->kind == SymbolKind::rule) add_symbol(*symbol, symbol->name, kFirst);
  for (const scene::Grammar& grammar : analysis_.document.grammars)
    if (grammar.name == context_.name)
      for (const std::string& head : grammar.broken_rules)
        add({head, CompletionKind::symbol, "symbol", "", "", kFirst});
  if (context_.place != Place::symbols) return;
  add_words(inner_words(), {"nothing", "where"}, kCalls);
  if (context_.grammar == "facade") {
    add_kinds("split", kNames);
    add_kinds("element", kNames);
  } else if (context_.grammar == "shape") {
    add_kinds("field", kCalls);
    add_names("field", kNames);
    for (const ParamInfo& param : find_declaration("grammar")->params)
      add({param.name, CompletionKind::argument, param.type, describe(param), param.name + " $0",
           kOthers});
  }
}

void CompletionList::add_arguments() {
  const OpenCall& call = *context_.call();
  for (const CallMeaning& meaning : meanings_at(context_, analysis_.document))
    for (size_t i = call.unnamed; i < meaning.info.params.size(); ++i) {
      const ParamInfo& param = meaning.info.params[i];
      if (param.name.empty() || call.given.count(param.name)) continue;
      add({param.name, CompletionKind::argument,
           param.required ? param.type + ", required" : param.type, describe(param),
           param.name + ": $0", kFirst});
    }
}

void CompletionList::add_choices(const Expectation& expectation) {
  for (const ParamInfo& param : expectation.params) {
    for (const std::string& choice : param.choices)
      add({choice, CompletionKind::choice, param.name, describe(param), "", kFirst});
    if (param.type == "true or false")
      for (const char* word : {"true", "false"})
        add({word, CompletionKind::choice, param.name, describe(param), "", kFirst});
  }
}

void CompletionList::add_call(const CallMeaning& meaning, const char* detail, int rank) {
  const bool bare = meaning.info.params.empty();
  add({meaning.info.name, meaning.function ? CompletionKind::function : CompletionKind::kind,
       meaning.type.empty() ? detail : meaning.type, describe(meaning),
       bare ? meaning.info.name + "()" : call_snippet(meaning.info, 0), rank});
}

void CompletionList::add_kinds(const std::string& type, int rank) {
  for (const CallableKind& kind : callable_kinds())
    if (type.empty() || kind.type == type) add_call({*kind.info, kind.type, false}, "", rank);
}

void CompletionList::add_functions(int rank) {
  for (const scene::Function& function : scene::functions())
    add({function.name, CompletionKind::kind, std::string("of ") + function.takes, function.doc,
         std::string(function.name) + "($0)", rank});
  for (const LanguageWord& word : value_words())
    add({word.name, CompletionKind::keyword, word.use, word.doc, "", rank});
}

void CompletionList::add_symbol(const Symbol& symbol, const std::string& name, int rank) {
  CompletionKind kind = CompletionKind::value;
  if (symbol.kind == SymbolKind::declaration || symbol.kind == SymbolKind::grammar)
    kind = CompletionKind::declaration;
  if (symbol.kind == SymbolKind::rule) kind = CompletionKind::symbol;
  if (symbol.kind == SymbolKind::module) kind = CompletionKind::module;
  add({name, kind, description(symbol), symbol.doc,
       symbol.kind == SymbolKind::module ? name + ".$0" : "", rank});
}

void CompletionList::add_names(const std::string& type, int rank) {
  for (const Symbol* symbol : analysis_.symbols.visible_at(analysis_.file, position_)) {
    if (symbol->kind == SymbolKind::rule || symbol->kind == SymbolKind::table) continue;
    if (symbol->full_name.find('.') != std::string::npos || symbol->name == context_.name) continue;
    if (symbol->kind == SymbolKind::function) {
      for (const scene::Def& def : analysis_.document.defs)
        if (def.where == symbol->where) add_call({scene::info_of(def), "", true}, "function", rank);
      continue;
    }
    const bool declared = symbol->kind == SymbolKind::declaration;
    const bool usable = !declared || type.empty() || symbol->keyword == type ||
                        !loading::find_registry(symbol->keyword);
    if (usable)
      add_symbol(*symbol, symbol->name, declared && symbol->keyword == type ? kFirst : rank);
  }
  for (const std::string& name : context_.locals)
    add({name, CompletionKind::value, "local name", "", "", rank});
}

void CompletionList::add_values() {
  const Expectation expectation = expectation_at(context_, analysis_.document);
  const OpenCall* call = context_.call();
  if (call && call->begins && call->argument.empty() && !context_.in_list && !context_.in_vector)
    add_arguments();
  add_choices(expectation);
  if (context_.in_block && !call && context_.key == "kind") {  // a kind without its brackets
    for (const CallableKind& kind : callable_kinds())
      if (kind.type == context_.keyword)
        add({kind.info->name, CompletionKind::choice, kind.type, kind.info->doc, "", kFirst});
    return;
  }
  add_names(expectation.type, kNames);
  if (is_arithmetic(expectation.type)) add_functions(kCalls);
  const bool known = loading::find_registry(expectation.type) || expectation.type == "split";
  if (known) return add_kinds(expectation.type, kCalls);
  if (expectation.type.empty()) add_kinds({}, kOthers);
}

void CompletionList::add_members() {
  const std::string prefix = context_.receiver + ".";
  if (analysis_.document.find_module(context_.receiver)) {
    for (const Symbol& symbol : analysis_.symbols.symbols) {
      if (!symbol.full_name.starts_with(prefix) || symbol.name.starts_with("_")) continue;
      const std::string name = symbol.full_name.substr(prefix.size());
      if (name.find('.') != std::string::npos) continue;
      if (symbol.kind != SymbolKind::function) {
        add_symbol(symbol, name, kFirst);
        continue;
      }
      for (const scene::Def& def : analysis_.document.defs) {
        if (def.name != symbol.full_name) continue;
        CallMeaning meaning{scene::info_of(def), "", true};
        meaning.info.name = name;
        add_call(meaning, "function", kFirst);
      }
    }
    return;
  }
  // Methods: the receiver is the first argument, which is an object.
  for (const CallableKind& kind : callable_kinds()) {
    if (kind.info->params.empty()) continue;
    const std::string first(element_type(kind.info->params[0].type));
    if (!loading::find_registry(first)) continue;
    add({kind.info->name, CompletionKind::kind, kind.type,
         describe(CallMeaning{*kind.info, kind.type, false}), call_snippet(*kind.info, 1),
         first == "field" ? kFirst : kCalls});
  }
}

void CompletionList::add_units() {
  const Expectation expectation = expectation_at(context_, analysis_.document);
  std::vector<std::string> names = scene::unit_names();
  names.emplace_back("%");
  for (const std::string& name : names) {
    const auto one = scene::with_unit(1, name);
    if (!one) continue;
    bool fits = expectation.params.empty();
    for (const ParamInfo& param : expectation.params)
      fits = fits || one->dimension == param.dimension;
    if (fits) add({name, CompletionKind::unit, to_string(one->dimension), "", "", kFirst});
  }
}

}  // namespace vug::language
