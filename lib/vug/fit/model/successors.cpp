// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/successors.h>

#include <algorithm>
#include <utility>

namespace vug::fit {
namespace {

int16_t small(int value) { return static_cast<int16_t>(value); }

/// Chooses the successors of one production.
class SuccessorChooser {
 public:
  SuccessorChooser(const MoveContext& context, const TreeState& state, int i,
                   const Production& production, inference::Choices& choices,
                   const Successors& fixed)
      : rules_(context.model.rules()),
        limits_(context.model.limits()),
        hints_(context.hints),
        grid_(state.tree[i]),
        area_(state.area(i)),
        x0_(state.instance(area_, 0).x),
        y0_(area_.y),
        production_(production),
        choices_(choices),
        fixed_(fixed) {}

  bool choose() {
    switch (production_.op) {
      case Op::rows:
        return rows();
      case Op::repeat:
        return repeat();
      case Op::mirror:
        return mirror();
      case Op::grid:
        return grid();
      case Op::elements:
        return elements();
      case Op::windows:
        return windows();
      case Op::terminal:
        add(0);
        rect(fixed(), out_.nodes.back());
        return true;
    }
    return false;
  }

  Successors take() { return std::move(out_); }

  /// Rectangle of a door or a shop. Standing on the ground is a choice of its own, for doors.
  void rect(const Node& old, Node& node) {
    node.x = small(along_x(hints_.left, 0, area_.width - limits_.min_size, old.x));
    node.width = small(
        along_x(hints_.right, node.x + limits_.min_size, area_.width, old.x + old.width) - node.x);
    const int old_bottom = old.y + old.height;
    const bool stands = choices_.flip(old_bottom == area_.height);
    const int bottom = stands
                           ? area_.height
                           : along_y(hints_.bottom, limits_.min_size, area_.height - 1, old_bottom);
    node.y = small(along_y(hints_.top, 0, bottom - limits_.min_size, old.y));
    node.height = small(bottom - node.y);
  }

 private:
  /// Adds a node for the symbol `number` of the production's right side.
  Node& add(size_t number) {
    Node node;
    node.symbol = small(production_.parts[number]);
    node.parent_op = static_cast<int8_t>(production_.op);
    return out_.nodes.emplace_back(node);
  }
  /// The fixed values of the node being chosen.
  const Node& fixed() const {
    static const Node nothing;
    const size_t at = out_.nodes.size() - 1;
    return at < fixed_.nodes.size() ? fixed_.nodes[at] : nothing;
  }
  /// A position along x in the area, low <= position <= high.
  int along_x(const inference::DiscreteDistribution& profile, int low, int high, int fixed) {
    return choices_.among(profile, x0_ + low, x0_ + high + 1, x0_ + fixed) - x0_;
  }
  int along_y(const inference::DiscreteDistribution& profile, int low, int high, int fixed) {
    return choices_.among(profile, y0_ + low, y0_ + high + 1, y0_ + fixed) - y0_;
  }

  bool rows() {
    Node& row = add(0);
    const int fixed_row = fixed().extent;
    row.extent =
        small(area_.height - along_y(hints_.floor, limits_.min_size,
                                     area_.height - limits_.min_size, area_.height - fixed_row));
    add(1);
    return true;
  }

  bool repeat() {
    Node& part = add(0);
    part.extent = small(choices_.between(
        2, std::min<int>(limits_.max_repeats, area_.width / limits_.min_size), fixed().extent));
    return true;
  }

  bool mirror() {
    add(0);
    if (production_.parts.size() < 2) return area_.width / 2 >= limits_.min_size;
    Node& middle = add(1);
    // With the parity of the whole width, so that both sides are equal.
    const int odd = area_.width % 2;
    const int low = (limits_.min_size - odd + 1) / 2;
    const int high = (area_.width - 2 * limits_.min_size - odd) / 2;
    middle.extent = small(odd + 2 * choices_.between(low, high, (fixed().extent - odd) / 2));
    return true;
  }

  bool grid() {
    Node& node = add(0);
    const Node& old = fixed();
    const bool regular = rules_.symbol(node.symbol).regular;
    node.columns =
        small(lines({area_.width, x0_, hints_.left}, regular, old.columns, old.left, node.left));
    node.rows = small(lines({area_.height, y0_, hints_.top}, regular, old.rows, old.top, node.top));
    return true;
  }

  /// A direction of the area: its size and origin in pixels, and where edges are likely.
  struct Axis {
    int room, origin;
    const inference::DiscreteDistribution& profile;
  };

