// SPDX-License-Identifier: Apache-2.0
#include <vug/base/srgb.h>
#include <vug/language/colours.h>
#include <vug/language/kinds.h>
#include <vug/language/syntax_visitor.h>
#include <vug/scene/functions.h>
#include <vug/scene/text_at.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vug::language {
namespace {

using scene::Expr;
using scene::ExprKind;

/// Words in the names of parameters that are colours.
constexpr const char* kColourWords[] = {"color", "albedo", "radiance", "tint",          "paint",
                                        "under", "over",   "emission", "specular_color"};

bool names_colour(const std::string& name) {
  return std::any_of(std::begin(kColourWords), std::end(kColourWords),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

/// Three plain numbers, none of them negative.
std::optional<Vec3d> plain_vector(const Expr& expr) {
  if (expr.kind != ExprKind::vector || expr.operands.size() != 3) return std::nullopt;
  Vec3d out;
  for (int i = 0; i < 3; ++i) {
    const Expr& part = *expr.operands[static_cast<size_t>(i)].value;
    if (part.kind != ExprKind::number || part.number.dimension != Dimension::none)
      return std::nullopt;
    out[i] = part.number.value;
  }
  return out;
}

Swatch swatch_of(const SourceLocation& range, const Vec3d& linear) {
  Swatch swatch{range, {}, std::max({1.0, linear.x, linear.y, linear.z})};
  for (int i = 0; i < 3; ++i)
    swatch.srgb[i] = std::clamp(srgb_encode(linear[i] / swatch.scale), 0.0, 1.0);
  return swatch;
}

/// The value of a call of srgb with literals.
std::optional<Vec3d> code_value(const Expr& expr) {
  if (expr.kind != ExprKind::call || expr.text != "srgb" || expr.method) return std::nullopt;
  Arguments arguments;
  for (const scene::Operand& each : expr.operands) {
    if (each.value->kind == ExprKind::text)
      arguments.push_back({each.name, Value(each.value->text), each.where});
    else if (each.value->kind == ExprKind::number)
      arguments.push_back({each.name, Value(each.value->number), each.where});
    else
      return std::nullopt;
  }
  Diagnostics ignored;
  const auto value = scene::find_function("srgb")->apply(arguments, {expr.where, ignored});
  const auto* vector = value ? value->get<Value::Vector>() : nullptr;
  return vector ? std::optional(vector->value) : std::nullopt;
}

}  // namespace

std::vector<Swatch> swatches_of(const Analysis& analysis) {
  std::vector<Swatch> all;
  const auto add = [&](const SourceLocation& where, const std::optional<Vec3d>& linear) {
    if (linear && where.file == analysis.file && where.has_end())
      all.push_back(swatch_of(where, *linear));
  };
  // The extent of a vector contains its parentheses.
  const auto add_vector = [&](const std::string& name, const Expr& value) {
    const Vec3d limit(1e9, 1e9, 1e9);
    const auto linear = plain_vector(value);
    const bool valid = linear && linear->x >= 0 && linear->y >= 0 && linear->z >= 0 &&
                       linear->x < limit.x && linear->y < limit.y && linear->z < limit.z;
    if (names_colour(name) && valid) add(value.extent, linear);
  };
  SyntaxVisitor visitor;
  visitor.entry = [&](const scene::Entry& entry) {
    for (const scene::ExprPtr& value : entry.values) add_vector(entry.key, *value);
  };
  visitor.expression = [&](const Expr& expr) {
    add(expr.extent, code_value(expr));
    if (expr.kind != ExprKind::call) return;
    for (size_t i = 0; i < expr.operands.size(); ++i) {
      std::string name = expr.operands[i].name;
      for (const CallableKind& kind : callable_kinds(expr.text))
        if (const ParamInfo* param = find_param(*kind.info, i, name); param && name.empty())
          name = param->name;
      add_vector(name, *expr.operands[i].value);
    }
  };
  visitor.visit(analysis.document);
  std::sort(all.begin(), all.end(),
            [](const Swatch& a, const Swatch& b) { return begin_of(a.range) < begin_of(b.range); });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const Swatch& a, const Swatch& b) { return a.range == b.range; }),
            all.end());
  return all;
}

bool is_code(const Analysis& analysis, const SourceLocation& range) {
  return scene::text_at(analysis.text, range).starts_with("srgb");
}

std::vector<std::string> colour_texts(const Swatch& swatch, const Vec3d& srgb, bool as_code) {
  const auto byte = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
  };
  const auto linear = [&](double value) {
    return quantity_text(std::clamp(swatch.scale * srgb_decode(value), 0.0, 1e9), Dimension::none);
  };
  std::vector<std::string> texts = {
      fmt::format("({}, {}, {})", linear(srgb.x), linear(srgb.y), linear(srgb.z)),
      fmt::format("srgb(\"#{:02x}{:02x}{:02x}\")", byte(srgb.x), byte(srgb.y), byte(srgb.z))};
  if (as_code) std::swap(texts[0], texts[1]);
  if (swatch.scale > 1) texts = {texts[as_code ? 1 : 0]};  // a code cannot be brighter than white
  return texts;
}

}  // namespace vug::language
