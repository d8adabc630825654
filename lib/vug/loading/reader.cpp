// SPDX-License-Identifier: Apache-2.0
#include <vug/base/pluralize.h>
#include <vug/loading/example.h>
#include <vug/loading/reader.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {

namespace {

/// Maximum number of names in a message or a list; there are too many solids to list them.
constexpr size_t kMaxNames = 12;

}  // namespace

KindInfo kind_declaration_info(const std::string& name, const std::string& doc,
                               const std::string& type, const std::string& fallback) {
  KindInfo info{name, "declaration", doc, "", {}};
  const KindRegistry& registry = *find_registry(type);
  ParamInfo kind;
  kind.name = "kind";
  kind.type = "name";
  kind.doc = fallback.empty() ? "the kind; its parameters follow"
                              : "the kind; the parameters below are those of " + fallback;
  kind.fallback = fallback;
  kind.required = fallback.empty();
  if (registry.kinds.size() <= kMaxNames)
    for (const RegisteredKind& each : registry.kinds) kind.choices.push_back(each.info->name);
  info.params.push_back(std::move(kind));
  if (const RegisteredKind* usual = registry.find(fallback))
    info.params.insert(info.params.end(), usual->info->params.begin(), usual->info->params.end());
  return info;
}

namespace {

/// The kind of the declaration that a name in the entry means if several have this name.
std::string kind_in_entry(const scene::Declaration& declaration, const std::string& key) {
  if (key != "of") return key;
  return declaration.kind == "place" ? "object" : "mesh";
}

std::vector<Value> entry_values(const scene::Declaration& declaration, const scene::Entry& entry,
                                ReadContext& context) {
  const RandomKey key = context.evaluator.key(declaration).at(entry.key);
  std::vector<Value> values;
  for (const scene::ExprPtr& expr : entry.values)
    values.push_back(context.evaluator.eval_as(kind_in_entry(declaration, entry.key), *expr,
                                               key.at(values.size())));
  return values;
}

}  // namespace

Arguments block_arguments(const scene::Declaration& declaration, const IsChoice& is_choice,
                          ReadContext& context) {
  Arguments arguments;
  for (const scene::Entry& entry : declaration.entries) {
    std::vector<Value> values;
    const scene::Expr& first = *entry.values.at(0);
    if (entry.values.size() == 1 && first.kind == scene::ExprKind::name &&
        is_choice(entry.key, first.text))
      values = {Value::Name{first.text}};
    else
      values = entry_values(declaration, entry, context);
    const bool faulty =
        std::any_of(values.begin(), values.end(), [](const Value& each) { return each.empty(); });
    Value value = faulty               ? Value()
                  : values.size() == 1 ? std::move(values[0])
                                       : Value(List(values.begin(), values.end()));
    arguments.push_back({entry.key, std::move(value), entry.extent});
  }
  if (declaration.incomplete) arguments.push_back({"", Value(), declaration.where});
  return arguments;
}

namespace {

/// The name as the text declares it, with the form of its loop.
std::string name_in_text(const scene::Declaration& declaration) {
  if (!declaration.loop) return declaration.name;
  return scene::name_without_index(declaration.name) + "[NAME in LIST]";
}

bool takes_target(const std::string& word) {
  const DeclarationKind* kind = find_declaration_kind(word);
  return kind && !kind->target_type.empty();
}

}  // namespace

const DeclarationKind* find_declaration_kind(const std::string& word) {
  for (const DeclarationKind* kind : declaration_kinds())
    if (kind->info.name == word) return kind;
  return nullptr;
}

bool has_block(const scene::Declaration& declaration, ReadContext& context) {
  if (!declaration.value) return true;
  context.diagnostics.error(
      declaration.where,
      fmt::format("'{}' is written with a block, not with '='", declaration.kind),
      fmt::format("for instance: {} {}{} {{ ... }}", declaration.kind, name_in_text(declaration),
                  takes_target(declaration.kind) ? " on NAME" : ""));
  return false;
}

Value target_value(const std::string& kind, const scene::Declaration& declaration, size_t number,
                   ReadContext& context) {
  const scene::Expr& target = declaration.target_at(number);
  const RandomKey key = context.evaluator.key(declaration).at("on");
  return context.evaluator.eval_as(kind, target, number == 0 ? key : key.at(number));
}

void report_no_target(const std::string& kind, const scene::Declaration& declaration,
                      ReadContext& context) {
  context.diagnostics.error(
      declaration.where, fmt::format("'{}' needs 'on' and a {}", declaration.kind, kind),
      fmt::format("{} {} on NAME {{ ... }}", declaration.kind, name_in_text(declaration)));
}

