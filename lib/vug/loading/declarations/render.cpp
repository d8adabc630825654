// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/reader.h>
#include <vug/shot/selection.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

/// An entry of a render block that selects declarations by name.
struct NameEntry {
  const char* key;
  std::vector<std::string> kinds;  ///< Kinds of the declarations.
  const char* expected;
};

/// Null for other entries.
const NameEntry* find_name_entry(const std::string& key) {
  static const std::vector<NameEntry> all = {
      {"lights", {"light"}, "names of lights, such as [key, fill]"},
      {"objects", {"object", "place", "mesh", "volume"}, "names of objects and places"},
      {"air", {"medium"}, "the name of a medium, or none"}};
  for (const NameEntry& each : all)
    if (key == each.key) return &each;
  return nullptr;
}

/// Reports an entry whose values are not names: `found` describes the first one.
void report_no_names(const scene::Entry& entry, const NameEntry& selects, const std::string& found,
                     const std::string& hint, ReadContext& context) {
  context.diagnostics.error(
      entry.extent, fmt::format("'{}' expects {}, not {}", entry.key, selects.expected, found),
      hint);
}

/// A hint for `lights rig` after `let rig = [key]`; empty for other entries.
std::string hint_for_let(const scene::Entry& entry, const scene::Document& document) {
  for (const scene::ExprPtr& expr : entry.values)
    if (expr->kind == scene::ExprKind::name && document.find_let(full_name(*expr)))
      return fmt::format("write the names in this entry: '{}' is a list of values", expr->text);
  return {};
}

/// Appends the names in a value to a list of texts. Returns the first value that is not a name, or
/// null.
const Value* add_names(const Value& value, List& texts) {
  if (const auto* name = value.get<Value::Name>()) {
    texts.push_back(name->text);
    return nullptr;
  }
  const List* list = value.get<List>();
  if (!list) return &value;
  for (const Value& each : *list)
    if (const Value* other = add_names(each, texts)) return other;
  return nullptr;
}

/// The name of a declaration; for a loop, the list of the names of its elements.
Value name_value(const scene::Declaration& declaration, ReadContext& context) {
  if (!declaration.loop) return Value::Name{declaration.name};
  const std::optional<Value> made = context.resolver.declared(
      declaration.kind, declaration.name, declaration.where, context.diagnostics);
  const List* elements = made ? made->get<List>() : nullptr;
  if (!elements) return Value();
  List names;
  for (size_t i = 0; i < elements->size(); ++i)
    names.push_back(Value::Name{fmt::format("{}[{}]", declaration.name, i)});
  return names;
}

/// The names that an entry selects, as texts. They are not the values of the declarations: a name
/// that a light and a mesh share means the light.
Value selected_names(const scene::Entry& entry, const NameEntry& selects,
                     const scene::Declaration& declaration, ReadContext& context) {
  context.resolver.use_whole_text();
  scene::Scope names;
  for (const scene::Declaration& each : context.document.declarations)
    if (std::find(selects.kinds.begin(), selects.kinds.end(), each.kind) != selects.kinds.end())
      names.names.emplace_back(each.name, name_value(each, context));
  names.names.emplace_back(shot::kNoAir, Value::Name{shot::kNoAir});
  scene::Scope variables{{}, &names, nullptr};  // they hide declarations of their names
  if (const scene::Scope* loop = context.evaluator.variables()) variables.names = loop->names;
  for (const scene::ExprPtr& expr : entry.values)
    if (expr->kind == scene::ExprKind::vector) {
      report_no_names(entry, selects, "a vector", "write a list in [ ]", context);
      return {};
    }
  List all;
  for (const Value& value :
       context.evaluator.eval(entry, context.evaluator.key(declaration), &variables)) {
    if (value.empty()) return {};
    const Value* other = add_names(value, all);
    if (!other) continue;
    report_no_names(entry, selects, other->type_name(), hint_for_let(entry, context.document),
                    context);
    return {};
  }
  return entry.key == "air" && all.size() == 1 ? all[0] : Value(all);
}

/// The settings of the block; nothing, with diagnostics, if they are invalid.
std::optional<shot::RenderSettings> read_settings(const scene::Declaration& declaration,
                                                  ReadContext& context) {
  if (!has_block(declaration, context)) return std::nullopt;
  if (const scene::Entry* medium = declaration.find_entry("medium")) {
    context.diagnostics.error(medium->where, "'render' has no parameter 'medium'",
                              "'air' chooses the medium of a picture: air NAME or air none");
    return std::nullopt;
  }
  scene::Declaration others = declaration;
  std::erase_if(others.entries,
                [](const scene::Entry& entry) { return find_name_entry(entry.key) != nullptr; });
  const auto& schema = shot::render_schema();
  Arguments arguments = block_arguments(
      others,
      [&](const std::string& key, const std::string& word) {
        return has_choice(schema.info(), key, word);
      },
      context);
  for (const scene::Entry& entry : declaration.entries)
    if (const NameEntry* selects = find_name_entry(entry.key))
      arguments.push_back(
          {entry.key, selected_names(entry, *selects, declaration, context), entry.extent});
  return bind_block(schema, arguments, declaration, context);
}

}  // namespace

const DeclarationKind& render_declaration() {
  static const DeclarationKind kind = {
      shot::render_schema().info(),
      [](const scene::Declaration& declaration, ReadContext& context) -> Value {
        std::optional<shot::RenderSettings> settings = read_settings(declaration, context);
        if (!settings) return Value();
        if (const auto fault = shot::find_fault(*settings)) {
          for (const scene::Entry& entry : declaration.entries)
            if (entry.key == fault->setting)
              context.diagnostics.error(entry.where, fault->message, fault->hint);
          return Value();
        }
        const bool included = declaration.where.file != context.document.sources.at(0)->file;
        shot::RenderPlan plan{
            declaration.name, std::move(*settings), declaration.where, included, {}};
        for (const scene::Entry& entry : declaration.entries) plan.stated.push_back(entry.key);
        context.shot.renders.push_back(std::move(plan));
        return Value(Value::Name{declaration.name});
      }};
  return kind;
}

}  // namespace vug::loading
