// SPDX-License-Identifier: Apache-2.0
// Variants: named sets of parameter values, such as `variant wet { WATER 2cm  GLOSS 80% }`.
#include <vug/scene/evaluator.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace vug::scene {
namespace {

constexpr const char* kVariant = "variant";

/// A hint with the nearest of the names and all of them.
std::string name_list(const std::string& name, const std::vector<std::string>& names,
                      const std::string& what) {
  const std::string near = did_you_mean(name, names);
  return fmt::format("{}{}its {}: {}", near, near.empty() ? "" : " ", what, fmt::join(names, ", "));
}

}  // namespace

void Evaluator::read_variant() {
  const std::string& name = options_.variant;
  if (name.empty()) return;
  if (const Declaration* chosen = document_.find(name, kVariant)) {
    for (const Entry& entry : chosen->entries)
      if (document_.find_param(entry.key) && entry.values.size() == 1)
        overrides_.emplace(entry.key, entry.values[0]);
    return;
  }
  if (document_.skipped.may_declare(name)) return;
  std::vector<std::string> names;
  for (const Declaration& made : document_.declarations)
    if (made.kind == kVariant) names.push_back(made.name);
  diagnostics_->error({"--variant " + name, 0, 0},
                      fmt::format("the scene has no variant '{}'", name),
                      names.empty() ? "it declares no variants; add one with e.g. 'variant wet { "
                                      "WATER 2cm }', which sets 'param WATER'"
                                    : name_list(name, names, "variants"));
}

/// The value that the variant gives to the parameter; empty after an error.
Value Evaluator::variant_value(const Declaration& variant, const Entry& entry) {
  const FaultSite here{entry.where, *diagnostics_};
  const auto param = std::find_if(params_.begin(), params_.end(), [&](const ParamValue& each) {
    return each.param->name == entry.key;
  });
  if (param == params_.end()) {
    if (document_.skipped.may_declare(entry.key)) return {};
    std::vector<std::string> names;
    for (const Param& declared : document_.params) names.push_back(declared.name);
    return here.fault(fmt::format("variant '{}' sets '{}', but the scene has no such param",
                                  variant.name, entry.key),
                      names.empty() ? fmt::format("declare it, e.g. 'param {} = 1m'", entry.key)
                                    : name_list(entry.key, names, "params"));
  }
  if (entry.values.size() != 1)
    return here.fault(fmt::format("variant '{}' gives {} values to '{}'", variant.name,
                                  entry.values.size(), entry.key),
                      fmt::format("a param has one value; write a list as {} [ ... ]", entry.key));
  const ExprPtr& value = entry.values[0];
  const auto used = overrides_.find(entry.key);
  if (used != overrides_.end() && used->second == value) return param->value;  // known already
  // The value must not depend on its own parameter.
  const std::optional<Value> known = std::exchange(globals_.at(entry.key).value, std::nullopt);
  pending_.push_back(entry.key);
  Value made = replacement(*param, *value, {root().at("param").at(entry.key), nullptr, {}});
  pending_.pop_back();
  globals_.at(entry.key).value = known;
  return made;
}

std::vector<VariantValues> Evaluator::variants() {
  params();
  std::vector<VariantValues> all;
  for (const Declaration& made : document_.declarations) {
    if (made.kind != kVariant || made.broken) continue;
    VariantValues& values = all.emplace_back(VariantValues{&made, {}});
    std::set<std::string> known;
    for (const Entry& entry : made.entries) {
      if (!known.insert(entry.key).second) {
        FaultSite{entry.where, *diagnostics_}.fault(
            fmt::format("variant '{}' sets '{}' twice", made.name, entry.key),
            "write each param once per variant");
        continue;
      }
      values.values.emplace_back(entry.key, variant_value(made, entry));
    }
  }
  return all;
}

}  // namespace vug::scene
