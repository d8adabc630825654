// SPDX-License-Identifier: Apache-2.0
// Random sequences of edits: each edit yields a valid state or is rejected without effect, undo
// restores the previous bytes, and replaying the edits reproduces the bytes.
#include "desk.h"

#include <vug/base/rng.h>
#include <vug/modeller/history.h>
#include <vug/modeller/lines.h>
#include <vug/modeller/query.h>

#include <cmath>
#include <set>

namespace vug::modeller {
namespace {

/// A random edit of any kind at any node, often an invalid one.
Edit any_edit(const FacadeState& state, RandomStream& random) {
  const auto below = [&](size_t count) {
    return static_cast<int>(random.below(static_cast<uint32_t>(count)));
  };
  Edit out;
  const auto& kinds = edit_kinds();
  // Rules are applied most often, so that trees grow.
  out.kind = random.uniform() < 0.4 ? (random.uniform() < 0.5 ? "apply" : "act")
                                    : kinds[static_cast<size_t>(below(kinds.size()))]->name;
  const std::vector<int> open = state.open();
  const bool grow = out.kind == "apply" || out.kind == "act";
  const int node = grow && !open.empty() && random.uniform() < 0.9
                       ? open[static_cast<size_t>(below(open.size()))]
                       : below(state.tree().nodes.size());
  out.node = state.path(node);
  const std::vector<int> rules = state.style().rules_of(state.node(node).symbol);
  if (edit_kind(out.kind).rule)
    out.rule = rules.empty()
                   ? "Grid"
                   : state.style().rule_name(rules[static_cast<size_t>(below(rules.size()))]);
  if (edit_kind(out.kind).free_numbers)
    for (const facade::FreeNumber& each : state.planned(node).free)
      if (random.uniform() < 0.4)
        out.numbers[each.name] = {each.whole ? below(6) : random.uniform(-0.5, 5)};
  if (out.kind == "move") {
    const std::vector<Line> all = lines(state, node);
    const int line = below(all.size() + 1);
    out.numbers["line"] = {static_cast<double>(line)};
    out.numbers["to"] = {random.uniform(0, 6)};
    if (static_cast<size_t>(line) < all.size() && random.uniform() < 0.7)
      out.numbers["to"] = {all[static_cast<size_t>(line)].at + random.uniform(-0.3, 0.3)};
  }
  if (out.kind == "toggle") {
    out.numbers["column"] = {static_cast<double>(below(4))};
    out.numbers["row"] = {static_cast<double>(below(4))};
  }
  return out;
}

/// Invariants of every state.
void expect_whole(const FacadeState& state) {
  const facade::Tree& tree = state.tree();
  for (size_t i = 0; i < tree.nodes.size(); ++i) {
    const facade::Node& node = tree.nodes[i];
    ASSERT_GE(node.rect.width, state.canvas().min_size);
    ASSERT_GE(node.rect.height, state.canvas().min_size);
    const facade::Rect over = node.parent < 0 ? facade::Rect{0, 0, tree.width, tree.height}
                                              : tree.nodes[static_cast<size_t>(node.parent)].rect;
    ASSERT_GE(node.rect.x, over.x - 1e-6);
    ASSERT_GE(node.rect.y, over.y - 1e-6);
    ASSERT_LE(node.rect.right(), over.right() + 1e-6);
    ASSERT_LE(node.rect.top(), over.top() + 1e-6);
    ASSERT_EQ(node.stuck, !node.element && state.rule(static_cast<int>(i)) < 0 &&
                              !state.style().rules_of(node.symbol).empty());
  }
  for (const facade::ElementInstance& one : facade::element_instances(tree)) {
    ASSERT_GE(one.rect.x, -1e-6);
    ASSERT_LE(one.rect.right(), tree.width + 1e-6);
  }
}

TEST(RandomEdits, UndoAfterEveryEditAndReplayAtTheEnd) {
  std::set<std::string> done_kinds, refused_kinds;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    RandomStream random(RandomKey(seed).at("walk"));
    History history(blank(12 + static_cast<double>(seed % 3) * 7, 15));
    std::vector<std::string> seen = {bytes(history.current())};
    for (int step = 0; step < 60; ++step) {
      const Edit edit = any_edit(history.current(), random);
      const std::string before = bytes(history.current());
      ASSERT_EQ(before, seen[history.done()]);
      try {
        history.apply(edit);
      } catch (const RejectedEdit&) {
        refused_kinds.insert(edit.kind);
        ASSERT_EQ(bytes(history.current()), before) << to_string(edit);
        continue;
      }
      done_kinds.insert(edit.kind);
      expect_whole(history.current());
      const std::string made = bytes(history.current());
      ASSERT_EQ(history.undo(), 1u);
      ASSERT_EQ(bytes(history.current()), before) << to_string(edit);
      ASSERT_EQ(history.redo(), 1u);
      ASSERT_EQ(bytes(history.current()), made) << to_string(edit);
      seen.resize(history.done());
      seen.push_back(made);
      if (random.uniform() < 0.05) history.undo(random.below(4));
    }
    // The same edits from the start, by their text.
    FacadeState again(history.current().style_ptr(), history.current().canvas());
    for (size_t i = 0; i < history.done(); ++i)
      again = perform_edit(again, parse_edit(to_string(history.edits()[i])));
    ASSERT_EQ(bytes(again), bytes(history.current()));
  }
  EXPECT_EQ(done_kinds.size(), edit_kinds().size()) << "every kind succeeds at least once";
  EXPECT_EQ(refused_kinds.size(), edit_kinds().size()) << "and refused";
}

TEST(RandomEdits, OfferedRulesCanBeApplied) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    RandomStream random(RandomKey(seed).at("offers"));
    FacadeState state = blank(18, 14);
    for (int step = 0; step < 12; ++step) {
      const std::vector<int> open = state.open();
      if (open.empty()) break;
      const int node = open[random.below(static_cast<uint32_t>(open.size()))];
      std::vector<FacadeState> next;
      for (const RuleChoice& each : choices(state, node)) {
        const Edit edit{"apply", state.path(node), state.style().rule_name(each.rule), {}};
        if (each.reason != facade::Reason::none) {
          ASSERT_THROW(perform_edit(state, edit), RejectedEdit);
          continue;
        }
        next.push_back(perform_edit(state, edit));
        // With the default numbers given explicitly, the rule has the same result.
        Edit told = edit;
        for (const facade::FreeNumber& number : each.free)
          told.numbers[number.name] = number.values;
        const FacadeState same = perform_edit(state, told);
        ASSERT_EQ(bytes(same), bytes(next.back())) << to_string(told);
      }
      if (next.empty()) break;
      state = next[random.below(static_cast<uint32_t>(next.size()))];
    }
  }
}

}  // namespace
}  // namespace vug::modeller
