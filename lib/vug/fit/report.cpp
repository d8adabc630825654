// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/report.h>
#include <vug/inference/bits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::fit {
namespace {

/// 0 without values.
double mean(const inference::Trace& trace) {
  double sum = 0;
  for (const double value : trace) sum += value;
  return sum / std::max(1.0, static_cast<double>(trace.size()));
}

/// The rounds of a run with that structure, as a trace of 0 and 1.
inference::Trace indicator(const SamplerResult& run, const std::string& structure) {
  inference::Trace out;
  out.reserve(run.visited.size());
  for (const int at : run.visited)
    out.push_back(run.structures[static_cast<size_t>(at)].text == structure ? 1 : 0);
  return out;
}

StructureProbability probability_of(const std::vector<SamplerResult>& runs,
                                    const std::string& structure) {
  StructureProbability out{structure};
  double rounds = 0, effective = 0;
  for (const SamplerResult& run : runs) {
    const inference::Trace trace = indicator(run, structure);
    if (trace.empty()) continue;
    for (const double there : trace) out.probability += there;
    rounds += static_cast<double>(trace.size());
    effective += inference::effective_size(trace);
  }
  if (rounds > 0) out.probability /= rounds;
  if (effective > 0)
    out.standard_error = std::sqrt(out.probability * (1 - out.probability) / effective);
  return out;
}

void add_posterior(Report& out, const std::vector<SamplerResult>& runs) {
  constexpr size_t kMax = 20;
  std::map<std::string, int64_t> counts;
  for (const SamplerResult& run : runs)
    for (const StructureCount& one : run.structures) counts[one.text] += one.rounds;
  std::vector<std::pair<int64_t, std::string>> order;
  for (const auto& [text, count] : counts) order.emplace_back(-count, text);
  std::sort(order.begin(), order.end());
  for (const auto& [count, text] : order)
    if (out.posterior.size() < kMax) out.posterior.push_back(probability_of(runs, text));
}

/// Search for the most complex subtree of a symbol.
class MaxComplexitySearch {
 public:
  explicit MaxComplexitySearch(const Model& model) : model_(model), rules_(model.rules()) {}

  double bits(const Node& node, int depth) const { return tree(node, depth).second; }

 private:
  using Subtree = std::pair<std::vector<Node>, double>;

  Subtree tree(const Node& node, int depth) const {
    Subtree best = {{node}, 0};
    best.second = bits_of(best.first);
    for (const int id : rules_.productions_of(node.symbol)) {
      const Production& production = rules_.production(id);
      const bool splits = production.op == Op::rows || production.op == Op::repeat ||
                          production.op == Op::mirror || production.op == Op::elements;
      if (splits && depth == 0) continue;
      Tree made;
      made.nodes = {node};
      if (production.op == Op::windows) made[0].cells = {};
      std::vector<Node> parts;
      for (const Node& part : successors_of(production, node)) parts.push_back(part);
      made.grow(0, id, parts);
      for (int number = made.child_count(0) - 1; number >= 0; --number) {
        const int at = made.child(0, number);
        made.replace(at, tree(made[at], depth - (splits ? 1 : 0)).first);
      }
      const double bits = bits_of(made.nodes);
      if (bits > best.second) best = {std::move(made.nodes), bits};
    }
    return best;
  }

  double bits_of(const std::vector<Node>& nodes) const { return model_.complexity(Tree{nodes}); }

  std::vector<Node> successors_of(const Production& production, const Node& above) const {
    const Limits& limits = model_.limits();
    std::vector<Node> out;
    const auto put = [&](size_t number, int extent) {
      Node node;
      node.symbol = static_cast<int16_t>(production.parts[number]);
      node.parent_op = static_cast<int8_t>(production.op);
      node.extent = static_cast<int16_t>(extent);
      if (rules_.symbol(node.symbol).grid)
        node.columns = node.rows = static_cast<int16_t>(limits.max_lines);
      out.push_back(node);
    };
    if (production.op == Op::elements) {
      for (int i = 0; i < limits.max_elements; ++i) put(0, i + 1 < limits.max_elements ? 1 : 0);
    } else if (production.op == Op::windows) {
      const bool identical = rules_.symbol(above.symbol).identical;
      for (int i = 0; i < (identical ? 1 : limits.max_kinds); ++i) put(0, 0);
      if (production.parts.size() > 1) put(1, 0);
    } else {
      const bool first_has_extent = production.op == Op::rows || production.op == Op::repeat;
      put(0, first_has_extent ? 2 : 0);
      if (production.parts.size() > 1) put(1, production.op == Op::mirror ? 2 : 0);
    }
    return out;
  }

