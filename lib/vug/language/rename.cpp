// SPDX-License-Identifier: Apache-2.0
#include <vug/language/navigation.h>
#include <vug/language/rename.h>
#include <vug/scene/check.h>
#include <vug/scene/lsystem_document.h>
#include <vug/scene/module_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace vug::language {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy,
                         const SourceLocation& where = {}) {
  throw Error(ErrorCode::bad_input, problem, where, remedy);
}

bool is_name(const std::string& text) {
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return c == '_' || (std::isalnum(static_cast<unsigned char>(c)) && c > 0);
         });
}

/// Whether the symbol is a module of an L-system, whose name the lexer finds in a row of letters.
bool is_module(const Analysis& analysis, const Symbol& symbol) {
  if (symbol.kind != SymbolKind::rule) return false;
  return std::any_of(analysis.document.grammars.begin(), analysis.document.grammars.end(),
                     [&](const scene::Grammar& grammar) {
                       return grammar.lsystem && grammar.extent == symbol.scope;
                     });
}

void check_new_name(const Analysis& analysis, const Symbol& symbol, const std::string& name) {
  if (!is_name(name))
    refuse(fmt::format("'{}' is not a name", name),
           "a name consists of letters a-z, digits and _ and does not begin with a digit");
  if (!scene::may_name(name))
    refuse(fmt::format("'{}' is a word of the language or a unit", name), "choose another name");
  if (is_module(analysis, symbol) && scene::split_names(name).size() > 1)
    refuse(fmt::format("'{}' is the names of several modules", name),
           "begin the name of a module with a capital letter and continue in small letters");
}

/// The meaning of each name in the texts: the places of the names and of their declarations.
using Meanings = std::map<std::pair<std::string, Position>, std::pair<std::string, Position>>;

/// The position after the edits of its line before it.
Position moved(const Position& position, const std::string& file,
               const std::map<std::string, std::vector<TextEdit>>& edits) {
  Position after = position;
  const auto own = edits.find(file);
  if (own == edits.end()) return after;
  for (const TextEdit& edit : own->second)
    if (edit.range.line == position.line && end_of(edit.range) <= position)
      after.column +=
          static_cast<int>(edit.text.size()) - (edit.range.end_column - edit.range.column);
  return after;
}

void add_meanings(const Analysis& analysis,
                  const std::map<std::string, std::vector<TextEdit>>& edits, Meanings& meanings) {
  for (const Reference& each : analysis.symbols.references) {
    const SourceLocation& declared = analysis.symbols.of(each).where;
    meanings.insert({{each.where.file, moved(begin_of(each.where), each.where.file, edits)},
                     {declared.file, moved(begin_of(declared), declared.file, edits)}});
  }
}

void require_sound(const Analysis& analysis) {
  if (!analysis.diagnostics.has_errors()) return;
  for (const Diagnostic& each : analysis.diagnostics.all())
    if (each.severity == Severity::error)
      refuse(fmt::format("{} has errors that may hide uses of the name", analysis.file),
             fmt::format("correct them first: {}", each.message), each.where);
}

}  // namespace

SourceLocation renamable_at(const Analysis& analysis, const Position& position) {
  const Reference* found = analysis.symbols.at(analysis.file, position);
  if (!found)
    refuse("the cursor is not on a name that can be renamed",
           "put it on a name that this text declares; the names of kinds and of their parameters "
           "are fixed");
  const Symbol& symbol = analysis.symbols.of(*found);
  if (is_module(analysis, symbol) && scene::is_turtle_name(symbol.name))
    refuse(fmt::format("'{}' is a command of the turtle", symbol.name),
           "its name has a fixed meaning");
  return found->where;
}

Workspace with_edits(const Workspace& workspace,
                     const std::map<std::string, std::vector<TextEdit>>& edits) {
  Workspace edited = workspace;
  for (const auto& [file, changes] : edits)
    edited.open(file, apply(scene::normalise_text(workspace.read(file).value_or("")), changes));
  return edited;
}

std::map<std::string, std::vector<TextEdit>> rename(const Workspace& workspace,
                                                    const Analysis& analysis,
                                                    const Position& position,
                                                    const std::string& new_name) {
  renamable_at(analysis, position);
  const Symbol symbol = *symbol_at(analysis, position);
  check_new_name(analysis, symbol, new_name);
  require_sound(analysis);
  std::map<std::string, std::vector<TextEdit>> edits;
  for (const Reference& each : references_of(workspace, analysis, symbol))
    edits[each.where.file].push_back({each.where, new_name});
  if (new_name == symbol.name) return edits;
  // The rename is safe if every name of every text that it changes means the same as before.
  const Workspace edited = with_edits(workspace, edits);
  std::vector<std::filesystem::path> texts = {analysis.file};
  for (const auto& [file, changes] : edits) texts.emplace_back(file);
  if (!symbol.scope.known())
    for (const std::filesystem::path& file : workspace.files_with(symbol.name))
      texts.push_back(file);
  for (const std::filesystem::path& text : texts) {
    const AnalysisPtr before = workspace.analyse(text), after = edited.analyse(text);
    if (references_in(*before, symbol).empty()) continue;
    require_sound(*before);
    for (const Diagnostic& each : after->diagnostics.all())
      if (each.severity == Severity::error)
        refuse(fmt::format("the name '{}' clashes: {}", new_name, each.message),
               "choose another name", each.where);
    Meanings expected, actual;
    add_meanings(*before, edits, expected);
    add_meanings(*after, {}, actual);
    if (expected != actual)
      refuse(fmt::format("the name '{}' already means something else where '{}' is used", new_name,
                         symbol.name),
             "choose another name", symbol.where);
  }
  return edits;
}

}  // namespace vug::language
