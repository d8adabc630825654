// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/exchange/crate_coding.h>
#include <vug/exchange/usd_crate.h>

#include <Imath/half.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace vug::exchange {
namespace {

/// The storage of a type name of USD: its tuples have `arity` numbers.
struct ValueType {
  CrateType type;
  size_t arity;
};

ValueType value_type(const std::string& name) {
  static const std::map<std::string, ValueType> known = {
      {"bool", {CrateType::boolean, 1}},   {"int", {CrateType::int32, 1}},
      {"float", {CrateType::float32, 1}},  {"double", {CrateType::float64, 1}},
      {"float2", {CrateType::vec2f, 2}},   {"float3", {CrateType::vec3f, 3}},
      {"color3f", {CrateType::vec3f, 3}},  {"point3f", {CrateType::vec3f, 3}},
      {"normal3f", {CrateType::vec3f, 3}}, {"vector3f", {CrateType::vec3f, 3}},
      {"float4", {CrateType::vec4f, 4}},   {"quatf", {CrateType::quatf, 4}},
      {"quath", {CrateType::quath, 4}},    {"matrix4d", {CrateType::matrix4d, 16}},
      {"token", {CrateType::token, 1}},    {"string", {CrateType::string, 1}},
      {"asset", {CrateType::asset, 1}},
  };
  const auto found = known.find(name);
  if (found == known.end())
    throw Error(ErrorCode::internal, fmt::format("binary USD files of type '{}'", name));
  return found->second;
}

/// The float that readers of the text format get: the nearest one to the decimals, which may differ
/// from the nearest one to `value` if that is half-way between two floats. The largest float for
/// numbers beyond.
float narrowed(double value) {
  constexpr float kMost = std::numeric_limits<float>::max();
  if (!std::isfinite(value)) return static_cast<float>(value);
  if (std::fabs(value) > static_cast<double>(kMost))
    return std::copysign(kMost, static_cast<float>(value > 0 ? 1 : -1));
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  float out = 0;
  std::from_chars(text, end, out);
  return out;
}

/// Whether a byte can hold the number: a whole number, and not the negative zero.
bool fits_byte(double number) {
  return number >= -128 && number <= 127 && number == std::floor(number) &&
         !(number == 0 && std::signbit(number));
}

/// Numbers as bytes of a payload if each of them fits.
template <class T>
bool inline_bytes(const T* numbers, size_t count, uint64_t& payload) {
  payload = 0;
  for (size_t i = 0; i < count; ++i) {
    if (!fits_byte(numbers[i])) return false;
    const auto byte = static_cast<uint8_t>(static_cast<int8_t>(numbers[i]));
    payload |= static_cast<uint64_t>(byte) << (8 * i);
  }
  return true;
}

/// The diagonal of a matrix whose other numbers are zero, as bytes.
bool inline_diagonal(const UsdMatrix& matrix, uint64_t& payload) {
  double diagonal[4];
  for (size_t i = 0; i < matrix.size(); ++i) {
    if (i % 5 == 0)
      diagonal[i / 5] = matrix[i];
    else if (matrix[i] != 0 || std::signbit(matrix[i]))
      return false;
  }
  return inline_bytes(diagonal, 4, payload);
}

uint64_t float_bits(float value) {
  uint32_t out;
  std::memcpy(&out, &value, sizeof out);
  return out;
}

std::string count_bytes(size_t count) { return crate_bytes<uint64_t>(count); }

constexpr uint64_t kSpecifierDef = 0, kSpecifierOver = 1, kUniform = 1;

}  // namespace

UsdCrate::UsdCrate(const mesh::ByteSink& sink) : out_(sink) {
  write(std::string(kCrateHeader, '\0'));
}

void UsdCrate::write(std::string_view bytes) {
  out_.text(bytes);
  offset_ += bytes.size();
}

void UsdCrate::align() { write(std::string((8 - offset_ % 8) % 8, '\0')); }

// Specs.

std::pair<uint32_t, CrateRep> UsdCrate::field(const char* name, CrateRep value) {
  return {tokens_.token(name), value};
}

void UsdCrate::open(uint32_t path, CrateSpec type, CrateFields::Set fields) {
  open_.push_back({specs_.size(), path});
  open_.back().fields = std::move(fields);
  specs_.push_back({path, type});
}

