// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/trs.h>
#include <vug/exchange/usd_text.h>

#include <fmt/ranges.h>

namespace vug::exchange {

UsdText& UsdText::def(const std::string& type, const std::string& name,
                      const std::vector<std::string>& metadata) {
  if (metadata.empty()) return line("def {} \"{}\"", type, name).open("{");
  line("def {} \"{}\" (", type, name);
  ++depth_;
  for (const std::string& each : metadata) line("{}", each);
  --depth_;
  return line(")").open("{");
}

UsdText& UsdText::open(const std::string& text) {
  line("{}", text);
  ++depth_;
  return *this;
}

UsdText& UsdText::end() {
  --depth_;
  return line("}}");
}

UsdText& UsdText::place(const Transform& place) {
  if (is_identity(place)) return *this;
  const auto m = matrix(place);
  std::vector<std::string> rows;
  for (size_t row = 0; row < 4; ++row)
    rows.push_back(fmt::format("({}, {}, {}, {})", m[4 * row], m[4 * row + 1], m[4 * row + 2],
                               m[4 * row + 3]));
  line("matrix4d xformOp:transform = ( {} )", fmt::join(rows, ", "));
  return line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
}

void UsdText::indent() {
  for (size_t i = 0; i < depth_; ++i) out_.text("    ");
}

std::string usd_string(const std::string& text) {
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

std::string usd_tuple(const Vec3d& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

}  // namespace vug::exchange