namespace {

/// Evaluates the kind `name` of the registry; nothing if there is none.
std::optional<Value> make(const KindRegistry& registry, const std::string& name,
                          const Arguments& arguments, const SourceLocation& where,
                          ReadContext& context) {
  Diagnostics own;
  auto value = context.resolver.make(registry, name, arguments, where, own);
  context.evaluator.report(own, arguments);
  return value;
}

std::string hint_for_unknown(const KindRegistry& registry, const std::string& name) {
  std::vector<std::string> names;
  for (const RegisteredKind& kind : registry.kinds) {
    if (is_synonym(name, *kind.info)) return fmt::format("did you mean '{}'?", kind.info->name);
    names.push_back(kind.info->name);
  }
  for (const KindRegistry& other : kind_registries())
    if (other.find(name))
      return other.type == "field" && registry.type == "volume"
                 ? fmt::format("'{0}' is a field: write level_set({0}(...), voxel: 10cm)", name)
                 : fmt::format("'{}' is listed by 'vug list {}'; choose from 'vug list {}'", name,
                               other.type, registry.type);
  return names.size() <= kMaxNames || !nearest_name(name, names).empty()
             ? suggestion(name, names)
             : "'vug list' shows them all";
}

Value report_unknown(const KindRegistry& registry, const std::string& name,
                     const SourceLocation& where, Diagnostics& diagnostics) {
  diagnostics.error(where, fmt::format("there is no {} '{}'", registry.type, name),
                    hint_for_unknown(registry, name));
  return Value();
}

/// Whether the expression calls a kind rather than a function of the text or a method.
bool is_kind_call(const scene::Expr& expr, const ReadContext& context) {
  return expr.kind == scene::ExprKind::call && !expr.method &&
         !context.evaluator.find_def(full_name(expr));
}

}  // namespace

Value kind_value(const KindRegistry& registry, const scene::Expr& expr, RandomKey key,
                 ReadContext& context) {
  const bool called = is_kind_call(expr, context);
  if ((called || expr.kind == scene::ExprKind::name) && registry.find(expr.text))
    return *make(registry, expr.text, called ? context.evaluator.arguments(expr, key) : Arguments{},
                 expr.where, context);
  Value value = context.evaluator.eval_as(registry.type, expr, key);
  if (value.get<Value::Name>())
    return report_unknown(registry, expr.text, expr.where, context.diagnostics);
  return value;
}

namespace {

Value read_kind_block(const KindRegistry& registry, const std::string& fallback,
                      const scene::Declaration& declaration, ReadContext& context) {
  std::string name = fallback;
  SourceLocation where = declaration.where;
  const IsChoice is_choice = [&](const std::string& key, const std::string& word) {
    if (key == "kind") return registry.find(word) != nullptr;
    return std::any_of(
        registry.kinds.begin(), registry.kinds.end(),
        [&](const RegisteredKind& kind) { return has_choice(*kind.info, key, word); });
  };
  Arguments arguments = block_arguments(declaration, is_choice, context);
  bool has_kind = false;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].name != "kind") continue;
    if (arguments[i].value.empty()) return Value();
    has_kind = true;
    const auto* given = arguments[i].value.get<Value::Name>();
    where = arguments[i].where;
    name = given ? given->text : to_string(arguments[i].value);
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  if (!has_kind && declaration.incomplete && context.document.skipped.may_mention("kind"))
    return Value();  // it may be one of the lost entries
  if (name.empty() && declaration.incomplete) return Value();
  if (name.empty()) {
    context.diagnostics.error(where, fmt::format("'{}' needs a kind", declaration.name),
                              fmt::format("{} {} = KIND(...), or 'kind KIND' in the block",
                                          declaration.kind, name_in_text(declaration)));
    return Value();
  }
  if (auto value = make(registry, name, arguments, where, context)) return *value;
  return report_unknown(registry, name, where, context.diagnostics);
}

}  // namespace

Value read_kind_declaration(const std::string& type, const std::string& fallback,
                            const scene::Declaration& declaration, ReadContext& context) {
  const KindRegistry& registry = *find_registry(type);
  if (!declaration.value) return read_kind_block(registry, fallback, declaration, context);
  const scene::Expr& expr = *declaration.value;
  const RandomKey key = context.evaluator.key(declaration);
  const bool called = is_kind_call(expr, context);
  if (called && registry.find(expr.text)) {
    const Arguments arguments = context.evaluator.arguments(expr, key);
    return *make(registry, expr.text, arguments, expr.where, context);
  }
  Value value = context.evaluator.eval_as(type, expr, key);
  if (value.empty()) return value;
  const Object* object = value.get<Object>();
  if (object && object->type == type) return value;
  if (called) return report_unknown(registry, expr.text, expr.where, context.diagnostics);
  Diagnostics own;
  own.error(expr.where, fmt::format("'{}' expects {}, not {}", declaration.name, with_article(type),
                                    value.type_name()));
  context.evaluator.report(own, {{"", value, expr.where}});
  return Value();
}

}  // namespace vug::loading
