// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/facade/blocks.h>
#include <vug/facade/semantics.h>
#include <vug/field/affine.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::facade {
namespace {

constexpr const char* kNode = "node";
constexpr const char* kWall = "wall";
/// Distances that differ by less, in metres, are equal: rounding of coordinates.
constexpr double kSameDistance = 1e-7;

Box3d flat_box(const Rect& rect, double depth) {
  return {{rect.x, rect.y, depth}, {rect.right(), rect.top(), depth}};
}

const std::string& kind_of(const Node& node) {
  static const std::string wall = kWall;
  return node.element ? node.element->kind() : wall;
}

}  // namespace

Semantics::Semantics(FacadeInstance placed)
    : placed_(std::move(placed)),
      to_facade_(placed_.frame.transform(placed_.tree->width).inverse()) {
  element_instances(tree());  // throws if there are too many
  for (size_t i = 0; i < tree().nodes.size(); ++i) {
    const Node& node = tree().nodes[i];
    const int index = static_cast<int>(i);
    const double from = node.parent < 0 ? 0 : tree().nodes[static_cast<size_t>(node.parent)].depth;
    Solids one;
    if (node.element) one = solids_of(node);
    // Only the corners next to an arch remain of a hole's rectangle; they belong to the wall.
    const bool has_face = one.cut.empty() || kind_of(node) == kWall;
    for (const Placement& place : placements(tree(), index)) {
      const Rect rect = place(node.rect);
      if (has_face) pieces_.push_back({index, flat_box(rect, node.depth), {}, true});
      if (node.depth != from)
        add(index, block(rect, std::min(from, node.depth), std::max(from, node.depth)));
      const Transform frame = frame_of(node, place);
      for (const auto* parts : {&one.cut, &one.add, &one.fill})
        for (const field::Field& part : *parts) add(index, field::transformed(part, frame));
    }
  }
  std::vector<Box3d> boxes;
  boxes.reserve(pieces_.size());
  for (const Piece& piece : pieces_) boxes.push_back(piece.box);
  boxes_ = mesh::BoxTree(boxes);
}

void Semantics::add(int node, field::Field solid) {
  const Box3d box = solid.bounds();
  pieces_.push_back({node, box, std::move(solid), false});
}

int Semantics::node_at(const Vec3d& world) const {
  const Vec3d p = to_facade_.point(world);
  int node = -1;
  double least = kMaxWeathering;
  boxes_.visit_nearest(p, least * least, [&](uint32_t item) {
    const Piece& piece = pieces_[item];
    const double away =
        piece.flat ? std::sqrt(squared_distance(p, piece.box)) : std::abs(piece.solid.value(p));
    if (away < least - kSameDistance || (away < least + kSameDistance && piece.node > node))
      node = piece.node;
    least = std::min(least, away);
    return (least + kSameDistance) * (least + kSameDistance);
  });
  return node;
}

std::vector<std::string> element_names(const Facades& facades) {
  if (facades.empty()) return {};
  std::set<std::string> kinds{kWall};
  for (const auto& facade : facades)
    for (const Node& node : facade->tree->nodes) kinds.insert(kind_of(node));
  return {kinds.begin(), kinds.end()};
}

std::vector<std::string> semantic_names(const Facades& facades) {
  std::vector<std::string> names = element_names(facades);
  names.emplace_back(kNode);
  return names;
}

void add_semantics(mesh::Mesh& mesh, const Facades& facades) {
  const size_t count = mesh.positions.size();
  const std::vector<std::string> kinds = element_names(facades);
  std::vector<Semantics> asked;
  for (const auto& facade : facades) asked.emplace_back(*facade);
  std::vector<int> kind_at(count, -1);
  mesh::Attribute nodes{kNode, 1, std::vector<float>(count, -1)};
  parallel_for(
      count,
      [&](size_t i) {
        int before = 0;
        for (const Semantics& facade : asked) {
          const int node = facade.node_at(Vec3d(mesh.positions[i]));
          if (node >= 0) {
            nodes.values[i] = static_cast<float>(before + node);
            const std::string& kind = kind_of(facade.tree().nodes[static_cast<size_t>(node)]);
            kind_at[i] = static_cast<int>(std::lower_bound(kinds.begin(), kinds.end(), kind) -
                                          kinds.begin());
            return;
          }
          before += static_cast<int>(facade.tree().nodes.size());
        }
      },
      1024);
  for (size_t k = 0; k < kinds.size(); ++k) {
    mesh::Attribute mask{kinds[k], 1, std::vector<float>(count)};
    for (size_t i = 0; i < count; ++i) mask.values[i] = kind_at[i] == static_cast<int>(k) ? 1.f : 0;
    mesh.attributes.push_back(std::move(mask));
  }
  mesh.attributes.push_back(std::move(nodes));
}

}  // namespace vug::facade