void UsdCrate::header(const UsdHeader& header) {
  const double unit = header.space.metres_per_unit;
  open(CratePaths::kRoot, CrateSpec::pseudo_root,
       {field("customLayerData", custom_layer_data(header.provenance)),
        field("defaultPrim", token(header.default_prim)), field("metersPerUnit", number(unit)),
        field("upAxis", token(header.space.up == UpAxis::y ? "Y" : "Z"))});
}

void UsdCrate::begin_prim(const std::string& type, const std::string& name,
                          const UsdPrimMetadata& metadata) {
  open_.back().prims.push_back(tokens_.token(name));
  CrateFields::Set fields = {
      field("specifier", crate_rep(CrateType::specifier, kSpecifierDef, kCrateInlined)),
      field("typeName", token(type))};
  add_metadata(metadata, fields);
  open(paths_.child(open_.back().path, name), CrateSpec::prim, std::move(fields));
}

void UsdCrate::begin_variant_set(const std::string& name) {
  open_.back().variant_sets.push_back(tokens_.token(name));
  open(paths_.child(open_.back().path, fmt::format("{{{}=}}", name)), CrateSpec::variant_set, {});
  open_.back().variant_set = name;
}

void UsdCrate::begin_variant(const std::string& name, const UsdPrimMetadata& metadata) {
  const std::string element = fmt::format("{{{}={}}}", open_.back().variant_set, name);
  open_.back().variants.push_back(tokens_.token(name));
  CrateFields::Set fields = {
      field("specifier", crate_rep(CrateType::specifier, kSpecifierOver, kCrateInlined))};
  add_metadata(metadata, fields);
  // The path of a variant is that of the prim with the variant as its last element.
  const uint32_t prim = open_[open_.size() - 2].path;
  open(paths_.child(prim, element), CrateSpec::variant, std::move(fields));
}

void UsdCrate::end() {
  Open spec = std::move(open_.back());
  open_.pop_back();
  const auto add = [&](const char* name, const Tokens& tokens) {
    if (!tokens.empty()) spec.fields.push_back(field(name, token_vector(tokens)));
  };
  add("properties", spec.properties);
  add("primChildren", spec.prims);
  add("variantSetChildren", spec.variant_sets);
  add("variantChildren", spec.variants);
  specs_[spec.spec].fields = fields_.add(spec.fields);
}

void UsdCrate::add_metadata(const UsdPrimMetadata& metadata, CrateFields::Set& fields) {
  using Field = UsdPrimMetadatum::Field;
  const auto prepended = [&](const std::string& item) {
    return std::string(1, static_cast<char>(kCratePrependedList)) + count_bytes(1) + item;
  };
  // Offset and scale of time.
  const std::string no_offset = crate_bytes(0.0) + crate_bytes(1.0);
  for (const UsdPrimMetadatum& each : metadata) {
    const std::string& value = each.value;
    switch (each.field) {
      case Field::kind:
        fields.push_back(field("kind", token(value)));
        break;
      case Field::api_schema:
        fields.push_back(field("apiSchemas", stored(CrateType::token_list,
                                                    prepended(crate_bytes(tokens_.token(value))))));
        break;
      case Field::variant_set:
        fields.push_back(
            field("variantSetNames",
                  stored(CrateType::string_list, prepended(crate_bytes(tokens_.string(value))))));
        break;
      case Field::variant_selection:
        fields.push_back(
            field("variantSelection",
                  stored(CrateType::variant_selections,
                         count_bytes(1) + crate_bytes(tokens_.string(each.variant_set)) +
                             crate_bytes(tokens_.string(value)))));
        break;
      case Field::payload:
        fields.push_back(field(
            "payload",
            stored(CrateType::payload_list, prepended(crate_bytes(tokens_.string(value)) +
                                                      crate_bytes(paths_.empty()) + no_offset))));
        break;
      case Field::reference:
        fields.push_back(field("references", stored(CrateType::reference_list,
                                                    prepended(crate_bytes(tokens_.string("")) +
                                                              crate_bytes(paths_.path(value)) +
                                                              no_offset + count_bytes(0)))));
        break;
    }
  }
}

// Properties.

void UsdCrate::add_property(const std::string& name, CrateSpec type,
                            const CrateFields::Set& fields) {
  open_.back().properties.push_back(tokens_.token(name));
  const uint32_t path = paths_.child(open_.back().path, name, true);
  specs_.push_back({path, type, fields_.add(fields)});
}