  /// Chooses the number and positions of lines.
  int lines(const Axis& axis, bool regular, int fixed_count, const Lines& fixed, Lines& out) {
    const int room = axis.room, origin = axis.origin;
    const int step = limits_.min_size + 1;
    const int count =
        choices_.between(1, std::min(limits_.max_lines, (room + 1) / step), fixed_count);
    const auto last_start = [&](int line) { return room - (count - line) * step + 1; };
    const auto place = [&](int low, int line) {
      const auto at = static_cast<size_t>(line);
      out[at] = small(choices_.among(axis.profile, origin + low, origin + last_start(line) + 1,
                                     origin + fixed[at]) -
                      origin);
    };
    place(0, 0);
    if (count > 1 && regular) {
      const int fixed_span = fixed[static_cast<size_t>(std::max(1, fixed_count) - 1)] - fixed[0];
      const int span =
          choices_.between(step * (count - 1), room - limits_.min_size - out[0], fixed_span);
      out = even_lines(out[0], span, count);
    } else {
      for (int line = 1; line < count; ++line)
        place(out[static_cast<size_t>(line - 1)] + step, line);
    }
    return count;
  }

  bool elements() {
    const int most = std::min(limits_.max_elements, area_.width / limits_.min_size);
    const int count = choices_.between(1, most, static_cast<int>(fixed_.nodes.size()));
    int room = area_.width;
    for (int i = 0; i < count; ++i) {
      Node& part = add(0);
      if (i + 1 == count) break;
      const int rest = (count - 1 - i) * limits_.min_size;
      part.extent = small(choices_.between(limits_.min_size, room - rest, fixed().extent));
      room -= part.extent;
    }
    return true;
  }

  static int min_gap(const Lines& lines, int count, int room) {
    int gap = room - lines[static_cast<size_t>(count - 1)];
    for (int i = 1; i < count; ++i)
      gap = std::min(gap, lines[static_cast<size_t>(i)] - lines[static_cast<size_t>(i - 1)] - 1);
    return gap;
  }

  bool windows() {
    const bool has_door = production_.parts.size() > 1;
    const bool identical = rules_.symbol(grid_.symbol).identical;
    const int fixed_kinds = static_cast<int>(fixed_.nodes.size()) - (has_door ? 1 : 0);
    const int kinds = identical ? 1 : choices_.between(1, limits_.max_kinds, fixed_kinds);
    const int width = min_gap(grid_.left, grid_.columns, area_.width);
    const int height = min_gap(grid_.top, grid_.rows, area_.height);
    const int left = grid_.left[0], top = grid_.top[0];
    for (int kind = 0; kind < kinds; ++kind) {
      Node& window = add(0);
      window.width =
          small(along_x(hints_.right, left + limits_.min_size, left + width, left + fixed().width) -
                left);
      window.height = small(
          along_y(hints_.bottom, top + limits_.min_size, top + height, top + fixed().height) - top);
    }
    if (!identical && !cells(kinds)) return false;
    if (has_door) {
      add(1);
      rect(fixed(), out_.nodes.back());
    }
    return true;
  }

  /// All cells of the first kind, the usual case, or one by one.
  bool cells(int kinds) {
    const Cells full = grid_.full_cells();
    if (choices_.flip(fixed_.cells == full)) {
      out_.cells = full;
      return true;
    }
    Node chosen, old;
    old.cells = fixed_.cells;
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        chosen.set_kind(column, row, choices_.below(kinds + 1, old.kind(column, row)));
    out_.cells = chosen.cells;
    return out_.cells != full;  // That outcome belongs to the first branch.
  }

  const Rules& rules_;
  const Limits& limits_;
  const EdgeHints& hints_;
  const Node& grid_;
  const Area area_;
  const int x0_, y0_;
  const Production& production_;
  inference::Choices& choices_;
  const Successors& fixed_;
  Successors out_;
};

}  // namespace

Successors successors_of(const TreeState& state, int i) {
  Successors out;
  const Tree& tree = state.tree;
  for (int part = i + 1; part < tree.end(i); part = tree.end(part)) out.nodes.push_back(tree[part]);
  out.cells = tree[i].cells;
  return out;
}

std::optional<Successors> choose_successors(const MoveContext& context, const TreeState& state,
                                            int i, int production, inference::Choices& choices,
                                            const Successors& fixed) {
  SuccessorChooser chooser(context, state, i, context.model.rules().production(production), choices,
                           fixed);
  if (!chooser.choose() || !choices.possible()) return std::nullopt;
  return chooser.take();
}

void choose_rect(const MoveContext& context, const TreeState& state, int i,
                 inference::Choices& choices, const Node& fixed, Node& out) {
  static const Production none;
  static const Successors nothing;
  SuccessorChooser(context, state, i, none, choices, nothing).rect(fixed, out);
}

void apply_production(TreeState& state, int i, int production, const Successors& parts) {
  state.tree[i].cells = parts.cells;
  state.grow(i, production, parts.nodes);
}

void undo_production(TreeState& state, int i) {
  state.prune(i);
  state.tree[i].cells = {};
}

}  // namespace vug::fit
