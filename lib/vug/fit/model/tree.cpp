// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/model/tree.h>

#include <algorithm>
#include <cstdlib>

namespace vug::fit {

Lines even_lines(int first, int span, int count) {
  Lines out{};
  const int gaps = count > 1 ? count - 1 : 1;
  for (int i = 0; i < count; ++i)
    out[static_cast<size_t>(i)] = static_cast<int16_t>(first + (2 * i * span + gaps) / (2 * gaps));
  return out;
}

Lines nearest_even(const Lines& lines, int count) {
  constexpr int kNear = 3;
  const int span = lines[static_cast<size_t>(count - 1)] - lines[0];
  Lines best = lines;
  int smallest = -1;
  for (int first = std::max(0, lines[0] - kNear); first <= lines[0] + kNear; ++first)
    for (int wide = count > 1 ? span - 2 * kNear : 0; wide <= (count > 1 ? span + 2 * kNear : 0);
         ++wide) {
      const Lines even = even_lines(first, wide, count);
      int off = 0;
      for (size_t i = 0; i < static_cast<size_t>(count); ++i) off += std::abs(even[i] - lines[i]);
      if (smallest >= 0 && off >= smallest) continue;
      smallest = off;
      best = even;
    }
  return best;
}

Cells Node::full_cells() const {
  Node full;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) full.set_kind(column, row, 1);
  return full.cells;
}

int Tree::parent(int i) const {
  for (int above = i - 1; above >= 0; --above)
    if (end(above) > i) return above;
  return -1;
}

int Tree::child_count(int i) const {
  int count = 0;
  for (int at = i + 1; at < end(i); at = end(at)) ++count;
  return count;
}

int Tree::child(int i, int number) const {
  int at = i + 1;
  for (; number > 0; --number) at = end(at);
  return at;
}

void Tree::resize_above(int i, int by) {
  for (int above = 0; above <= i; ++above)
    if (end(above) > i) (*this)[above].size = static_cast<int16_t>((*this)[above].size + by);
}

void Tree::grow(int i, int production, const std::vector<Node>& parts) {
  resize_above(i, static_cast<int>(parts.size()));
  (*this)[i].production = static_cast<int16_t>(production);
  nodes.insert(nodes.begin() + i + 1, parts.begin(), parts.end());
}

void Tree::prune(int i) {
  const int below = (*this)[i].size - 1;
  nodes.erase(nodes.begin() + i + 1, nodes.begin() + i + 1 + below);
  resize_above(i, -below);
  (*this)[i].production = -1;
}

void Tree::insert(int i, int at, const Node& node) {
  resize_above(i, 1);
  nodes.insert(nodes.begin() + at, node);
}

void Tree::erase(int i, int at) {
  const int size = (*this)[at].size;
  nodes.erase(nodes.begin() + at, nodes.begin() + at + size);
  resize_above(i, -size);
}

void Tree::replace(int i, const std::vector<Node>& subtree) {
  const int size = (*this)[i].size;
  for (int above = 0; above < i; ++above)
    if (end(above) > i)
      (*this)[above].size =
          static_cast<int16_t>((*this)[above].size + static_cast<int>(subtree.size()) - size);
  nodes.erase(nodes.begin() + i, nodes.begin() + i + size);
  nodes.insert(nodes.begin() + i, subtree.begin(), subtree.end());
}

}  // namespace vug::fit
