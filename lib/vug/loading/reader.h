// SPDX-License-Identifier: Apache-2.0
// Steps shared by the readers of declarations: calls of kinds, `on`, blocks and their errors; each
// keyword has one file in declarations/.
#pragma once

#include <vug/loading/load.h>
#include <vug/loading/resolver.h>
#include <vug/shot/plan_values.h>

namespace vug::loading {

/// The data that the reader of a declaration uses and extends.
struct ReadContext {
  const scene::Document& document;
  scene::Evaluator& evaluator;
  Resolver& resolver;
  Diagnostics& diagnostics;
  shot::Shot& shot;
  const LoadOptions& options;
  const std::filesystem::path& file;  ///< The scene file.
};

/// A keyword that begins a declaration. `read` returns its value, which other expressions use under
/// the declaration's name, and extends the shot. `info.params` are the keys of its block.
struct DeclarationKind {
  KindInfo info;
  std::function<Value(const scene::Declaration&, ReadContext&)> read;
  std::string target_type = {};  ///< Type after `on`: "volume", "mesh"; empty: no `on`.
  bool several_targets = false;  ///< Whether `on` takes several, separated by commas.
  /// Whether expressions can use its name, and `KIND NAME[i in LIST]` declares one for each
  /// element.
  bool is_value = true;
};

const std::vector<const DeclarationKind*>& declaration_kinds();
/// The kind that the word begins; null for other words.
const DeclarationKind* find_declaration_kind(const std::string& word);

/// The info of a declaration whose value is a kind of a registry (see read_kind_declaration). Its
/// keys are `kind` and the parameters of the default kind, if there is one.
KindInfo kind_declaration_info(const std::string& name, const std::string& doc,
                               const std::string& type, const std::string& fallback);

/// Whether `word` is one of the choices of the entry `key`.
using IsChoice = std::function<bool(const std::string& key, const std::string& word)>;

/// The entries of a block as arguments; several values become a list. The word of a choice always
/// means the choice, even if the text declares something of that name. Entries with faults have no
/// value; an argument without name and value stands for entries that could not be parsed.
Arguments block_arguments(const scene::Declaration& declaration, const IsChoice& is_choice,
                          ReadContext& context);

/// Whether the declaration has a block; reports an error if it is written with '='.
bool has_block(const scene::Declaration& declaration, ReadContext& context);

/// Binds the arguments of a block to a schema; nothing, with diagnostics, if they do not fit.
template <class P>
std::optional<P> bind_block(const Schema<P>& schema, const Arguments& arguments,
                            const scene::Declaration& declaration, ReadContext& context) {
  Diagnostics found, own;
  const ValidArguments valid(arguments);
  std::optional<P> params = schema.bind(valid.arguments, declaration.where, found);
  valid.report(found, declaration.where, own);
  context.evaluator.report(own, arguments);
  return valid.complete ? params : std::nullopt;
}

/// Binds the block to a schema; nothing, with diagnostics, if it does not fit or if the declaration
/// is written with '='.
template <class P>
std::optional<P> read_block(const Schema<P>& schema, const scene::Declaration& declaration,
                            ReadContext& context) {
  if (!has_block(declaration, context)) return std::nullopt;
  const IsChoice is_choice = [&](const std::string& key, const std::string& word) {
    return has_choice(schema.info(), key, word);
  };
  return bind_block(schema, block_arguments(declaration, is_choice, context), declaration, context);
}

/// The kind that an expression such as `voronoi` or `crack(color: ...)` names, even if the text
/// declares something of that name; else the value of the expression. Empty, with a diagnostic, for
/// unknown names.
Value kind_value(const KindRegistry& registry, const scene::Expr& expr, RandomKey key,
                 ReadContext& context);

/// Reads a declaration whose value is a kind of one registry: `light key = rect(...)`, or in block
/// form `camera main { kind orthographic  eye ... }`, with `fallback` as the default kind.
Value read_kind_declaration(const std::string& type, const std::string& fallback,
                            const scene::Declaration& declaration, ReadContext& context);

/// The value of target `number` after `on`, counted from 0. A name refers to the declaration of
/// `kind` with that name, if there is one.
Value target_value(const std::string& kind, const scene::Declaration& declaration, size_t number,
                   ReadContext& context);

/// Reports that a declaration lacks its `on` with a `kind`.
void report_no_target(const std::string& kind, const scene::Declaration& declaration,
                      ReadContext& context);

/// All targets after `on`, converted to T; empty, with a diagnostic, for a value of another type.
template <class T>
std::vector<T> read_targets(const scene::Declaration& declaration, ReadContext& context,
                            const std::string& kind = ValueTraits<T>::type()) {
  if (declaration.value) return {};  // read_block reports the missing block
  if (!declaration.target) {
    report_no_target(kind, declaration, context);
    return {};
  }
  std::vector<T> all;
  const size_t count = 1 + declaration.more_targets.size();
  for (size_t i = 0; i < count; ++i) {
    const Value value = target_value(kind, declaration, i, context);
    if (value.empty()) continue;
    if (auto target = ValueTraits<T>::read(value)) {
      all.push_back(*target);
      continue;
    }
    const SourceLocation& where = declaration.target_at(i).where;
    Diagnostics own;
    own.error(where, "'" + declaration.kind + "' expects a " + ValueTraits<T>::type() +
                         " after 'on', not " + value.type_name());
    context.evaluator.report(own, {{"on", value, where}});
  }
  return all.size() == count ? all : std::vector<T>();
}

/// The single target after `on`; null with a diagnostic.
template <class T>
T read_target(const scene::Declaration& declaration, ReadContext& context) {
  const std::vector<T> all = read_targets<T>(declaration, context);
  return all.empty() ? T{} : all.front();
}

}  // namespace vug::loading
