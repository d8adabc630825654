// SPDX-License-Identifier: Apache-2.0
// Code length of a tree: c(T) = nodes * log2(symbols) + bits of all parameters (cite ripperda2009),
// plus the bits of the pixels. Counts take 4 bits; positions and sizes take as many as the
// picture's width or height needs.
#include <vug/base/error.h>
#include <vug/fit/model/model.h>
#include <vug/inference/bits.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace vug::fit {
namespace {

constexpr int kCountBits = 4;
static_assert(kMaxLines == 1 << kCountBits);

template <class Visit>
void each_window_of(const Rules& rules, const Tree& tree, int i, const Visit& visit) {
  const Node& grid = tree[i];
  const Node& last = tree[tree.end(i) - 1];
  const bool has_door = rules.symbol(last.symbol).type != RegionType::window;
  const Rect door = has_door ? rect_of(last) : Rect{};
  const bool identical = rules.symbol(grid.symbol).identical;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const int kind = identical ? 1 : grid.kind(column, row);
      if (kind == 0) continue;
      const int part = i + kind;
      const int x = grid.left[static_cast<size_t>(column)], y = grid.top[static_cast<size_t>(row)];
      const Rect rect{x, y, x + tree[part].width, y + tree[part].height};
      if (!has_door || !overlap(rect, door)) visit(part, rect);
    }
}

}  // namespace

int bits_for(int range) {
  int bits = 0;
  while (bits < 31 && (1 << bits) < range) ++bits;
  return bits;
}

Model::Model(const Rules& rules, const Limits& limits, int width, int height, PixelTerm pixels)
    : rules_(&rules),
      limits_(limits),
      width_(width),
      height_(height),
      evidence_(pixels.evidence),
      likelihood_(std::move(pixels.likelihood)),
      pixel_weight_(pixels.weight),
      symbol_bits_(inference::log2(static_cast<double>(rules.symbols.size()))),
      x_bits_(bits_for(width)),
      y_bits_(bits_for(height)) {
  constexpr int kMax = std::numeric_limits<int16_t>::max();
  if (width < 1 || height < 1 || width > kMax || height > kMax)
    throw Error(ErrorCode::bad_input, "invalid facade size: each side must have 1 to 32767 pixels");
  if (limits.min_size < 1 || limits.max_lines > kMaxLines || limits.max_kinds > kMaxKinds)
    throw Error(ErrorCode::bad_input, "the limits of facade trees are out of range");
  for (size_t symbol = 0; symbol < rules.symbols.size(); ++symbol) {
    const std::vector<int>& ids = rules.by_head[symbol];
    elements_.push_back(!ids.empty() && std::all_of(ids.begin(), ids.end(), [&](int id) {
      return rules.production(id).op == Op::terminal;
    }));
  }
  if (!(pixel_weight_ > 0))
    throw Error(ErrorCode::bad_input, "the weight of pixels must be above 0");
  if (evidence_ && (evidence_->width() != width || evidence_->height() != height))
    throw Error(ErrorCode::bad_input, "the evidence and the facade differ in size");
}

TreeState Model::make_state(Tree tree) const {
  TreeState state;
  state.tree = std::move(tree);
  const size_t count = state.tree.nodes.size();
  state.areas.resize(count);
  state.bits.resize(count);
  state.bits_valid.assign(count, 0);
  return state;
}

double Model::complexity(const Tree& tree, int i) const {
  const Node& node = tree[i];
  if (i == 0) return symbol_bits_;
  const SymbolInfo& symbol = rules_->symbol(node.symbol);
  int bits = 0;
  switch (static_cast<Op>(node.parent_op)) {
    case Op::rows:
      bits = node.extent > 0 ? y_bits_ : 0;
      break;
    case Op::repeat:
      bits = kCountBits;
      break;
    case Op::mirror:
    case Op::elements:
      bits = node.extent > 0 ? x_bits_ : 0;
      if (node.production < 0 && elements_[static_cast<size_t>(node.symbol)])
        return 2 * symbol_bits_ + bits + 2 * (x_bits_ + y_bits_);
      break;
    case Op::grid:
      bits = 2 * kCountBits + x_bits_ + y_bits_;
      bits += symbol.regular ? x_bits_ + y_bits_
                             : (node.columns - 1) * x_bits_ + (node.rows - 1) * y_bits_;
      if (node.production >= 0 && !symbol.identical) {
        const Node& last = tree[tree.end(i) - 1];
        const bool has_door = rules_->symbol(last.symbol).type != RegionType::window;
        const int kinds = node.size - 1 - (has_door ? 1 : 0);
        bits += node.columns * node.rows * bits_for(kinds + 1);
      }
      break;
    case Op::windows:
      bits = x_bits_ + y_bits_;
      if (symbol.type != RegionType::window) bits *= 2;
      break;
    case Op::terminal:
      bits = 2 * (x_bits_ + y_bits_);
      break;
  }
  return symbol_bits_ + bits;
}

