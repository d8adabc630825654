// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: writes USD's text format (.usda).
#pragma once

#include <vug/exchange/usd_layer.h>
#include <vug/mesh/byte_writer.h>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace vug::exchange {

/// Writes lines with indentation and blocks in braces. Numbers are the shortest that read back
/// as the same value.
class UsdText : public UsdLayer {
 public:
  explicit UsdText(const mesh::ByteSink& sink) : out_(sink) {}

  using UsdLayer::begin_prim;
  using UsdLayer::begin_variant;
  void header(const UsdHeader& header) override;
  void begin_prim(const std::string& type, const std::string& name,
                  const UsdPrimMetadata& metadata) override;
  void begin_variant_set(const std::string& name) override;
  void begin_variant(const std::string& name, const UsdPrimMetadata& metadata) override;
  void end() override;
  void attribute(const UsdAttribute& attribute, const UsdValue& value) override;
  void connection(const UsdAttribute& attribute, const std::string& source) override;
  void relationship(const std::string& name, const std::string& target) override;
  void relationships(const std::string& name, const std::vector<std::string>& targets) override;
  void finish() override { out_.finish(); }

 private:
  template <class... Parts>
  void line(fmt::format_string<Parts...> form, Parts&&... parts) {
    indent();
    out_.text(fmt::format(form, std::forward<Parts>(parts)...)).text("\n");
  }
  void indent();
  /// Opens a block after a line of text and the metadata in brackets.
  void open(const std::string& text, const UsdPrimMetadata& metadata, bool same_line);
  template <class T>
  void numbers(const T* values, size_t count, int arity);

  mesh::ByteWriter out_;
  size_t depth_ = 0;
};

}  // namespace vug::exchange
