#include <vug/fit/model/split_parameters.h>

#include <algorithm>

namespace vug::fit {
namespace {

int16_t small(int value) { return static_cast<int16_t>(value); }

/// Chooses one production's parts.
class Chooser {
 public:
  Chooser(const Workshop& shop, const State& state, int i, const Production& production,
          inference::Choices& choices, const Parts& told, Parts& out)
      : rules_(shop.model.rules()),
        limits_(shop.model.limits()),
        hints_(shop.hints),
        grid_(state.tree[i]),
        area_(state.area(i)),
        x0_(state.frame(area_, 0).x),
        y0_(area_.y),
        production_(production),
        choices_(choices),
        told_(told),
        out_(out) {}

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
        rect(told(), out_.nodes.back());
        return true;
    }
    return false;
  }

  /// Where a door or a shop is: doors stand on the ground, as a choice of its own.
  void rect(const Node& old, Node& node) {
    node.x = small(along_x(hints_.left, 0, area_.width - limits_.least, old.x));
    node.width = small(
        along_x(hints_.right, node.x + limits_.least, area_.width, old.x + old.width) - node.x);
    const int old_bottom = old.y + old.height;
    const bool stands = choices_.flip(old_bottom == area_.height);
    const int bottom =
        stands ? area_.height : along_y(hints_.bottom, limits_.least, area_.height - 1, old_bottom);
    node.y = small(along_y(hints_.top, 0, bottom - limits_.least, old.y));
    node.height = small(bottom - node.y);
  }

 private:
  /// A new part, of the production's part of that number.
  Node& add(size_t number) {
    Node node;
    node.symbol = small(production_.parts[number]);
    node.made_by = static_cast<int8_t>(production_.op);
    return out_.nodes.emplace_back(node);
  }
  /// What is told of the part that is chosen now.
  const Node& told() const {
    static const Node nothing;
    const size_t at = out_.nodes.size() - 1;
    return at < told_.nodes.size() ? told_.nodes[at] : nothing;
  }
  /// A place along x between low and high, both included, in the area.
  int along_x(const inference::DiscreteDistribution& profile, int low, int high, int told) {
    return choices_.among(profile, x0_ + low, x0_ + high + 1, x0_ + told) - x0_;
  }
  int along_y(const inference::DiscreteDistribution& profile, int low, int high, int told) {
    return choices_.among(profile, y0_ + low, y0_ + high + 1, y0_ + told) - y0_;
  }

  bool rows() {
    Node& row = add(0);
    const int told_row = told().extent;
    row.extent =
        small(area_.height - along_y(hints_.floor, limits_.least, area_.height - limits_.least,
                                     area_.height - told_row));
    add(1);
    return true;
  }

  bool repeat() {
    Node& part = add(0);
    part.extent = small(choices_.between(
        2, std::min<int>(limits_.most_repeats, area_.width / limits_.least), told().extent));
    return true;
  }

  bool mirror() {
    add(0);
    if (production_.parts.size() < 2) return area_.width / 2 >= limits_.least;
    Node& middle = add(1);
    // As even or odd as the whole, so that the sides are equal.
    const int odd = area_.width % 2;
    const int low = (limits_.least - odd + 1) / 2;
    const int high = (area_.width - 2 * limits_.least - odd) / 2;
    middle.extent = small(odd + 2 * choices_.between(low, high, (told().extent - odd) / 2));
    return true;
  }

  bool grid() {
    Node& node = add(0);
    const Node& old = told();
    const bool regular = rules_.symbol(node.symbol).regular;
    node.columns =
        small(lines(area_.width, hints_.left, regular, x0_, old.columns, old.left, node.left));
    node.rows = small(lines(area_.height, hints_.top, regular, y0_, old.rows, old.top, node.top));
    return true;
  }

