#include <vug/lsystem/options.h>

#include <algorithm>
#include <cmath>

namespace vug::lsystem {

std::string SystemOptions::fault() const {
  if (limit != std::floor(limit)) return "the limit is a whole number of modules";
  return seed && *seed != std::floor(*seed) ? "a seed is a whole number" : "";
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
  return schema.bind(arguments, grammar.where, evaluator.diagnostics());
}

}  // namespace vug::lsystem
