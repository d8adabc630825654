// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/fit/facade_score.h>
#include <vug/fit/model/compile.h>
#include <vug/fit/report.h>
#include <vug/inference/bits.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace vug::fit {
namespace {

/// Converts the structure and the counts of a facade tree, which determine c(T), into a sampler's
/// tree. Positions remain 0.
class StructureBuilder {
 public:
  StructureBuilder(const facade::Rules& text, const Rules& rules, const facade::Tree& tree)
      : text_(text), rules_(rules), tree_(tree) {}

  Tree run() {
    if (tree_.nodes.empty() || tree_.nodes[0].symbol != rules_.symbol(rules_.axiom).name)
      throw Error(ErrorCode::bad_input, "the tree does not begin with the axiom of the grammar");
    add(0, -1, false);
    return std::move(out_);
  }

 private:
  const facade::Node& node(int i) const { return tree_.nodes[static_cast<size_t>(i)]; }

  int symbol_of(const facade::Node& from) const {
    for (size_t i = 0; i < rules_.symbols.size(); ++i)
      if (rules_.symbols[i].name == from.symbol) return static_cast<int>(i);
    throw Error(
        ErrorCode::bad_input,
        fmt::format("the rules have no symbol '{}', so the tree has no score", from.symbol));
  }

  int production_of(const facade::Node& from) const {
    for (size_t i = 0; i < text_.rules.size(); ++i)
      if (text_.rules[i].head == from.symbol && to_string(text_.rules[i]) == from.rule)
        return static_cast<int>(i);
    return -1;
  }

  /// Appends the node and its descendants; `last` is the last part of a split, whose extent is the
  /// rest of the available extent.
  void add(int from, int parent_op, bool last) {
    const facade::Node& seen = node(from);
    const auto at = static_cast<int>(out_.nodes.size());
    Node made;
    made.symbol = static_cast<int16_t>(symbol_of(seen));
    made.parent_op = static_cast<int8_t>(parent_op);
    made.production = static_cast<int16_t>(production_of(seen));
    made.extent = static_cast<int16_t>(has_extent(parent_op, last) ? 1 : 0);
    if (rules_.symbol(made.symbol).grid) {
      made.columns = made.rows = 1;  // of a grid that is not divided yet
      set_counts(seen, made);
    }
    out_.nodes.push_back(made);
    if (made.production >= 0) add_parts(from, rules_.production(made.production).op);
    out_[at].size = static_cast<int16_t>(static_cast<int>(out_.nodes.size()) - at);
  }

  static bool has_extent(int parent_op, bool last) {
    if (parent_op < 0) return false;
    switch (static_cast<Op>(parent_op)) {
      case Op::rows:
      case Op::elements:
        return !last;
      case Op::mirror:
        return last;
      default:
        return false;
    }
  }

  static void set_counts(const facade::Node& grid, Node& made) {
    for (const auto& [name, value] : grid.numbers) {
      if (value > kMaxLines && (name == "columns" || name == "rows"))
        throw Error(ErrorCode::bad_input,
                    fmt::format("a grid with {} {} has no score", value, name), {},
                    fmt::format("the published grids have at most {}", kMaxLines));
      if (name == "columns") made.columns = static_cast<int16_t>(value);
      if (name == "rows") made.rows = static_cast<int16_t>(value);
    }
  }

  void add_parts(int from, Op op) {
    const std::vector<int>& parts = node(from).children;
    if (op == Op::windows) return add_windows(from);
    const size_t most = op == Op::rows || op == Op::mirror ? 2
                        : op == Op::elements               ? parts.size()
                                                           : 1;
    if (parts.size() > most)
      throw Error(ErrorCode::bad_input, "a tree with separated parts has no score", {},
                  "join the parts of mirrored and repeated areas");
    const bool middle = op != Op::mirror || parts.size() == 2;
    for (size_t k = 0; k < parts.size(); ++k)
      add(parts[k], static_cast<int>(op), middle && k + 1 == parts.size());
  }