CrateFields::Set UsdCrate::attribute_fields(const UsdAttribute& attribute, bool array) {
  CrateFields::Set fields = {field("typeName", token(attribute.type + (array ? "[]" : "")))};
  if (attribute.custom)
    fields.push_back(field("custom", crate_rep(CrateType::boolean, 1, kCrateInlined)));
  if (attribute.uniform)
    fields.push_back(
        field("variability", crate_rep(CrateType::variability, kUniform, kCrateInlined)));
  if (!attribute.interpolation.empty())
    fields.push_back(field("interpolation", token(attribute.interpolation)));
  if (attribute.element_size > 0)
    fields.push_back(field(
        "elementSize",
        crate_rep(CrateType::int32, static_cast<uint64_t>(attribute.element_size), kCrateInlined)));
  return fields;
}

void UsdCrate::attribute(const UsdAttribute& attribute, const UsdValue& value) {
  const bool array = std::holds_alternative<UsdTokens>(value) ||
                     std::holds_alternative<UsdTuples>(value) ||
                     std::holds_alternative<UsdArray>(value);
  CrateFields::Set fields = attribute_fields(attribute, array);
  if (!std::holds_alternative<std::monostate>(value))
    fields.push_back(field("default", value_of(attribute.type, value)));
  add_property(attribute.name, CrateSpec::attribute, fields);
}

void UsdCrate::connection(const UsdAttribute& attribute, const std::string& source) {
  CrateFields::Set fields = attribute_fields(attribute, false);
  fields.push_back(field("connectionPaths", path_list({source})));
  add_property(attribute.name, CrateSpec::attribute, fields);
}

void UsdCrate::relationship(const std::string& name, const std::string& target) {
  relationships(name, {target});
}

void UsdCrate::relationships(const std::string& name, const std::vector<std::string>& targets) {
  add_property(name, CrateSpec::relationship,
               {field("variability", crate_rep(CrateType::variability, kUniform, kCrateInlined)),
                field("targetPaths", path_list(targets))});
}

// Values.

CrateRep UsdCrate::token(const std::string& text) {
  return crate_rep(CrateType::token, tokens_.token(text), kCrateInlined);
}

CrateRep UsdCrate::number(double value) {
  const float narrow = narrowed(value);
  if (static_cast<double>(narrow) == value)
    return crate_rep(CrateType::float64, float_bits(narrow), kCrateInlined);
  return stored(CrateType::float64, crate_bytes(value));
}

CrateRep UsdCrate::stored(CrateType type, const std::string& bytes) {
  const auto [found, fresh] =
      stored_.try_emplace(crate_bytes(type) + bytes, crate_rep(type, offset_));
  if (fresh) write(bytes);
  return found->second;
}

CrateRep UsdCrate::token_vector(const Tokens& tokens) {
  std::string bytes = count_bytes(tokens.size());
  for (const uint32_t each : tokens) bytes += crate_bytes(each);
  return stored(CrateType::token_vector, bytes);
}

CrateRep UsdCrate::path_list(const std::vector<std::string>& paths) {
  std::string bytes(1, static_cast<char>(kCrateExplicitList));
  bytes += count_bytes(paths.size());
  for (const std::string& each : paths) bytes += crate_bytes(paths_.path(each));
  return stored(CrateType::path_list, bytes);
}

/// Each entry has the index of its name, the distance of the value behind it and the value.
CrateRep UsdCrate::custom_layer_data(const Provenance& from) {
  const auto text = [&](const std::string& value) {
    return crate_rep(CrateType::string, tokens_.string(value), kCrateInlined);
  };
  const std::pair<const char*, CrateRep> entries[] = {
      {"vug:frame", number(from.frame)},
      {"vug:recipe", text(from.recipe)},
      {"vug:seed", text(fmt::format("{}", from.seed))},
      {"vug:version", text(from.version)}};
  std::string bytes = count_bytes(std::size(entries));
  for (const auto& [name, value] : entries)
    bytes += crate_bytes(tokens_.string(name)) + crate_bytes<int64_t>(sizeof(int64_t)) +
             crate_bytes(value);
  return stored(CrateType::dictionary, bytes);
}

