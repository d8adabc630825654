// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/language/literal_frame.h>
#include <vug/language/literal_handles.h>
#include <vug/loading/reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace vug::language {
namespace {

using scene::Expr;
using scene::ExprKind;

/// Finds the value that a statement or a call gives to a parameter; null if it gives none.
using GivenValue = std::function<const Expr*(const std::string& param)>;

constexpr const char* kComponents[] = {"x", "y", "z"};

std::string reason_for(const Expr& expr) {
  return draws_at_random(expr) ? "it is drawn at random" : "it is an expression";
}

class HandleCollector {
 public:
  HandleCollector(const Analysis& analysis, const Statement& statement, StatementHandles& out)
      : analysis_(analysis), statement_(statement), values_(analysis), out_(out) {}

  void collect() {
    if (statement_.declaration) add_declaration(*statement_.declaration);
    if (statement_.let && statement_.let->value) add_calls(*statement_.let->value, "field");
    if (statement_.def && statement_.def->body) add_calls(*statement_.def->body, "field");
    if (statement_.grammar) add_entries(statement_.grammar->options, statement_.grammar->kind, "");
    name_handles();
  }

 private:
  void add_declaration(const scene::Declaration& declaration) {
    if (declaration.value) add_calls(*declaration.value, declaration.kind);
    const scene::Entry* kind = declaration.find_entry("kind");
    add_entries(declaration.entries, declaration.kind, kind ? kind->values.front()->text : "");
  }

  void add_entries(const std::vector<scene::Entry>& entries, const std::string& keyword,
                   const std::string& kind) {
    const std::vector<const ParamInfo*> params = block_params(keyword, kind);
    const GivenValue given = [&](const std::string& name) -> const Expr* {
      for (const scene::Entry& each : entries)
        if (each.key == name) return each.values.front().get();
      return nullptr;
    };
    for (const scene::Entry& entry : entries)
      for (const scene::ExprPtr& value : entry.values) {
        const auto param = std::find_if(params.begin(), params.end(), [&](const ParamInfo* each) {
          return each->name == entry.key;
        });
        if (param != params.end()) add_value(*value, **param, params, keyword, given, {});
        add_calls(*value, param == params.end() ? "" : (*param)->type);
      }
  }

  /// Adds the arguments of all calls of an expression whose value has the type.
  void add_calls(const Expr& root, const std::string& type) {
    EnclosingChain chain;
    walk(root, chain, [&](const Expr& call, const EnclosingChain& around) {
      if (call.kind != ExprKind::call) return true;
      const auto meaning =
          kind_of_call(call, analysis_.document, around.empty() ? type : std::string("field"));
      if (!meaning) return true;
      std::vector<const ParamInfo*> params;
      for (const ParamInfo& each : meaning->info.params) params.push_back(&each);
      const GivenValue given = [&](const std::string& name) {
        return operand_for(call, meaning->info, name);
      };
      for (size_t i = 0; i < call.operands.size(); ++i) {
        const scene::Operand& operand = call.operands[i];
        const ParamInfo* param = find_param(meaning->info, i, operand.name);
        // A receiver's position is that of a field, which is not a place.
        if (!param || !operand.value) continue;
        EnclosingChain inner = around;
        inner.push_back({&call, i});
        add_value(*operand.value, *param, params, meaning->info.category, given, inner);
      }
      return true;
    });
  }

  /// Adds a handle, or the reason why it is missing, if the parameter has a role.
  void add_value(const Expr& value, const ParamInfo& param,
                 const std::vector<const ParamInfo*>& params, const std::string& category,
                 const GivenValue& given, const EnclosingChain& chain) {
    const std::optional<HandleRole> role = handle_role(param, category);
    if (!role || value.kind == ExprKind::broken || value.extent.file != analysis_.file) return;
    // Calls that make places have handles of their own.
    if (param.type.ends_with("places") && value.kind == ExprKind::call) return;
    if (value.kind == ExprKind::list) {
      for (const scene::Operand& each : value.operands)
        add_value(*each.value, param, params, category, given, chain);
      return;
    }
    LiteralHandle handle;
    handle.name = param.name;
    handle.role = *role;
    handle.where = value.extent;
    handle.least = *role == HandleRole::length || *role == HandleRole::extent
                       ? std::max(param.min, 0.0)
                       : -kInfinity;
    const auto miss = [&](const std::string& reason) {
      out_.missing.push_back({param.name, value.extent, reason});
    };
    if (!read_numbers(value, handle)) return miss(reason_for(value));
    const LiteralFrame frame = frame_of(analysis_, values_, statement_, chain);
    if (!frame.place) return miss(frame.reason);
    handle.place = *frame.place;
    if (*role != HandleRole::point) {
      const std::optional<Vec3d> anchor = anchor_of(param, params, category, given);
      if (!anchor) return miss("the position of its origin is not known before the scene is built");
      handle.anchor = *anchor;
    }
    if (*role == HandleRole::length)
      add_length(handle, param, chain);
    else if (*role == HandleRole::extent)
      add_extents(handle, param);
    else
      out_.handles.push_back(std::move(handle));
  }

  bool read_numbers(const Expr& value, LiteralHandle& handle) const {
    const bool single = handle.role == HandleRole::length;
    if (single) {
      if (auto number = number_literal(analysis_, value)) handle.numbers = {*number};
      return !handle.numbers.empty();
    }
    if (value.kind != ExprKind::vector || value.operands.size() != 3) return false;
    for (const scene::Operand& each : value.operands)
      if (auto number = number_literal(analysis_, *each.value)) handle.numbers.push_back(*number);
    return handle.numbers.size() == 3;
  }

