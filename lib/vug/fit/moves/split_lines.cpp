// SPDX-License-Identifier: Apache-2.0
// Splits and merges columns or rows: in a regular grid all of them, at half the spacing; in an
// irregular grid one line becomes two, or two neighbours become one.
#include <vug/fit/model/cells.h>

namespace vug::fit {
namespace {

/// Inserts a line between each two lines, and the reverse.
bool split_all(GridAxis& axis, int most, Choices& forward, Choices&) {
  const int first = axis.at(0), span = axis.span(), count = axis.count;
  if (count < 2 || 2 * count - 1 > most) return false;
  for (int line = count - 1; line > 0; --line) {
    axis.insert_line(line, 0);
    if (!axis.choose_cells(line, forward)) return false;
  }
  axis.space_evenly(first, span);
  return true;
}

bool merge_all(GridAxis& axis, int, Choices&, Choices& back) {
  if (axis.count < 3 || axis.count % 2 == 0) return false;
  const int first = axis.at(0), span = axis.span();
  for (int line = axis.count - 2; line > 0; line -= 2) {
    axis.choose_cells(line, back);
    axis.remove_line(line);
  }
  axis.space_evenly(first, span);
  return true;
}

/// Range in the picture for lines between the neighbours of lines first..last.
struct Window {
  int low, high;
};
Window window(const GridAxis& axis, int first, int last) {
  return {axis.origin + (first > 0 ? axis.at(first - 1) + 1 : 0),
          axis.origin + (last + 1 < axis.count ? axis.at(last + 1) : axis.room)};
}

bool split_one(GridAxis& axis, int most, Choices& forward, Choices& back) {
  if (axis.count + 1 > most) return false;
  const int line = forward.below(axis.count);
  const Window room = window(axis, line, line);
  back.below(axis.count, line);  // One of the resulting pairs.
  back.among(axis.profile, room.low, room.high, axis.origin + axis.at(line));
  const int first = forward.among(axis.profile, room.low, room.high - 1);
  const int second = forward.among(axis.profile, first + 1, room.high);
  if (!forward.possible()) return false;
  axis.insert_line(line + 1, second - axis.origin);
  axis.copy_cells(line, line + 1);
  axis.lines[static_cast<size_t>(line)] = static_cast<int16_t>(first - axis.origin);
  return true;
}

bool merge_two(GridAxis& axis, int, Choices& forward, Choices& back) {
  if (axis.count < 2) return false;
  const int line = forward.below(axis.count - 1);
  if (!axis.same_cells(line, line + 1)) return false;
  const Window room = window(axis, line, line + 1);
  const int first = axis.origin + axis.at(line), second = axis.origin + axis.at(line + 1);
  back.below(axis.count - 1, line);
  back.among(axis.profile, room.low, room.high - 1, first);
  back.among(axis.profile, first + 1, room.high, second);
  const int place = forward.among(axis.profile, room.low, room.high);
  axis.remove_line(line + 1);
  axis.lines[static_cast<size_t>(line)] = static_cast<int16_t>(place - axis.origin);
  return true;
}

bool split_lines(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return is_grid(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip(), split = forward.flip();
  back.flip(along_x), back.flip(!split);
  GridAxis axis(context, state, i, along_x);
  const auto change =
      axis.regular ? (split ? split_all : merge_all) : (split ? split_one : merge_two);
  if (!change(axis, context.model.limits().max_lines, forward, back)) return false;
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(split_lines) {
  return {{"split_lines", "move", "Splits columns or rows of a grid, or merges them.", "", {}},
          1,
          split_lines};
}
