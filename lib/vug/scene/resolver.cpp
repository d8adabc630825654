// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/resolver.h>

namespace vug::scene {

std::optional<Value> Resolver::name(const std::string&, const SourceLocation&, Diagnostics&) {
  return std::nullopt;
}

std::optional<Value> Resolver::declared(const std::string&, const std::string&,
                                        const SourceLocation&, Diagnostics&) {
  return std::nullopt;
}

std::string_view Resolver::expected_type(const std::string&, size_t, const std::string&) const {
  return {};
}

std::optional<Value> Resolver::call(const std::string&, const Arguments&, const SourceLocation&,
                                    const CallContext&, Diagnostics&) {
  return std::nullopt;
}

bool Resolver::is_choice(const std::string&, size_t, const std::string&, const std::string&) const {
  return false;
}

bool Resolver::is_word(const std::string&) const { return false; }

std::optional<Value> Resolver::binary(char, const Value&, const Value&, const SourceLocation&,
                                      Diagnostics&) {
  return std::nullopt;
}

std::optional<Value> Resolver::unary(char, const Value&, const SourceLocation&, Diagnostics&) {
  return std::nullopt;
}

}  // namespace vug::scene