double Model::complexity(const Tree& tree) const {
  double bits = 0;
  for (int i = 0; i < tree.size(); ++i) bits += complexity(tree, i);
  return bits;
}

Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area, const Rect& r) {
  Sums out;
  for (int place = 0; place < area.count; ++place) {
    const Rect there =
        Model::in_picture(area, state.instance(area, place), r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0);
    out += evidence.sums(there.x0, there.y0, there.x1, there.y1);
  }
  return out;
}

Sums sum_of(const Evidence& evidence, const TreeState& state, const Area& area) {
  return sum_of(evidence, state, area, {0, 0, area.width, area.height});
}

double Model::pixel_bits(const TreeState& state, int i) const {
  if (!likelihood_) return 0;
  const Tree& tree = state.tree;
  const Node& node = tree[i];
  if (rules_->symbol(node.symbol).terminal) return 0;
  const Area& area = state.area(i);
  const auto whole = [&] { return sum_of(*evidence_, state, area); };
  const auto own = [&](const Node& part) { return sum_of(*evidence_, state, area, rect_of(part)); };
  if (node.production < 0) return likelihood_->bits(RegionType::wall, whole());
  switch (rules_->production(node.production).op) {
    case Op::rows:
    case Op::grid:
    case Op::elements:
      return 0;
    case Op::repeat:
    case Op::mirror: {
      // Pixels left over if the width is not a multiple of the part's width.
      const Area& part = state.area(i + 1);
      if (tree.end(i + 1) < tree.end(i)) return 0;
      if (area.width * area.count == part.width * part.count) return 0;
      Sums rest = whole();
      rest -= sum_of(*evidence_, state, part);
      return likelihood_->bits(RegionType::wall, rest);
    }
    case Op::windows: {
      // Windows of a grid look alike regardless of their sizes and form one region.
      Sums windows, wall = whole();
      each_window_of(*rules_, tree, i,
                     [&](int, const Rect& r) { windows += sum_of(*evidence_, state, area, r); });
      wall -= windows;
      double bits = likelihood_->bits(RegionType::window, windows);
      const Node& last = tree[tree.end(i) - 1];
      const RegionType type = rules_->symbol(last.symbol).type;
      if (type != RegionType::window) {
        const Sums door = own(last);
        bits += likelihood_->bits(type, door);
        wall -= door;
      }
      return bits + likelihood_->bits(RegionType::wall, wall);
    }
    case Op::terminal: {
      const Node& seen = tree[i + 1];
      const Sums sums = own(seen);
      Sums wall = whole();
      wall -= sums;
      return likelihood_->bits(rules_->symbol(seen.symbol).type, sums) +
             likelihood_->bits(RegionType::wall, wall);
    }
  }
  return 0;
}

double Model::energy(TreeState& state) const {
  if (!state.areas_valid && !compute_areas(state)) return std::numeric_limits<double>::infinity();
  double all = 0;
  for (int i = 0; i < state.tree.size(); ++i) {
    const auto at = static_cast<size_t>(i);
    if (!state.bits_valid[at]) {
      state.bits[at] = complexity(state.tree, i) + pixel_weight_ * pixel_bits(state, i);
      state.bits_valid[at] = 1;
    }
    all += state.bits[at];
  }
  return all;
}

void Model::each_window(const Tree& tree, int i,
                        const std::function<void(int, const Rect&)>& visit) const {
  each_window_of(*rules_, tree, i, visit);
}

void Model::each_terminal(const TreeState& state,
                          const std::function<void(RegionType, int, const Rect&)>& visit) const {
  const Tree& tree = state.tree;
  const auto everywhere = [&](int i, int part, const Rect& r) {
    const Area& area = state.area(i);
    for (int place = 0; place < area.count; ++place)
      visit(rules_->symbol(tree[part].symbol).type, part,
            in_picture(area, state.instance(area, place), r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0));
  };
  for (int i = 0; i < tree.size(); ++i) {
    if (tree[i].production < 0) continue;
    const Op op = rules_->production(tree[i].production).op;
    if (op == Op::windows)
      each_window_of(*rules_, tree, i, [&](int part, const Rect& r) { everywhere(i, part, r); });
    if (op != Op::windows && op != Op::terminal) continue;
    for (int part = i + 1; part < tree.end(i); ++part)
      if (op == Op::terminal || rules_->symbol(tree[part].symbol).type != RegionType::window)
        everywhere(i, part, rect_of(tree[part]));
  }
}

}  // namespace vug::fit