CrateRep UsdCrate::tuple(const std::string& type, const double* numbers, size_t count) {
  const ValueType stored_as = value_type(type);
  uint64_t payload = 0;
  switch (stored_as.type) {
    case CrateType::boolean:
      return crate_rep(stored_as.type, numbers[0] != 0 ? 1 : 0, kCrateInlined);
    case CrateType::int32:
      return crate_rep(stored_as.type, static_cast<uint32_t>(static_cast<int32_t>(numbers[0])),
                       kCrateInlined);
    case CrateType::float32:
      return crate_rep(stored_as.type, float_bits(narrowed(numbers[0])), kCrateInlined);
    case CrateType::float64:
      return number(numbers[0]);
    default:
      break;
  }
  std::string bytes;
  std::vector<float> narrow;
  for (size_t i = 0; i < count; ++i) narrow.push_back(narrowed(numbers[i]));
  if (inline_bytes(narrow.data(), count, payload))
    return crate_rep(stored_as.type, payload, kCrateInlined);
  for (const float each : narrow) bytes += crate_bytes(each);
  return stored(stored_as.type, bytes);
}

CrateRep UsdCrate::array(CrateType type, const void* data, size_t bytes, size_t count) {
  if (count == 0) return crate_rep(type, 0, kCrateArray);
  const auto [found, fresh] =
      arrays_.try_emplace(crate_bytes(type) + crate_bytes(count) + digest(data, bytes).hex());
  if (!fresh) return found->second;
  align();
  found->second = crate_rep(type, offset_, kCrateArray);
  write(count_bytes(count));
  write({static_cast<const char*>(data), bytes});
  return found->second;
}

CrateRep UsdCrate::integers(const int32_t* numbers, size_t count) {
  if (count < kCrateLeastCompressed)
    return array(CrateType::int32, numbers, count * sizeof *numbers, count);
  const size_t bytes = count * sizeof *numbers;
  const auto [found, fresh] = arrays_.try_emplace(
      crate_bytes(CrateType::int32) + crate_bytes(count) + digest(numbers, bytes).hex());
  if (!fresh) return found->second;
  align();
  found->second = crate_rep(CrateType::int32, offset_, kCrateArray | kCrateCompressed);
  const std::string packed = crate_compress(crate_encode_integers(numbers, count));
  write(count_bytes(count));
  write(count_bytes(packed.size()));
  write(packed);
  return found->second;
}

