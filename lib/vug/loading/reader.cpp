#include <vug/loading/reader.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {

#define VUG_KIND(name) const DeclarationKind& name##_declaration();
#include <vug/loading/declarations_kinds.inc>
#undef VUG_KIND

const std::vector<const DeclarationKind*>& declaration_kinds() {
#define VUG_KIND(name) &name##_declaration(),
  static const std::vector<const DeclarationKind*> kinds = {
#include <vug/loading/declarations_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

namespace {

/// Names that a message or a list shows; of solids there are many more than anybody reads.
constexpr size_t kMostNames = 12;

}  // namespace

KindInfo family_info(const std::string& name, const std::string& doc, const std::string& type,
                     const std::string& fallback) {
  KindInfo info{name, "declaration", doc, "", {}};
  const Family& family = *find_family(type);
  ParamInfo kind;
  kind.name = "kind";
  kind.type = "name";
  kind.doc = fallback.empty() ? "which one it is; then come the parameters of that"
                              : "which one it is; the parameters below are those of " + fallback;
  kind.fallback = fallback;
  kind.required = fallback.empty();
  if (family.kinds.size() <= kMostNames)
    for (const FamilyKind& each : family.kinds) kind.choices.push_back(each.info->name);
  info.params.push_back(std::move(kind));
  if (const FamilyKind* usual = family.find(fallback))
    info.params.insert(info.params.end(), usual->info->params.begin(), usual->info->params.end());
  return info;
}

namespace {

/// What `kind` declares under the name that the expression is; `camera main` means the camera even
/// where a mesh is called main too.
std::optional<Value> declared_value(const std::string& kind, const scene::Expr& expr,
                                    Reading& reading) {
  if (expr.kind != scene::ExprKind::name) return std::nullopt;
  return reading.resolver.declared(kind, expr.text, expr.where, reading.diagnostics);
}

}  // namespace

Arguments block_arguments(const scene::Declaration& declaration, const IsChoice& is_choice,
                          Reading& reading) {
  Arguments arguments;
  for (const scene::Entry& entry : declaration.entries) {
    std::vector<Value> values;
    const scene::Expr& first = *entry.values.at(0);
    if (entry.values.size() == 1 && first.kind == scene::ExprKind::name &&
        is_choice(entry.key, first.text))
      values = {Value::Name{first.text}};
    else if (auto declared = declared_value(entry.key, first, reading);
             declared && entry.values.size() == 1)
      values = {*declared};
    else
      values = reading.evaluator.eval(entry, reading.evaluator.key(declaration));
    const bool faulty =
        std::any_of(values.begin(), values.end(), [](const Value& each) { return each.empty(); });
    Value value = faulty               ? Value()
                  : values.size() == 1 ? std::move(values[0])
                                       : Value(List(values.begin(), values.end()));
    arguments.push_back({entry.key, std::move(value), entry.where});
  }
  if (declaration.incomplete) arguments.push_back({"", Value(), declaration.where});
  return arguments;
}

bool has_block(const scene::Declaration& declaration, Reading& reading) {
  if (!declaration.value) return true;
  reading.diagnostics.error(
      declaration.where,
      fmt::format("'{}' is written with a block, not with '='", declaration.kind),
      fmt::format("for instance: {} {}{} {{ ... }}", declaration.kind, declaration.name,
                  declaration.kind == "render" ? "" : " on NAME"));
  return false;
}

Value target_value(const std::string& kind, const scene::Declaration& declaration, size_t number,
                   Reading& reading) {
  const scene::Expr& target = declaration.target_at(number);
  if (auto value = declared_value(kind, target, reading)) return *value;
  const RandomKey key = reading.evaluator.key(declaration).at("on");
  return reading.evaluator.eval(target, number == 0 ? key : key.at(number));
}

void report_no_target(const std::string& kind, const scene::Declaration& declaration,
                      Reading& reading) {
  reading.diagnostics.error(
      declaration.where, fmt::format("'{}' needs 'on' and a {}", declaration.kind, kind),
      fmt::format("{} {} on NAME {{ ... }}", declaration.kind, declaration.name));
}

namespace {

/// Makes the kind `name` of the family; nothing when it has none.
std::optional<Value> make(const Family& family, const std::string& name, const Arguments& arguments,
                          const SourceLocation& where, Reading& reading) {
  Diagnostics own;
  auto value = reading.resolver.make(family, name, arguments, where, own);
  reading.evaluator.report(own, arguments);
  return value;
}

Value report_unknown(const Family& family, const std::string& name, const SourceLocation& where,
                     Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const FamilyKind& kind : family.kinds) names.push_back(kind.info->name);
  diagnostics.error(where, fmt::format("there is no {} '{}'", family.type, name),
                    names.size() <= kMostNames || !nearest_name(name, names).empty()
                        ? suggestion(name, names)
                        : "'vug list' shows them all");
  return Value();
}

}  // namespace

Value kind_value(const Family& family, const scene::Expr& expr, RandomKey key, Reading& reading) {
  const bool called = expr.kind == scene::ExprKind::call && !expr.method;
  if ((called || expr.kind == scene::ExprKind::name) && family.find(expr.text))
    return *make(family, expr.text, called ? reading.evaluator.arguments(expr, key) : Arguments{},
                 expr.where, reading);
  Value value = reading.evaluator.eval(expr, key);
  if (value.get<Value::Name>())
    return report_unknown(family, expr.text, expr.where, reading.diagnostics);
  return value;
}

namespace {

Value read_block_family(const Family& family, const std::string& fallback,
                        const scene::Declaration& declaration, Reading& reading) {
  std::string name = fallback;
  SourceLocation where = declaration.where;
  const IsChoice is_choice = [&](const std::string& key, const std::string& word) {
    if (key == "kind") return family.find(word) != nullptr;
    return std::any_of(family.kinds.begin(), family.kinds.end(),
                       [&](const FamilyKind& kind) { return has_choice(*kind.info, key, word); });
  };
  Arguments arguments = block_arguments(declaration, is_choice, reading);
  bool told = false;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].name != "kind") continue;
    if (arguments[i].value.empty()) return Value();
    told = true;
    const auto* given = arguments[i].value.get<Value::Name>();
    where = arguments[i].where;
    name = given ? given->text : to_string(arguments[i].value);
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  if (!told && declaration.incomplete && reading.document.skipped.may_mention("kind"))
    return Value();  // it may stand among the lost entries
  if (name.empty() && declaration.incomplete) return Value();
  if (name.empty()) {
    reading.diagnostics.error(where, fmt::format("'{}' needs a kind", declaration.name),
                              fmt::format("{} {} = KIND(...), or 'kind KIND' in the block",
                                          declaration.kind, declaration.name));
    return Value();
  }
  if (auto value = make(family, name, arguments, where, reading)) return *value;
  return report_unknown(family, name, where, reading.diagnostics);
}

}  // namespace