  /// One node for each size of window, since windows of equal size are one kind, and the door.
  void add_windows(int from) {
    std::set<std::array<long, 2>> kinds;
    const auto rounded = [](double metres) { return std::lround(1000 * metres); };
    for (const int part : node(from).children) {
      const facade::Node& seen = node(part);
      const bool window = rules_.symbol(symbol_of(seen)).type == RegionType::window;
      if (!window || kinds.insert({rounded(seen.rect.width), rounded(seen.rect.height)}).second)
        add(part, static_cast<int>(Op::windows), false);
    }
  }

  const facade::Rules& text_;
  const Rules& rules_;
  const facade::Tree& tree_;
  Tree out_;
};

/// The region of each pixel: nodes paint all their instances, parents before children.
class RegionPainter {
 public:
  RegionPainter(const Rules& rules, const facade::Tree& tree, int width, int height)
      : rules_(rules), tree_(tree), width_(width), height_(height) {}

  std::vector<int> run() {
    out_.assign(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0);
    std::vector<int> windows_of(tree_.nodes.size(), -1);
    for (size_t i = 0; i < tree_.nodes.size(); ++i) {
      const facade::Node& node = tree_.nodes[i];
      int region = static_cast<int>(i) + 1;
      if (node.parent >= 0 && is_window(node) && node.element) {
        int& shared = windows_of[static_cast<size_t>(node.parent)];
        if (shared < 0) shared = region;
        region = shared;
      }
      for (const facade::Placement& place : facade::placements(tree_, static_cast<int>(i)))
        fill(place(node.rect), region);
    }
    return std::move(out_);
  }

 private:
  bool is_window(const facade::Node& node) const {
    return std::any_of(rules_.symbols.begin(), rules_.symbols.end(), [&](const SymbolInfo& info) {
      return info.terminal && info.name == node.symbol && info.type == RegionType::window;
    });
  }

  int column(double metres) const { return edge(metres / tree_.width, width_); }
  int row(double metres) const { return height_ - edge(metres / tree_.height, height_); }
  static int edge(double share, int pixels) {
    return std::clamp(static_cast<int>(std::lround(share * pixels)), 0, pixels);
  }

  void fill(const facade::Rect& rect, int region) {
    for (int y = row(rect.top()); y < row(rect.y); ++y) {
      const auto line = out_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
      std::fill(line + column(rect.x), line + std::max(column(rect.x), column(rect.right())),
                region);
    }
  }

  const Rules& rules_;
  const facade::Tree& tree_;
  int width_, height_;
  std::vector<int> out_;
};

}  // namespace

FacadeScorer::FacadeScorer(facade::Rules text, ClusterImage clusters)
    : text_(std::move(text)),
      rules_(compile(text_)),
      clusters_(std::move(clusters)),
      model_(rules_, Limits{}, clusters_.width, clusters_.height),
      max_complexity_(max_complexity(model_)) {}

FacadeScore FacadeScorer::score(const facade::Tree& tree) const {
  FacadeScore out;
  out.complexity = model_.complexity(StructureBuilder(text_, rules_, tree).run());
  const std::vector<int> regions =
      RegionPainter(rules_, tree, clusters_.width, clusters_.height).run();
  std::vector<std::array<size_t, kMaxLanes>> counts(tree.nodes.size() + 1);
  for (size_t i = 0; i < regions.size(); ++i)
    if (clusters_.labels[i] != kNoEvidence)
      ++counts[static_cast<size_t>(regions[i])][clusters_.labels[i]];
  std::vector<uint8_t> main(counts.size());
  for (size_t k = 0; k < counts.size(); ++k)
    main[k] = static_cast<uint8_t>(std::max_element(counts[k].begin(), counts[k].end()) -
                                   counts[k].begin());
  out.mask.resize(regions.size());
  for (size_t i = 0; i < regions.size(); ++i) {
    const uint8_t cluster = clusters_.labels[i];
    out.mask[i] = cluster != kNoEvidence && cluster != main[static_cast<size_t>(regions[i])];
    out.differing += out.mask[i];
  }
  const double bits = std::max(1.0, inference::log2(clusters_.clusters));
  out.misfit = static_cast<double>(out.differing) * inference::log2(clusters_.clusters);
  const double most = static_cast<double>(regions.size()) * bits;
  out.score = 1 - (out.complexity + out.misfit) / (max_complexity_ + most);
  return out;
}

}  // namespace vug::fit