  /// How many, and where.
  int lines(int room, const inference::DiscreteDistribution& profile, bool regular, int origin,
            int told_count, const Lines& told, Lines& out) {
    const int step = limits_.least + 1;
    const int count =
        choices_.between(1, std::min(limits_.most_lines, (room + 1) / step), told_count);
    const auto last_start = [&](int line) { return room - (count - line) * step + 1; };
    const auto place = [&](int low, int line) {
      const auto at = static_cast<size_t>(line);
      out[at] = small(
          choices_.among(profile, origin + low, origin + last_start(line) + 1, origin + told[at]) -
          origin);
    };
    place(0, 0);
    if (count > 1 && regular) {
      const int told_span = told[static_cast<size_t>(std::max(1, told_count) - 1)] - told[0];
      const int span =
          choices_.between(step * (count - 1), room - limits_.least - out[0], told_span);
      out = even_lines(out[0], span, count);
    } else {
      for (int line = 1; line < count; ++line)
        place(out[static_cast<size_t>(line - 1)] + step, line);
    }
    return count;
  }

  bool elements() {
    const int most = std::min(limits_.most_elements, area_.width / limits_.least);
    const int count = choices_.between(1, most, static_cast<int>(told_.nodes.size()));
    int room = area_.width;
    for (int i = 0; i < count; ++i) {
      Node& part = add(0);
      if (i + 1 == count) break;
      const int rest = (count - 1 - i) * limits_.least;
      part.extent = small(choices_.between(limits_.least, room - rest, told().extent));
      room -= part.extent;
    }
    return true;
  }

  static int least_gap(const Lines& lines, int count, int room) {
    int gap = room - lines[static_cast<size_t>(count - 1)];
    for (int i = 1; i < count; ++i)
      gap = std::min(gap, lines[static_cast<size_t>(i)] - lines[static_cast<size_t>(i - 1)] - 1);
    return gap;
  }

  bool windows() {
    const bool has_door = production_.parts.size() > 1;
    const bool identical = rules_.symbol(grid_.symbol).identical;
    const int told_kinds = static_cast<int>(told_.nodes.size()) - (has_door ? 1 : 0);
    const int kinds = identical ? 1 : choices_.between(1, limits_.most_kinds, told_kinds);
    const int width = least_gap(grid_.left, grid_.columns, area_.width);
    const int height = least_gap(grid_.top, grid_.rows, area_.height);
    const int left = grid_.left[0], top = grid_.top[0];
    for (int kind = 0; kind < kinds; ++kind) {
      Node& window = add(0);
      window.width = small(
          along_x(hints_.right, left + limits_.least, left + width, left + told().width) - left);
      window.height = small(
          along_y(hints_.bottom, top + limits_.least, top + height, top + told().height) - top);
    }
    if (!identical && !cells(kinds)) return false;
    if (has_door) {
      add(1);
      rect(told(), out_.nodes.back());
    }
    return true;
  }

  /// All of the first kind, as most grids are, or each cell by itself.
  bool cells(int kinds) {
    const Cells full = grid_.full_cells();
    if (choices_.flip(told_.cells == full)) {
      out_.cells = full;
      return true;
    }
    Node chosen, old;
    old.cells = told_.cells;
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        chosen.set_kind(column, row, choices_.below(kinds + 1, old.kind(column, row)));
    out_.cells = chosen.cells;
    return out_.cells != full;  // which has a way of its own
  }

  const Rules& rules_;
  const Limits& limits_;
  const Hints& hints_;
  const Node& grid_;
  const Area area_;
  const int x0_, y0_;
  const Production& production_;
  inference::Choices& choices_;
  const Parts& told_;
  Parts& out_;
};

}  // namespace

Parts parts_of(const State& state, int i) {
  Parts out;
  const Tree& tree = state.tree;
  for (int part = i + 1; part < tree.end(i); part = tree.end(part)) out.nodes.push_back(tree[part]);
  out.cells = tree[i].cells;
  return out;
}

bool choose_parts(const Workshop& shop, const State& state, int i, int production,
                  inference::Choices& choices, const Parts& told, Parts& out) {
  out = {};
  Chooser chooser(shop, state, i, shop.model.rules().production(production), choices, told, out);
  return chooser.choose() && choices.possible();
}

void choose_rect(const Workshop& shop, const State& state, int i, inference::Choices& choices,
                 const Node& told, Node& out) {
  static const Production none;
  static const Parts nothing;
  Parts unused;
  Chooser(shop, state, i, none, choices, nothing, unused).rect(told, out);
}

void put_parts(State& state, int i, int production, const Parts& parts) {
  state.tree[i].cells = parts.cells;
  state.grow(i, production, parts.nodes);
}

void take_parts(State& state, int i) {
  state.prune(i);
  state.tree[i].cells = {};
}

}  // namespace vug::fit
