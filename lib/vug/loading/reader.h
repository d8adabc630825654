// What a kind of declaration is read with: one file a kind in declarations/.
#pragma once

#include <vug/loading/load.h>
#include <vug/loading/resolver.h>
#include <vug/shot/plan_values.h>

namespace vug::loading {

/// Everything a declaration's reader may use and add to.
struct ReadContext {
  const scene::Document& document;
  scene::Evaluator& evaluator;
  Resolver& resolver;
  Diagnostics& diagnostics;
  shot::Shot& shot;
  const LoadOptions& options;
  const std::filesystem::path& file;  ///< Of the scene's text.
};

/// A word that opens a declaration. `read` makes its value, which other expressions see under the
/// declaration's name, and adds what the shot needs. `info.params` are the keys of its block.
struct DeclarationKind {
  KindInfo info;
  std::function<Value(const scene::Declaration&, ReadContext&)> read;
  std::string stands_on = {};  ///< What follows `on`: "volume", "mesh"; empty: there is no `on`.
  bool on_several = false;     ///< More of them may follow after commas.
};

const std::vector<const DeclarationKind*>& declaration_kinds();

/// Info of a declaration whose value is a kind of a family (see read_kind_declaration): its keys
/// are `kind` and, where there is a kind without being asked for one, the parameters of that.
KindInfo kind_declaration_info(const std::string& name, const std::string& doc,
                               const std::string& type, const std::string& fallback);

/// Whether the entry of that key has the word among its choices.
using IsChoice = std::function<bool(const std::string& key, const std::string& word)>;

/// The entries of a block as arguments: one value stands for itself, several for a list. A choice
/// stands for itself whatever the text declares under its name. Entries with faults have no value;
/// one without name and value stands for those that are lost.
Arguments block_arguments(const scene::Declaration& declaration, const IsChoice& is_choice,
                          ReadContext& context);

/// Whether the declaration is written with a block and not, with a diagnostic, with '='.
bool has_block(const scene::Declaration& declaration, ReadContext& context);

/// Arguments of a block bound to a schema; nothing, with diagnostics, when they do not fit.
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

/// The block bound to a schema; nothing (with diagnostics) when it does not fit or when the
/// declaration is written with '='.
template <class P>
std::optional<P> read_block(const Schema<P>& schema, const scene::Declaration& declaration,
                            ReadContext& context) {
  if (!has_block(declaration, context)) return std::nullopt;
  const IsChoice is_choice = [&](const std::string& key, const std::string& word) {
    return has_choice(schema.info(), key, word);
  };
  return bind_block(schema, block_arguments(declaration, is_choice, context), declaration, context);
}

/// A kind of the family as an expression names it, `voronoi` or `crack(color: ...)`, whatever the
/// text declares under that name; else the expression's value. Empty, with a diagnostic, where a
/// name is nothing.
Value kind_value(const KindRegistry& registry, const scene::Expr& expr, RandomKey key,
                 ReadContext& context);

/// A declaration whose value is a kind of one family: `light key = rect(...)`, or in block form
/// `camera main { kind orthographic  eye ... }` with `fallback` as the kind where none is given.
Value read_kind_declaration(const std::string& type, const std::string& fallback,
                            const scene::Declaration& declaration, ReadContext& context);

/// What one of those after `on` is, the first of them number 0; a bare name means what `kind`
/// declares under it, if that is something.
Value target_value(const std::string& kind, const scene::Declaration& declaration, size_t number,
                   ReadContext& context);

/// A diagnostic where a block that stands on a `kind` says nothing of it.
void report_no_target(const std::string& kind, const scene::Declaration& declaration,
                      ReadContext& context);

/// All that stands after `on`, as Ts; empty with a diagnostic that names the expected type.
template <class T>
std::vector<T> read_targets(const scene::Declaration& declaration, ReadContext& context,
                            const std::string& kind = ValueTraits<T>::type()) {
  if (declaration.value) return {};  // read_block has told that a block is needed
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
    own.error(where, "'" + declaration.kind + "' stands on a " + ValueTraits<T>::type() + ", not " +
                         value.type_name());
    context.evaluator.report(own, {{"on", value, where}});
  }
  return all.size() == count ? all : std::vector<T>();
}

/// The one thing that stands after `on`; null with a diagnostic.
template <class T>
T read_target(const scene::Declaration& declaration, ReadContext& context) {
  const std::vector<T> all = read_targets<T>(declaration, context);
  return all.empty() ? T{} : all.front();
}

}  // namespace vug::loading
