// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_text.h>

#include <fmt/ranges.h>

namespace vug::exchange {
namespace {

/// The text in quotes with escapes.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n')
      out += "\\n";
    else if (c == '\r')
      out += "\\r";
    else if (c == '\t')
      out += "\\t";
    else if (c == '"' || c == '\\')
      (out += '\\') += c;
    else
      out += c;
  }
  return out + "\"";
}

/// A number of a value that is not an array of the caller. UsdGeom spells the largest float without
/// the sign of the exponent.
std::string number_text(double number) {
  if (number == kUsdEmptyExtent) return "3.4028235e38";
  if (number == -kUsdEmptyExtent) return "-3.4028235e38";
  return fmt::format("{}", number);
}

std::string tuple_text(const double* numbers, size_t count) {
  std::string out = "(";
  for (size_t i = 0; i < count; ++i) (out += i > 0 ? ", " : "") += number_text(numbers[i]);
  return out + ")";
}

/// The texts of values that are short.
struct ValueText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(const UsdToken& value) const { return quoted(value.text); }
  std::string operator()(const UsdString& value) const { return quoted(value.text); }
  std::string operator()(const UsdAsset& value) const { return "@" + value.path + "@"; }
  std::string operator()(const UsdTokens& value) const {
    std::vector<std::string> all;
    for (const std::string& each : value) all.push_back(quoted(each));
    return fmt::format("[{}]", fmt::join(all, ", "));
  }
  std::string operator()(const UsdTuple& value) const {
    return tuple_text(value.data(), value.size());
  }
  std::string operator()(const UsdTuples& value) const {
    std::vector<std::string> all;
    for (const Vec3d& each : value) all.push_back(tuple_text(&each.x, 3));
    return fmt::format("[{}]", fmt::join(all, ", "));
  }
  std::string operator()(const UsdMatrix& value) const {
    std::vector<std::string> rows;
    for (size_t row = 0; row < 4; ++row) rows.push_back(tuple_text(&value[4 * row], 4));
    return fmt::format("( {} )", fmt::join(rows, ", "));
  }
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const UsdArray&) const { return {}; }
};

std::string metadatum_text(const UsdPrimMetadatum& metadatum) {
  using Field = UsdPrimMetadatum::Field;
  switch (metadatum.field) {
    case Field::api_schema:
      return fmt::format("prepend apiSchemas = [\"{}\"]", metadatum.value);
    case Field::variant_set:
      return fmt::format("prepend variantSets = \"{}\"", metadatum.value);
    case Field::variant_selection:
      return fmt::format("variants = {{ string {} = \"{}\" }}", metadatum.variant_set,
                         metadatum.value);
    case Field::payload:
      return fmt::format("prepend payload = @{}@", metadatum.value);
    case Field::reference:
      return fmt::format("prepend references = <{}>", metadatum.value);
    default:
      return fmt::format("kind = \"{}\"", metadatum.value);
  }
}

bool is_usd_array(const UsdValue& value) {
  return std::holds_alternative<UsdTokens>(value) || std::holds_alternative<UsdTuples>(value) ||
         std::holds_alternative<UsdArray>(value);
}

/// The qualifiers, the type and the name.
std::string declaration(const UsdAttribute& attribute, bool array) {
  return fmt::format("{}{}{}{} {}", attribute.custom ? "custom " : "",
                     attribute.uniform ? "uniform " : "", attribute.type, array ? "[]" : "",
                     attribute.name);
}

std::string metadata_text(const UsdAttribute& attribute) {
  std::vector<std::string> all;
  if (attribute.element_size > 0)
    all.push_back(fmt::format("elementSize = {}", attribute.element_size));
  if (!attribute.interpolation.empty())
    all.push_back(fmt::format("interpolation = \"{}\"", attribute.interpolation));
  return all.empty() ? "" : fmt::format(" ({})", fmt::join(all, " "));
}

}  // namespace

void UsdText::header(const UsdHeader& header) {
  const Provenance& from = header.provenance;
  line("#usda 1.0");
  line("(");
  line("    customLayerData = {{");
  line("        string \"vug:recipe\" = {}", quoted(from.recipe));
  line("        string \"vug:seed\" = \"{}\"", from.seed);
  line("        double \"vug:frame\" = {}", from.frame);
  line("        string \"vug:version\" = {}", quoted(from.version));
  line("    }}");
  line("    defaultPrim = \"{}\"", header.default_prim);
  line("    metersPerUnit = {}", header.space.metres_per_unit);
  line("    upAxis = \"{}\"", header.space.up == UpAxis::y ? "Y" : "Z");
  line(")");
}

void UsdText::open(const std::string& text, const UsdPrimMetadata& metadata, bool same_line) {
  if (metadata.empty()) {
    if (same_line) {
      line("{} {{", text);
    } else {
      line("{}", text);
      line("{{");
    }
  } else {
    line("{} (", text);
    ++depth_;
    for (const UsdPrimMetadatum& each : metadata) line("{}", metadatum_text(each));
    --depth_;
    line("{}", same_line ? ") {" : ")");
    if (!same_line) line("{{");
  }
  ++depth_;
}

void UsdText::begin_prim(const std::string& type, const std::string& name,
                         const UsdPrimMetadata& metadata) {
  open(fmt::format("def {} \"{}\"", type, name), metadata, false);
}

void UsdText::begin_variant_set(const std::string& name) {
  open(fmt::format("variantSet \"{}\" =", name), {}, true);
}

void UsdText::begin_variant(const std::string& name, const UsdPrimMetadata& metadata) {
  open(fmt::format("\"{}\"", name), metadata, true);
}

void UsdText::end() {
  --depth_;
  line("}}");
}

template <class T>
void UsdText::numbers(const T* values, size_t count, int arity) {
  out_.text("[");
  for (size_t i = 0; i < count; ++i) {
    if (i > 0) out_.text(", ");
    if (arity > 1) out_.text("(");
    for (int k = 0; k < arity; ++k) {
      if (k > 0) out_.text(", ");
      out_.number(values[i * static_cast<size_t>(arity) + static_cast<size_t>(k)]);
    }
    if (arity > 1) out_.text(")");
  }
  out_.text("]");
}

void UsdText::attribute(const UsdAttribute& attribute, const UsdValue& value) {
  indent();
  out_.text(declaration(attribute, is_usd_array(value)));
  if (!std::holds_alternative<std::monostate>(value)) out_.text(" = ");
  if (const auto* array = std::get_if<UsdArray>(&value))
    std::visit([&](const auto* data) { numbers(data, array->count, array->arity); },
               array->numbers);
  else
    out_.text(std::visit(ValueText(), value));
  out_.text(metadata_text(attribute)).text("\n");
}

void UsdText::connection(const UsdAttribute& attribute, const std::string& source) {
  line("{}.connect = <{}>", declaration(attribute, false), source);
}

void UsdText::relationship(const std::string& name, const std::string& target) {
  line("rel {} = <{}>", name, target);
}

void UsdText::relationships(const std::string& name, const std::vector<std::string>& targets) {
  std::vector<std::string> all;
  for (const std::string& each : targets) all.push_back("<" + each + ">");
  line("rel {} = [{}]", name, fmt::join(all, ", "));
}

void UsdText::indent() {
  for (size_t i = 0; i < depth_; ++i) out_.text("    ");
}

}  // namespace vug::exchange
