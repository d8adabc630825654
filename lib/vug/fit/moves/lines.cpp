// Puts a column or row into a grid, or takes one out: anywhere in an irregular one, at the ends of
// a regular one.
#include <vug/fit/cells.h>

namespace vug::fit {
namespace {

/// Before the first line of a regular grid or behind the last one. The distance is chosen where
/// there was but one line.
bool insert_at_end(GridAxis& axis, int least, Choices& forward, Choices& back) {
  const bool low = forward.flip();
  int pitch = axis.pitch();
  if (axis.count == 1)
    pitch = forward.between(least + 1, low ? axis.at(0) : axis.room - least - axis.at(0));
  const int line = low ? 0 : axis.count;
  axis.open(line, low ? axis.at(0) - pitch : axis.at(axis.count - 1) + pitch);
  back.flip(low);
  return axis.choose_cells(line, forward) && forward.possible();
}

bool delete_at_end(GridAxis& axis, int least, Choices& forward, Choices& back) {
  const bool low = forward.flip();
  back.flip(low);
  const int pitch = axis.pitch(), line = low ? 0 : axis.count - 1;
  if (axis.count == 2) {
    const int stays = axis.at(low ? 1 : 0);
    back.between(least + 1, low ? stays : axis.room - least - stays, pitch);
  }
  axis.choose_cells(line, back);
  axis.close(line);
  return true;
}

bool insert_anywhere(GridAxis& axis, int least, Choices& forward, Choices& back) {
  const int place =
      forward.among(axis.profile, axis.origin, axis.origin + axis.room - least + 1) - axis.origin;
  int line = 0;
  while (line < axis.count && axis.at(line) < place) ++line;
  axis.open(line, place);
  back.below(axis.count, line);
  return axis.choose_cells(line, forward);
}

bool delete_any(GridAxis& axis, int least, Choices& forward, Choices& back) {
  const int line = forward.below(axis.count);
  back.among(axis.profile, axis.origin, axis.origin + axis.room - least + 1,
             axis.origin + axis.at(line));
  axis.choose_cells(line, back);
  axis.close(line);
  return true;
}

bool change_lines(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return is_grid(shop, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip(), insert = forward.flip();
  back.flip(along_x), back.flip(!insert);
  GridAxis axis(shop, state, i, along_x);
  const Limits& limits = shop.model.limits();
  if (insert ? axis.count >= limits.most_lines : axis.count < 2) return false;
  const auto change = axis.regular ? (insert ? insert_at_end : delete_at_end)
                                   : (insert ? insert_anywhere : delete_any);
  if (!change(axis, limits.least, forward, back)) return false;
  state.changed(i);
  return shop.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(lines) {
  return {{"lines", "move", "Puts a column or row into a grid, or takes one out.", "", {}},
          3,
          change_lines};
}