CrateRep UsdCrate::numbers(const std::string& type, const UsdArray& array) {
  const ValueType stored_as = value_type(type);
  const size_t total = array.count * static_cast<size_t>(array.arity);
  if (const auto* whole = std::get_if<const int32_t*>(&array.numbers))
    return integers(*whole, total);
  if (const auto* whole = std::get_if<const uint32_t*>(&array.numbers))
    return integers(reinterpret_cast<const int32_t*>(*whole), total);
  const float* data = std::get<const float*>(array.numbers);
  if (stored_as.type != CrateType::quatf && stored_as.type != CrateType::quath)
    return this->array(stored_as.type, data, total * sizeof *data, array.count);
  // Crate files have the real part of a quaternion at its end.
  std::vector<float> turned(data, data + total);
  for (size_t i = 0; i < array.count; ++i)
    std::rotate(turned.begin() + static_cast<std::ptrdiff_t>(4 * i),
                turned.begin() + static_cast<std::ptrdiff_t>(4 * i + 1),
                turned.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
  if (stored_as.type == CrateType::quatf)
    return this->array(stored_as.type, turned.data(), total * sizeof(float), array.count);
  std::vector<uint16_t> halves;
  for (const float each : turned) halves.push_back(Imath::half(each).bits());
  return this->array(stored_as.type, halves.data(), total * sizeof(uint16_t), array.count);
}

CrateRep UsdCrate::value_of(const std::string& type, const UsdValue& value) {
  if (const auto* yes = std::get_if<bool>(&value))
    return crate_rep(CrateType::boolean, *yes ? 1 : 0, kCrateInlined);
  if (const auto* whole = std::get_if<int>(&value)) {
    const double number = *whole;
    return tuple(type, &number, 1);
  }
  if (const auto* number = std::get_if<double>(&value)) return tuple(type, number, 1);
  if (const auto* text = std::get_if<UsdToken>(&value)) return token(text->text);
  if (const auto* text = std::get_if<UsdString>(&value))
    return crate_rep(CrateType::string, tokens_.string(text->text), kCrateInlined);
  if (const auto* asset = std::get_if<UsdAsset>(&value))
    return crate_rep(CrateType::asset, tokens_.token(asset->path), kCrateInlined);
  if (const auto* texts = std::get_if<UsdTokens>(&value)) {
    Tokens all;
    for (const std::string& each : *texts) all.push_back(tokens_.token(each));
    return array(CrateType::token, all.data(), all.size() * sizeof(uint32_t), all.size());
  }
  if (const auto* one = std::get_if<UsdTuple>(&value)) return tuple(type, one->data(), one->size());
  if (const auto* many = std::get_if<UsdTuples>(&value)) {
    std::vector<float> all;
    for (const Vec3d& each : *many)
      for (int i = 0; i < 3; ++i) all.push_back(narrowed(each[i]));
    return array(value_type(type).type, all.data(), all.size() * sizeof(float), many->size());
  }
  if (const auto* matrix = std::get_if<UsdMatrix>(&value)) {
    uint64_t payload = 0;
    if (inline_diagonal(*matrix, payload))
      return crate_rep(CrateType::matrix4d, payload, kCrateInlined);
    return stored(CrateType::matrix4d, crate_bytes(*matrix));
  }
  return numbers(type, std::get<UsdArray>(value));
}

// Sections.

void UsdCrate::write_integers(const std::vector<int32_t>& numbers) {
  const std::string packed = crate_compress(crate_encode_integers(numbers.data(), numbers.size()));
  write(count_bytes(packed.size()));
  write(packed);
}

void UsdCrate::write_section(const char* name, const std::function<void()>& write) {
  const uint64_t begin = offset_;
  write();
  std::string text = name;
  text.resize(kCrateSectionName);
  sections_ += text + crate_bytes(begin) + crate_bytes(offset_ - begin);
  ++section_count_;
}

void UsdCrate::finish() {
  end();  // the pseudo-root
  const CratePaths::Encoded tree = paths_.encode();
  write_section("TOKENS", [&] {
    std::string all;
    for (const std::string* each : tokens_.tokens()) (all += *each) += '\0';
    const std::string packed = crate_compress(all);
    write(count_bytes(tokens_.tokens().size()));
    write(count_bytes(all.size()));
    write(count_bytes(packed.size()));
    write(packed);
  });
  write_section("STRINGS", [&] {
    write(count_bytes(tokens_.strings().size()));
    for (const uint32_t each : tokens_.strings()) write(crate_bytes(each));
  });
  write_section("FIELDS", [&] {
    std::vector<int32_t> names;
    std::string values;
    for (const auto& [name, value] : fields_.fields()) {
      names.push_back(static_cast<int32_t>(name));
      values += crate_bytes(value);
    }
    const std::string packed = crate_compress(values);
    write(count_bytes(names.size()));
    write_integers(names);
    write(count_bytes(packed.size()));
    write(packed);
  });
  write_section("FIELDSETS", [&] {
    write(count_bytes(fields_.sets().size()));
    write_integers(fields_.sets());
  });
  write_section("PATHS", [&] {
    write(count_bytes(paths_.size()));
    write(count_bytes(tree.paths.size()));
    write_integers(tree.paths);
    write_integers(tree.elements);
    write_integers(tree.jumps);
  });
  write_section("SPECS", [&] {
    std::vector<int32_t> paths, fields, types;
    for (const Spec& each : specs_) {
      paths.push_back(static_cast<int32_t>(each.path));
      fields.push_back(static_cast<int32_t>(each.fields));
      types.push_back(static_cast<int32_t>(each.type));
    }
    write(count_bytes(specs_.size()));
    write_integers(paths);
    write_integers(fields);
    write_integers(types);
  });
  contents_ = offset_;
  write(count_bytes(section_count_));
  write(sections_);
  out_.finish();
}

std::string UsdCrate::file_header() const {
  std::string out(kCrateMagic);
  out.append(reinterpret_cast<const char*>(kCrateVersion), sizeof kCrateVersion);
  out.resize(16);
  out += crate_bytes(contents_);
  out.resize(kCrateHeader);
  return out;
}

}  // namespace vug::exchange