Value read_family(const std::string& type, const std::string& fallback,
                  const scene::Declaration& declaration, Reading& reading) {
  const Family& family = *find_family(type);
  if (!declaration.value) return read_block_family(family, fallback, declaration, reading);
  const scene::Expr& expr = *declaration.value;
  const RandomKey key = reading.evaluator.key(declaration);
  if (expr.kind == scene::ExprKind::call && !expr.method && family.find(expr.text)) {
    const Arguments arguments = reading.evaluator.arguments(expr, key);
    return *make(family, expr.text, arguments, expr.where, reading);
  }
  Value value = reading.evaluator.eval(expr, key);
  if (value.empty()) return value;
  const Object* object = value.get<Object>();
  if (object && object->type == type) return value;
  if (expr.kind == scene::ExprKind::call && !expr.method)
    return report_unknown(family, expr.text, expr.where, reading.diagnostics);
  Diagnostics own;
  own.error(expr.where,
            fmt::format("'{}' expects a {}, not {}", declaration.name, type, value.type_name()));
  reading.evaluator.report(own, {{"", value, expr.where}});
  return Value();
}

}  // namespace vug::loading

std::optional<vug::shot::AnyMesh> vug::ValueTraits<vug::shot::AnyMesh>::read(const Value& value) {
  if (const auto* mesh = value.object<shot::MeshPtr>()) return shot::AnyMesh{*mesh};
  const auto* volume = value.object<shot::VolumePtr>();
  if (!volume || (*volume)->fog) return std::nullopt;
  return shot::AnyMesh{shot::plain_mesh(*volume)};
}
