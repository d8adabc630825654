// SPDX-License-Identifier: Apache-2.0
// Inserts or deletes a column or row: anywhere in an irregular grid, at either end of a regular
// one.
#include <vug/fit/model/cells.h>

namespace vug::fit {
namespace {

/// Span of `count` evenly spaced lines without the last one.
int shortened(int span, int count) {
  return even_lines(0, span, count)[static_cast<size_t>(count - 2)];
}

/// Span after adding a line: a span that shortens to the current one, or any span with room if
/// there is a single line.
int choose_longer(int count, int span, int room, int min_size, Choices& choices, int fixed) {
  if (count == 1) return choices.between(min_size + 1, room, fixed);
  int low = span;
  while (shortened(low, count + 1) < span) ++low;
  int high = low;
  while (shortened(high + 1, count + 1) == span) ++high;
  return choices.between(low, high, fixed);
}

/// Inserts before the first line of a regular grid or after the last one.
bool insert_at_end(GridAxis& axis, int min_size, Choices& forward, Choices& back) {
  const bool low = forward.flip();
  const int first = axis.at(0), last = first + axis.span();
  const int room = low ? last : axis.room - min_size - first;
  const int span = choose_longer(axis.count, axis.span(), room, min_size, forward, 0);
  if (!forward.possible()) return false;
  const int line = low ? 0 : axis.count;
  axis.insert_line(line, 0);
  axis.space_evenly(low ? last - span : first, span);
  back.flip(low);
  return axis.choose_cells(line, forward);
}

bool delete_at_end(GridAxis& axis, int min_size, Choices& forward, Choices& back) {
  const bool low = forward.flip();
  back.flip(low);
  const int line = low ? 0 : axis.count - 1;
  const int first = axis.at(0), span = axis.span(), last = first + span;
  const int left = shortened(span, axis.count);
  choose_longer(axis.count - 1, left, low ? last : axis.room - min_size - first, min_size, back,
                span);
  axis.choose_cells(line, back);
  axis.remove_line(line);
  axis.space_evenly(low ? last - left : first, left);
  return true;
}

bool insert_anywhere(GridAxis& axis, int min_size, Choices& forward, Choices& back) {
  const int place =
      forward.among(axis.profile, axis.origin, axis.origin + axis.room - min_size + 1) -
      axis.origin;
  int line = 0;
  while (line < axis.count && axis.at(line) < place) ++line;
  axis.insert_line(line, place);
  back.below(axis.count, line);
  return axis.choose_cells(line, forward);
}

bool delete_any(GridAxis& axis, int min_size, Choices& forward, Choices& back) {
  const int line = forward.below(axis.count);
  back.among(axis.profile, axis.origin, axis.origin + axis.room - min_size + 1,
             axis.origin + axis.at(line));
  axis.choose_cells(line, back);
  axis.remove_line(line);
  return true;
}

bool change_lines(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return is_grid(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip(), insert = forward.flip();
  back.flip(along_x), back.flip(!insert);
  GridAxis axis(context, state, i, along_x);
  const Limits& limits = context.model.limits();
  if (insert ? axis.count >= limits.max_lines : axis.count < 2) return false;
  const auto change = axis.regular ? (insert ? insert_at_end : delete_at_end)
                                   : (insert ? insert_anywhere : delete_any);
  if (!change(axis, limits.min_size, forward, back)) return false;
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(lines) {
  return {{"lines", "move", "Inserts a column or row into a grid, or deletes one.", "", {}},
          3,
          change_lines};
}
