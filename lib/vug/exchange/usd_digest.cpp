// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/usd_digest.h>

namespace vug::exchange {
namespace {

/// Adds the bytes of a value. Sizes are added, too, so that different sequences of values have
/// different bytes.
struct ValueHasher {
  Hasher& out;

  void text(const std::string& value) const { out.add_value(value.size()).add(value); }
  void operator()(std::monostate) const {}
  void operator()(bool value) const { out.add_value(value); }
  void operator()(int value) const { out.add_value(value); }
  void operator()(double value) const { out.add_value(value); }
  void operator()(const UsdToken& value) const { text(value.text); }
  void operator()(const UsdString& value) const { text(value.text); }
  void operator()(const UsdAsset& value) const { text(value.path); }
  void operator()(const UsdTokens& value) const {
    out.add_value(value.size());
    for (const std::string& each : value) text(each);
  }
  void operator()(const UsdTuple& value) const {
    out.add_value(value.size()).add(value.data(), value.size() * sizeof(double));
  }
  void operator()(const UsdTuples& value) const {
    out.add_value(value.size());
    for (const Vec3d& each : value) out.add(&each.x, 3 * sizeof(double));
  }
  void operator()(const UsdMatrix& value) const { out.add(value.data(), sizeof value); }
  void operator()(const UsdArray& value) const {
    out.add_value(value.count).add_value(value.arity).add_value(value.numbers.index());
    const size_t numbers = value.count * static_cast<size_t>(value.arity);
    std::visit([&](const auto* data) { out.add(data, numbers * sizeof *data); }, value.numbers);
  }
};

/// Distinguishes the calls.
enum class Call : char { header, prim, set, variant, end, attribute, connection, one, many };

}  // namespace

void UsdDigest::add(const std::string& text) { hasher_.add_value(text.size()).add(text); }

void UsdDigest::add(const UsdAttribute& attribute) {
  add(attribute.type);
  add(attribute.name);
  add(attribute.interpolation);
  hasher_.add_value(attribute.uniform)
      .add_value(attribute.custom)
      .add_value(attribute.element_size);
}

void UsdDigest::add(const UsdPrimMetadata& metadata) {
  hasher_.add_value(metadata.size());
  for (const UsdPrimMetadatum& each : metadata) {
    hasher_.add_value(each.field);
    add(each.value);
    add(each.variant_set);
  }
}

void UsdDigest::header(const UsdHeader& header) {
  hasher_.add_value(Call::header);
  add(header.default_prim);
  add(header.provenance.recipe);
  add(header.provenance.version);
  hasher_.add_value(header.provenance.seed)
      .add_value(header.provenance.frame)
      .add_value(header.space.up)
      .add_value(header.space.metres_per_unit);
}

void UsdDigest::begin_prim(const std::string& type, const std::string& name,
                           const UsdPrimMetadata& metadata) {
  hasher_.add_value(Call::prim);
  add(type);
  add(name);
  add(metadata);
}

void UsdDigest::begin_variant_set(const std::string& name) {
  hasher_.add_value(Call::set);
  add(name);
}

void UsdDigest::begin_variant(const std::string& name, const UsdPrimMetadata& metadata) {
  hasher_.add_value(Call::variant);
  add(name);
  add(metadata);
}

void UsdDigest::end() { hasher_.add_value(Call::end); }

void UsdDigest::attribute(const UsdAttribute& attribute, const UsdValue& value) {
  hasher_.add_value(Call::attribute);
  add(attribute);
  hasher_.add_value(value.index());
  std::visit(ValueHasher{hasher_}, value);
}

void UsdDigest::connection(const UsdAttribute& attribute, const std::string& source) {
  hasher_.add_value(Call::connection);
  add(attribute);
  add(source);
}

void UsdDigest::relationship(const std::string& name, const std::string& target) {
  hasher_.add_value(Call::one);
  add(name);
  add(target);
}

void UsdDigest::relationships(const std::string& name, const std::vector<std::string>& targets) {
  hasher_.add_value(Call::many).add_value(targets.size());
  add(name);
  for (const std::string& each : targets) add(each);
}

Digest UsdDigest::take() {
  const Digest all = hasher_.finish();
  hasher_ = Hasher();
  return all;
}

}  // namespace vug::exchange
