// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/base/error.h>
#include <vug/cells/network.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace vug::cells {
namespace {

constexpr uint32_t kNone = ~0u;

bool is_unit(const Vec3f& v) { return std::fabs(v.length2() - 1) < 2e-4f; }

template <class T>
void add_array(Hasher& hasher, const std::vector<T>& values) {
  hasher.add_value(values.size()).add(values.data(), values.size() * sizeof(T));
}

/// The fault of a cell, or empty.
std::string fault(const Network& n, uint32_t i) {
  for (const Vec3f& v : {n.position[i], n.normal[i], n.right[i]})
    if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z))) return "is not finite";
  if (!std::isfinite(n.area[i]) || n.area[i] < 0) return "has no area";
  if (!is_unit(n.normal[i]) || !is_unit(n.right[i]) ||
      std::fabs(n.normal[i].dot(n.right[i])) > 1e-4f)
    return "has no orthonormal frame";
  if (n.links.degree(i) > n.full) return "has too many links";
  uint32_t last = kNone;
  for (const uint32_t to : n.links.of(i)) {
    if (to >= n.size() || to == i) return "is linked to a cell that does not exist or to itself";
    if (last != kNone && to <= last) return "has links out of order";
    last = to;
    const auto back = n.links.of(to);
    if (!std::binary_search(back.begin(), back.end(), i)) return "has a link that is not mutual";
  }
  return {};
}

}  // namespace

uint64_t Network::bytes() const {
  return (3 * sizeof(Vec3f) + sizeof(float) + sizeof(uint32_t)) * size() +
         sizeof(uint32_t) * (links.begin.size() + links.to.size());
}

uint64_t position_key(const Vec3f& p) {
  // Adding 0 makes -0 and 0 equal. Multipliers: the golden ratio's, and those of splitmix64.
  const auto bits = [](float x) { return uint64_t{std::bit_cast<uint32_t>(x + 0.0f)}; };
  uint64_t h = (bits(p.x) << 32 | bits(p.y)) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ bits(p.z) << 16) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 31)) * 0x94D049BB133111EBu;
  return h ^ (h >> 30);
}

std::vector<uint32_t> components(const Links& links) {
  DisjointSets<> sets(links.size());
  for (uint32_t i = 0; i < links.size(); ++i)
    for (const uint32_t to : links.of(i)) sets.join(i, to);
  std::vector<uint32_t> piece(links.size(), kNone);
  uint32_t count = 0;
  for (uint32_t i = 0; i < links.size(); ++i) {
    const uint32_t root = sets.root(i);  // The smallest cell of its component.
    piece[i] = root == i ? count++ : piece[root];
  }
  return piece;
}

Digest digest(const Network& n) {
  Hasher hasher;
  hasher.add("network").add_value(n.spacing).add_value(n.reach).add_value(n.full);
  add_array(hasher, n.position);
  add_array(hasher, n.normal);
  add_array(hasher, n.right);
  add_array(hasher, n.area);
  add_array(hasher, n.object);
  add_array(hasher, n.links.begin);
  add_array(hasher, n.links.to);
  return hasher.finish();
}

void validate(const Network& n) {
  const size_t count = n.size();
  if (n.normal.size() != count || n.right.size() != count || n.area.size() != count ||
      n.object.size() != count || n.links.size() != count)
    throw Error(ErrorCode::internal, "a network's arrays differ in length");
  for (uint32_t i = 0; i < count; ++i)
    if (const std::string what = fault(n, i); !what.empty())
      throw Error(ErrorCode::internal, fmt::format("cell {} {}", i, what));
}

}  // namespace vug::cells
