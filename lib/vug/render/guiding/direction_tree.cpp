#include <vug/render/guiding/direction_tree.h>
#include <vug/render/sampling.h>

namespace vug::render {
namespace {

constexpr uint32_t kNone = ~0u;

/// Which quarter of the square a place lies in; the place becomes one within that quarter.
size_t enter(Vec2f& place) {
  const bool right = place.x >= 0.5f, upper = place.y >= 0.5f;
  place = {2 * place.x - (right ? 1.0f : 0.0f), 2 * place.y - (upper ? 1.0f : 0.0f)};
  return (right ? 1u : 0u) + (upper ? 2u : 0u);
}

/// Takes one of two halves with the odds of the first; `u` becomes a number within that half.
bool second_half(float& u, float first) {
  const bool second = u >= first;
  const float size = second ? 1 - first : first;
  u = size > 0 ? std::min((second ? u - first : u) / size, 0.99999994f) : 0.5f;
  return second;
}

}  // namespace

DirectionTree::DirectionTree() : nodes_(1) {}

size_t DirectionTree::leaf(const Vec3f& direction) const {
  Vec2f place = place_of(direction);
  for (uint32_t node = 0;;) {
    const size_t quarter = enter(place);
    const uint32_t child = nodes_[node].child[quarter];
    if (child == 0) return 4 * static_cast<size_t>(node) + quarter;
    node = child;
  }
}

double DirectionTree::gather(uint32_t node, const std::vector<double>& gathered) {
  std::array<double, 4> sums{};
  double total = 0;
  for (size_t quarter = 0; quarter < 4; ++quarter) {
    const uint32_t child = nodes_[node].child[quarter];
    sums[quarter] = child ? gather(child, gathered) : gathered[4 * size_t{node} + quarter];
    total += sums[quarter];
  }
  for (size_t quarter = 0; quarter < 4; ++quarter)
    nodes_[node].part[quarter] = total > 0 ? static_cast<float>(sums[quarter] / total) : 0.25f;
  return total;
}

DirectionTree DirectionTree::weighed(const std::vector<double>& gathered) const {
  DirectionTree out = *this;
  out.gather(0, gathered);
  return out;
}

void DirectionTree::cut(const DirectionTree& from, uint32_t source, uint32_t node, double held,
                        double share, int deeper) {
  for (size_t quarter = 0; quarter < 4; ++quarter) {
    // A square that was not cut before has the same density everywhere.
    const double part =
        held * (source == kNone ? 0.25 : static_cast<double>(from.nodes_[source].part[quarter]));
    if (!(part > share) || deeper == 0) continue;
    const uint32_t below = source == kNone ? 0 : from.nodes_[source].child[quarter];
    const auto child = static_cast<uint32_t>(nodes_.size());
    nodes_.emplace_back();
    nodes_[node].child[quarter] = child;
    cut(from, below ? below : kNone, child, part, share, deeper - 1);
  }
}

DirectionTree DirectionTree::recut(double share, int deepest) const {
  DirectionTree out;
  out.cut(*this, 0, 0, 1, share, deepest - 1);
  return out;
}

Vec3f DirectionTree::sample(const Vec2f& numbers) const {
  Vec2f u = numbers, corner(0.0f);
  float size = 1;
  for (uint32_t node = 0;;) {
    const auto& part = nodes_[node].part;
    const float lower = part[0] + part[1];
    const bool upper = second_half(u.y, lower);
    const float across = upper ? part[2] + part[3] : lower;
    const bool right = second_half(u.x, across > 0 ? part[upper ? 2 : 0] / across : 0.5f);
    size *= 0.5f;
    corner += Vec2f(right ? size : 0, upper ? size : 0);
    const uint32_t child = nodes_[node].child[(right ? 1u : 0u) + (upper ? 2u : 0u)];
    if (child == 0) return direction_of(corner + u * size);
    node = child;
  }
}

float DirectionTree::pdf(const Vec3f& direction) const {
  Vec2f place = place_of(direction);
  float density = 1 / (4 * kPif);
  for (uint32_t node = 0;;) {
    const size_t quarter = enter(place);
    density *= 4 * nodes_[node].part[quarter];
    const uint32_t child = nodes_[node].child[quarter];
    if (child == 0) return density;
    node = child;
  }
}

}  // namespace vug::render