  const Model& model_;
  const Rules& rules_;
};

}  // namespace

double max_complexity(const Model& model, int depth) {
  return MaxComplexitySearch(model).bits(model.axiom_state().tree[0], depth);
}

std::optional<ReportWarning> disagreement(const Report& report) {
  const double worst = std::max(report.scale_reduction, report.elements_scale_reduction);
  if (report.stopped || report.traces.size() < 2 || worst <= kMaxScaleReduction)
    return std::nullopt;
  constexpr size_t kMinRounds = 4;  // of scale_reduction
  if (report.traces[0].size() < kMinRounds)
    return ReportWarning{"the chains are too short to be compared", "increase --iterations"};
  std::string each;
  for (size_t run = 0; run < report.traces.size(); ++run)
    each += fmt::format("{}{:.1f} bits with {:.1f} elements", run == 0 ? "" : " and ",
                        mean(report.traces[run]), report.mean_elements[run]);
  const char* evidence = report.supervised
                             ? "train the classifier of --looks on more similar facades"
                             : "use a classifier that is trained on similar facades (--looks)";
  return ReportWarning{
      fmt::format(
          "the chains disagree (R-hat {:.2f}, more than {}): their means are {}, and another "
          "--seed may give another tree",
          worst, kMaxScaleReduction, each),
      fmt::format("increase --iterations, or {}", evidence)};
}

Report make_report(const std::vector<SamplerResult>& runs) {
  Report out;
  std::vector<inference::Trace> elements;
  for (const SamplerResult& run : runs) {
    out.traces.push_back(run.trace);
    elements.push_back(run.elements);
    out.mean_elements.push_back(mean(run.elements));
    out.stopped = out.stopped || run.stopped;
    if (!run.trace.empty()) out.effective_size += inference::effective_size(run.trace);
    const double z = inference::geweke(run.trace);
    if (std::fabs(z) > std::fabs(out.geweke)) out.geweke = z;
    if (out.moves.empty())
      for (const MoveKind* kind : move_kinds()) out.moves.push_back({kind->info.name, {}});
    for (size_t i = 0; i < run.moves.size() && i < out.moves.size(); ++i) {
      out.moves[i].count.tried += run.moves[i].tried;
      out.moves[i].count.possible += run.moves[i].possible;
      out.moves[i].count.accepted += run.moves[i].accepted;
    }
  }
  out.scale_reduction = inference::scale_reduction(out.traces);
  out.elements_scale_reduction = inference::scale_reduction(elements);
  if (!runs.empty()) out.temperatures = runs.front().temperatures;
  for (size_t pair = 0; !runs.empty() && pair < runs.front().swaps.size(); ++pair) {
    inference::TemperatureLadder::Swaps sum;
    for (const SamplerResult& run : runs) {
      sum.tried += run.swaps[pair].tried;
      sum.taken += run.swaps[pair].taken;
    }
    out.swap_rates.push_back(sum.rate());
  }
  add_posterior(out, runs);
  return out;
}

void add_score(Report& report, const Model& model, const Evidence& evidence, const Tree& tree) {
  report.structure = structure_of(model.rules(), tree);
  report.complexity = model.complexity(tree);
  report.max_complexity = max_complexity(model);
  const double most = static_cast<double>(evidence.width()) * evidence.height() *
                      std::max(1.0, inference::log2(evidence.lanes()));
  const bool supervised = model.likelihood() && model.likelihood()->is_supervised();
  const Model paper(model.rules(), model.limits(), model.width(), model.height(),
                    {&evidence, make_likelihood(supervised ? "supervised" : "paper", evidence)});
  TreeState state = paper.make_state(tree);
  report.misfit = std::min(most, paper.energy(state) - report.complexity);
  report.score = 1 - (report.complexity + report.misfit) / (report.max_complexity + most);
}

}  // namespace vug::fit
