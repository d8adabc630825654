// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/options.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

bool check_whole(const SystemOptions& options, const scene::Grammar& grammar,
                 Diagnostics& diagnostics) {
  bool sound = true;
  const auto check = [&](const char* key, double value, const char* message) {
    for (const scene::Entry& entry : grammar.options) {
      if (entry.key != key || value == std::floor(value)) continue;
      diagnostics.error(entry.values.at(0)->where, fmt::format("{}, not {}", message, value));
      sound = false;
    }
  };
  check("limit", options.limit, "the limit must be a whole number of modules");
  check("seed", options.seed.value_or(0), "a seed must be a whole number");
  return sound;
}

std::optional<SystemOptions> system_options(const scene::Grammar& grammar,
                                            scene::Evaluator& evaluator) {
  static const Schema<SystemOptions> schema = [] {
    Schema<SystemOptions> s("lsystem", "grammar");
    describe_system(s);
    return s;
  }();
  const std::vector<ParamInfo>& known = schema.info().params;
  Arguments arguments;
  for (const scene::Entry& entry : grammar.options) {
    const auto is_it = [&](const ParamInfo& param) { return param.name == entry.key; };
    if (std::none_of(known.begin(), known.end(), is_it)) continue;
    Value value = evaluator.eval(*entry.values.at(0), evaluator.root().at(entry.key));
    if (value.empty()) return std::nullopt;
    arguments.push_back({entry.key, std::move(value), entry.where});
  }
  std::optional<SystemOptions> options =
      schema.bind(arguments, grammar.where, evaluator.diagnostics());
  return options && check_whole(*options, grammar, evaluator.diagnostics()) ? options
                                                                            : std::nullopt;
}

}  // namespace vug::lsystem
