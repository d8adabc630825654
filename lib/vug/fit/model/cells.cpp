// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/cells.h>

namespace vug::fit {

bool has_cells(const MoveContext& context, const TreeState& state, int i) {
  return is_grid(context, state, i) && state.tree[i].production >= 0 &&
         !context.model.rules().symbol(state.tree[i].symbol).identical;
}

TreeState with_windows(const Model& model, TreeState state, int grid, const SizeChoice& choice) {
  const Node window = state.tree[grid + 1];
  while (state.tree.end(grid) > grid + 1 && model.in_grid(state.tree[grid + 1]))
    state.erase(grid, grid + 1);
  for (size_t kind = choice.sizes.size(); kind-- > 0;) {
    Node one = window;
    one.width = static_cast<int16_t>(choice.sizes[kind].width);
    one.height = static_cast<int16_t>(choice.sizes[kind].height);
    state.insert(grid, grid + 1, one);
  }
  Node& node = state.tree[grid];
  for (int row = 0; row < node.rows; ++row)
    for (int column = 0; column < node.columns; ++column)
      node.set_kind(column, row, choice.kinds[static_cast<size_t>(row * node.columns + column)]);
  state.invalidate_bits(grid);
  return state;
}

GridAxis::GridAxis(const MoveContext& context, TreeState& state, int i, bool along_x)
    : grid(state.tree[i]),
      lines(along_x ? grid.left : grid.top),
      count(along_x ? grid.columns : grid.rows),
      room(along_x ? state.area(i).width : state.area(i).height),
      origin(along_x ? state.instance(state.area(i), 0).x : state.area(i).y),
      profile(along_x ? context.hints.left : context.hints.top),
      along_x_(along_x) {
  const Rules& rules = context.model.rules();
  regular = rules.symbol(grid.symbol).regular;
  for (int part = i + 1; part < state.tree.end(i); ++part)
    kinds += rules.symbol(state.tree[part].symbol).type == RegionType::window ? 1 : 0;
  differing = has_cells(context, state, i);
}

int GridAxis::across() const { return along_x_ ? grid.rows : grid.columns; }

int GridAxis::kind(int line, int other) const {
  return along_x_ ? grid.kind(line, other) : grid.kind(other, line);
}

void GridAxis::set_kind(int line, int other, int kind) {
  along_x_ ? grid.set_kind(line, other, kind) : grid.set_kind(other, line, kind);
}

void GridAxis::insert_line(int line, int place) {
  for (int i = count; i > line; --i) {
    lines[static_cast<size_t>(i)] = lines[static_cast<size_t>(i - 1)];
    copy_cells(i - 1, i);
  }
  lines[static_cast<size_t>(line)] = static_cast<int16_t>(place);
  for (int other = 0; other < across(); ++other) set_kind(line, other, 0);
  ++count;
}

void GridAxis::remove_line(int line) {
  for (int i = line; i + 1 < count; ++i) {
    lines[static_cast<size_t>(i)] = lines[static_cast<size_t>(i + 1)];
    copy_cells(i + 1, i);
  }
  --count;
  lines[static_cast<size_t>(count)] = 0;
  for (int other = 0; other < across(); ++other) set_kind(count, other, 0);
}

bool GridAxis::alike(int line) const {
  for (int other = 1; other < across(); ++other)
    if (kind(line, other) != kind(line, 0)) return false;
  return true;
}

bool GridAxis::choose_cells(int line, Choices& choices) {
  if (!differing) return true;
  const bool one = choices.flip(alike(line));
  const int common = one ? choices.below(kinds + 1, kind(line, 0)) : 0;
  for (int other = 0; other < across(); ++other)
    set_kind(line, other, one ? common : choices.below(kinds + 1, kind(line, other)));
  return one || !alike(line);
}

bool GridAxis::same_cells(int line, int other_line) const {
  for (int other = 0; other < across(); ++other)
    if (kind(line, other) != kind(other_line, other)) return false;
  return true;
}

void GridAxis::copy_cells(int from, int to) {
  for (int other = 0; other < across(); ++other) set_kind(to, other, kind(from, other));
}

}  // namespace vug::fit