  /// The point from which a parameter is measured: of "radius_b" the point "b", else the first one.
  std::optional<Vec3d> anchor_of(const ParamInfo& param,
                                 const std::vector<const ParamInfo*>& params,
                                 const std::string& category, const GivenValue& given) {
    const ParamInfo* origin = nullptr;
    for (const ParamInfo* each : params) {
      if (handle_role(*each, category) != HandleRole::point || each->type != "vector") continue;
      const bool named = param.name.ends_with("_" + each->name);
      if (!origin || named) origin = each;
      if (named) break;
    }
    if (!origin) return Vec3d(0, 0, 0);
    if (const Expr* value = given(origin->name)) return values_.vector(*value);
    return values_.vector(origin->fallback).value_or(Vec3d(0, 0, 0));
  }

  /// Lengths of one call have different axes as far as there are enough.
  void add_length(LiteralHandle handle, const ParamInfo& param, const EnclosingChain& chain) {
    const Expr* call = chain.empty() ? nullptr : chain.back().expr;
    std::set<int>& used = axes_[call];
    int axis = length_axis(param);
    for (int tries = 0; tries < 6 && !used.insert(axis).second; ++tries) axis = (axis + 1) % 6;
    handle.axis = Vec3d(0, 0, 0);
    handle.axis[axis % 3] = axis < 3 ? 1 : -1;
    out_.handles.push_back(std::move(handle));
  }

  void add_extents(const LiteralHandle& all, const ParamInfo& param) {
    for (int i = 0; i < 3; ++i) {
      LiteralHandle handle = all;
      handle.name = fmt::format("{}.{}", all.name, kComponents[i]);
      handle.numbers = {all.numbers[static_cast<size_t>(i)]};
      handle.axis = Vec3d(0, 0, 0);
      handle.axis[i] = 1;
      handle.share = extent_share(param);
      out_.handles.push_back(std::move(handle));
    }
  }

  /// Adds an index to names that occur several times: "path[2]".
  void name_handles() {
    std::stable_sort(out_.handles.begin(), out_.handles.end(),
                     [](const LiteralHandle& a, const LiteralHandle& b) {
                       return begin_of(a.where) < begin_of(b.where);
                     });
    std::map<std::string, int> total, seen;
    for (const LiteralHandle& each : out_.handles) ++total[each.name];
    for (LiteralHandle& each : out_.handles) {
      const std::string name = each.name;
      if (total[name] == 1) continue;
      const size_t dot = std::min(name.find('.'), name.size());
      each.name = fmt::format("{}[{}]{}", name.substr(0, dot), ++seen[name], name.substr(dot));
    }
  }

  const Analysis& analysis_;
  const Statement& statement_;
  PlainEvaluator values_;
  StatementHandles& out_;
  std::map<const Expr*, std::set<int>> axes_;
};

std::string title_of(const Statement& statement) {
  if (statement.declaration) return statement.declaration->kind + " " + statement.declaration->name;
  if (statement.let) return "let " + statement.let->name;
  if (statement.def) return "def " + statement.def->name;
  return statement.grammar ? "grammar " + statement.grammar->name : "";
}

}  // namespace

Vec3d LiteralHandle::position() const {
  if (role == HandleRole::point) return place.point(vector());
  if (role == HandleRole::direction) return place.point(anchor);
  return place.point(anchor + axis * (share * numbers[0].value));
}

const LiteralHandle& StatementHandles::find(const std::string& name) const {
  std::vector<std::string> names;
  for (const LiteralHandle& each : handles) {
    if (each.name == name) return each;
    names.push_back(each.name);
  }
  for (const MissingHandle& each : missing)
    if (each.name == name)
      throw Error(ErrorCode::bad_input, fmt::format("'{}' has no handle: {}", name, each.reason),
                  each.where,
                  "write its numbers in a statement that is not moved by functions or rules");
  throw Error(ErrorCode::bad_input,
              title.empty() ? "no statement with handles is selected"
                            : fmt::format("'{}' has no handle '{}'", title, name),
              extent,
              names.empty() ? "go to a line such as: light lamp = sphere(center: (0, 2m, 0))"
                            : suggestion(name, names));
}

StatementHandles handles_at(const Analysis& analysis, int line) {
  StatementHandles out;
  const Statement statement = statement_at(analysis.document, analysis.file, line);
  if (!statement.known()) return out;
  out.title = title_of(statement);
  out.extent = statement.extent();
  HandleCollector(analysis, statement, out).collect();
  return out;
}

std::vector<std::string> number_texts(const LiteralHandle& handle,
                                      const std::vector<double>& values, double step) {
  std::string unit;
  std::vector<std::string> texts;
  for (const NumberLiteral& each : handle.numbers) texts.push_back(each.text);
  for (const NumberLiteral& each : handle.numbers)
    if (unit.empty()) unit = each.text.substr(unit_begin(each.text));
  for (size_t i = 0; i < handle.numbers.size(); ++i) {
    // A number that hardly changes keeps its text.
    if (std::abs(values[i] - handle.numbers[i].value) < 0.5 * step) continue;
    // Zeros are written without a unit; other numbers without one are metres.
    const std::string own = handle.numbers[i].value == 0 ? unit : "";
    texts[i] = number_text(texts[i], std::max(values[i], handle.least + step), step, own);
  }
  return texts;
}

}  // namespace vug::language
