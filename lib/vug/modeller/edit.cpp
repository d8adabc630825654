// SPDX-License-Identifier: Apache-2.0
#include <vug/base/kind.h>
#include <vug/modeller/edit.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::modeller {

namespace {

RejectedEdit rejected(const std::string& key, const std::string& message,
                      const std::string& hint = {}) {
  return {key, edit_error(message, hint)};
}

/// Runs the work and attributes its errors to that key of the edit.
template <class Work>
auto with_key(const std::string& key, const Work& work) {
  try {
    return work();
  } catch (const RejectedEdit&) {
    throw;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
    throw RejectedEdit(key, error);
  }
}

void check(const EditKind& kind, const Edit& edit) {
  if (kind.rule && edit.rule.empty())
    throw rejected("rule", fmt::format("'{}' needs a rule", kind.name));
  if (!kind.rule && !edit.rule.empty())
    throw rejected("rule", fmt::format("'{}' does not take a rule", kind.name));
  for (const std::string& name : kind.numbers)
    if (!edit.numbers.count(name))
      throw rejected("numbers", fmt::format("'{}' needs '{}'", kind.name, name));
  for (const auto& [name, values] : edit.numbers) {
    const bool own =
        std::find(kind.numbers.begin(), kind.numbers.end(), name) != kind.numbers.end();
    if (own && values.size() != 1)
      throw rejected("numbers/" + name, fmt::format("'{}' must be one number", name));
    if (!own && !kind.free_numbers)
      throw rejected("numbers/" + name, fmt::format("'{}' does not take '{}'", kind.name, name),
                     suggestion(name, kind.numbers));
    for (const double value : values)
      if (!std::isfinite(value))
        throw rejected("numbers/" + name, fmt::format("'{}' must be finite", name));
  }
}

}  // namespace

Error edit_error(const std::string& message, const std::string& hint) {
  return Error(ErrorCode::bad_input, message, {}, hint);
}

const EditKind& edit_kind(const std::string& name) {
  std::vector<std::string> known;
  for (const EditKind* kind : edit_kinds()) {
    if (kind->name == name) return *kind;
    known.push_back(kind->name);
  }
  throw rejected("edit", fmt::format("unknown edit '{}'", name), suggestion(name, known));
}

FacadeState perform_edit(const FacadeState& state, const Edit& edit) {
  const EditKind& kind = edit_kind(edit.kind);
  check(kind, edit);
  const int node = with_key("node", [&] { return state.find(edit.node); });
  const std::string whole = kind.rule ? "rule" : "";
  return with_key(whole, [&] {
    try {
      return kind.run(state, node, edit);
    } catch (const facade::InfeasiblePlan& error) {
      const bool number = edit.numbers.count(error.number()) > 0;
      throw RejectedEdit(number ? "numbers/" + error.number() : whole, error);
    }
  });
}

}  // namespace vug::modeller
