// SPDX-License-Identifier: Apache-2.0
// The hints for unknown names and functions.
#include <vug/scene/evaluator.h>
#include <vug/scene/functions.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vug::scene {

/// "did you mean 'x'?" for the nearest name with a value or else of a kind, or an empty hint.
std::string Evaluator::name_hint(const std::string& name) const {
  std::vector<std::string> names = resolver_.known_names();
  for (const auto& [known, value] : globals_) names.push_back(known);
  if (defs_.count(name)) return fmt::format("'{0}' is a function: call it as {0}(...)", name);
  if (document_.find_module(name)) return fmt::format("'{0}' is a module: write {0}.NAME", name);
  if (const size_t dot = name.find('.');
      dot != std::string::npos && !document_.find_module(name.substr(0, name.rfind('.'))))
    return fmt::format("'{0}' is not a module; write {0}[0] for the first component of a vector",
                       name.substr(0, dot));
  if (nearest_name(name, names) != name) {
    const std::vector<std::string> calls = resolver_.known_calls();
    if (std::find(calls.begin(), calls.end(), name) != calls.end())
      return fmt::format("'{0}' is a kind: call it as {0}(...)", name);
    return did_you_mean(name, names, did_you_mean(name, calls));
  }
  for (const Declaration& made : document_.declarations)  // it exists, but has another kind
    if (made.name == name && made.target && made.target->kind == ExprKind::name)
      return fmt::format("'{}' is declared by '{}' on '{}'", name, made.kind, made.target->text);
    else if (made.name == name)
      return fmt::format("'{}' is declared by '{}'", name, made.kind);
  return "";
}

/// For a function that is written without its module, or whose file is not included.
std::string Evaluator::hint_for_module_function(const std::string& name) const {
  for (const auto& [known, def] : defs_)
    if (known.size() > name.size() && known.ends_with("." + name))
      return fmt::format("did you mean '{}'?", known);
  const std::string file = resolver_.include_with(name);
  if (file.empty()) return {};
  const std::string module = std::filesystem::path(file).stem().string();
  return fmt::format("'include \"{}\" as {}' declares '{}.{}'", file, module, module, name);
}

void Evaluator::report_unknown_function(const Expr& expr) {
  std::vector<std::string> names = resolver_.known_calls();
  for (const Function& function : functions()) names.emplace_back(function.name);
  for (const auto& [name, def] : defs_) names.push_back(name);
  names.insert(names.end(), {"if", "pick", "keys"});
  const std::string call = resolver_.call_for(expr.text);
  std::string hint = hint_for_module_function(expr.text);
  if (hint.empty())
    hint = did_you_mean(call.empty() ? name_in_this_language(expr.text) : call, names);
  diagnostics_->error(word_at(expr.where, expr.text),
                      fmt::format("unknown function '{}'", expr.text), hint);
}

}  // namespace vug::scene
