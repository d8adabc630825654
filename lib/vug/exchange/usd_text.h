// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: a writer for USD's text format.
#pragma once

#include <vug/base/transform.h>
#include <vug/mesh/byte_writer.h>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace vug::exchange {

/// Writes lines with indentation and blocks in braces. Numbers are the shortest that read back
/// as the same value.
class UsdText {
 public:
  /// `depth`: the number of blocks around the text.
  explicit UsdText(const mesh::ByteSink& sink, size_t depth = 0) : out_(sink), depth_(depth) {}

  template <class... Parts>
  UsdText& line(fmt::format_string<Parts...> form, Parts&&... parts) {
    indent();
    out_.text(fmt::format(form, std::forward<Parts>(parts)...)).text("\n");
    return *this;
  }
  /// Opens `def TYPE "NAME" (metadata) {`; end() closes it.
  UsdText& def(const std::string& type, const std::string& name,
               const std::vector<std::string>& metadata = {});
  UsdText& open(const std::string& text);
  UsdText& end();

  /// Writes `TYPE[] NAME = [(...), ...]` with tuples of `arity` numbers, followed by the metadata
  /// in brackets.
  template <class T>
  UsdText& array(const std::string& type, const std::string& name, const T* values, size_t count,
                 int arity, const std::string& metadata = {}) {
    indent();
    out_.text(type).text("[] ").text(name).text(" = [");
    for (size_t i = 0; i < count; ++i) {
      if (i > 0) out_.text(", ");
      if (arity > 1) out_.text("(");
      for (int k = 0; k < arity; ++k) {
        if (k > 0) out_.text(", ");
        out_.number(values[i * static_cast<size_t>(arity) + static_cast<size_t>(k)]);
      }
      if (arity > 1) out_.text(")");
    }
    out_.text("]").text(metadata).text("\n");
    return *this;
  }
  /// Writes the transform of a prim; nothing for the identity.
  UsdText& place(const Transform& place);
  void finish() { out_.finish(); }

 private:
  void indent();

  mesh::ByteWriter out_;
  size_t depth_;
};

/// The text in quotes with escapes.
std::string usd_string(const std::string& text);
/// (x, y, z)
std::string usd_tuple(const Vec3d& v);

}  // namespace vug::exchange
