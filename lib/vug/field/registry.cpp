#include <vug/field/registry.h>

#include <fmt/format.h>

namespace vug::field {

#define VUG_KIND(name) &name##_kind(),

const std::vector<const FieldKind*>& primitives() {
  static const std::vector<const FieldKind*> kinds = {
#include <vug/field/primitives_kinds.inc>
  };
  return kinds;
}

const std::vector<const FieldKind*>& operators() {
  static const std::vector<const FieldKind*> kinds = {
#include <vug/field/operators_kinds.inc>
  };
  return kinds;
}

const std::vector<const FieldKind*>& deformers() {
  static const std::vector<const FieldKind*> kinds = {
#include <vug/field/deformers_kinds.inc>
  };
  return kinds;
}

const std::vector<const FieldKind*>& details() {
  static const std::vector<const FieldKind*> kinds = {
#include <vug/field/detail_kinds.inc>
  };
  return kinds;
}

const std::vector<const BlendKind*>& blends() {
  static const std::vector<const BlendKind*> kinds = {
#include <vug/field/blends_kinds.inc>
  };
  return kinds;
}

#undef VUG_KIND

const std::vector<const FieldKind*>& field_kinds() {
  static const std::vector<const FieldKind*> kinds = [] {
    std::vector<const FieldKind*> all = primitives();
    all.insert(all.end(), operators().begin(), operators().end());
    all.insert(all.end(), deformers().begin(), deformers().end());
    all.insert(all.end(), details().begin(), details().end());
    return all;
  }();
  return kinds;
}

Field make(const std::string& kind, const std::vector<std::pair<std::string, Value>>& params) {
  const FieldKind* found = find_kind(field_kinds(), kind);
  if (!found) {
    std::vector<std::string> names;
    for (const FieldKind* k : field_kinds()) names.push_back(k->info.name);
    throw Error(ErrorCode::bad_input, fmt::format("there is no field '{}'", kind), {},
                suggestion(kind, names));
  }
  Arguments arguments;
  for (const auto& [name, value] : params) arguments.push_back({name, value, {}});
  Diagnostics diagnostics;
  std::optional<Field> field = found->make(arguments, {}, diagnostics);
  if (field) return *field;
  std::string message;
  for (const Diagnostic& d : diagnostics.all())
    message += (message.empty() ? "" : "; ") + d.message;
  throw Error(ErrorCode::bad_input, message);
}

}  // namespace vug::field
