// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/cells/transfer_to_mesh.h>
#include <vug/mesh/displacement.h>
#include <vug/mesh/normals.h>
#include <vug/mesh/point_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::cells {
namespace {

struct WeightedCell {
  uint32_t cell;
  double weight;
};

/// An attribute in transfer: read from cells, written to vertices.
struct AttributeTransfer {
  std::variant<const std::vector<float>*, const std::vector<Vec3f>*, const std::vector<int32_t>*,
               const std::vector<CellState>*>
      from;
  mesh::Attribute to;
  bool is_colour = false;
};

double component(float value, int) { return static_cast<double>(value); }
double component(const Vec3f& value, int c) { return static_cast<double>(value[c]); }
double component(int32_t value, int) { return value; }
double component(CellState value, int) { return value == CellState::transparent ? 1 : 0; }

/// The mean as the first value plus the mean difference of the others: exact if all are equal.
template <class T, class Value>
double mean(const std::vector<WeightedCell>& shares, const Value& value) {
  const double first = value(shares[0].cell);
  double sum = 0, weights = 0;
  for (const WeightedCell& share : shares) {
    sum += share.weight * (value(share.cell) - first);
    weights += share.weight;
  }
  return first + sum / weights;
}

void write(AttributeTransfer& transfer, const std::vector<WeightedCell>& shares, size_t vertex) {
  const auto arity = static_cast<size_t>(transfer.to.arity);
  float* out = transfer.to.values.data() + vertex * arity;
  std::visit(
      [&](const auto* from) {
        using T = typename std::decay_t<decltype(*from)>::value_type;
        for (int c = 0; c < transfer.to.arity; ++c) {
          const auto under = static_cast<double>(out[c]);
          out[c] = static_cast<float>(mean<T>(shares, [&](uint32_t cell) {
            const T& value = (*from)[cell];
            if constexpr (std::is_same_v<T, Vec3f>)
              if (transfer.is_colour && value == Vec3f(0)) return under;
            return component(value, c);
          }));
        }
      },
      transfer.from);
}

class MeshTransfer {
 public:
  MeshTransfer(const Network& network, const mesh::Mesh& mesh,
               std::vector<AttributeTransfer>& transfers)
      : network_(network), mesh_(mesh), transfers_(transfers) {}

  /// Fills these vertices from cells within the radius; returns those without any.
  std::vector<uint32_t> carry(const std::vector<uint32_t>& vertices, double radius,
                              bool any_side) const {
    const auto cells = static_cast<uint32_t>(network_.size());
    std::vector<Vec3f> points = network_.position;
    for (const uint32_t v : vertices) points.push_back(mesh_.positions[v]);
    std::vector<uint8_t> found(vertices.size(), 0);
    const mesh::PointGrid grid(points, radius);
    grid.for_each_cube([&](const mesh::PointGrid::Run& own, const mesh::PointGrid::Runs& around) {
      std::vector<uint32_t> near;
      std::vector<WeightedCell> shares;
      bool looked = false;
      for (uint32_t place = own.begin; place < own.end; ++place) {
        if (grid.order()[place] < cells) continue;
        if (!looked)
          for (const mesh::PointGrid::Run& run : around)
            for (uint32_t k = run.begin; k < run.end; ++k)
              if (grid.order()[k] < cells) near.push_back(grid.order()[k]);
        looked = true;
        const uint32_t at = grid.order()[place] - cells;
        weigh(vertices[at], near, radius, any_side, shares);
        if (shares.empty()) continue;
        for (AttributeTransfer& transfer : transfers_) write(transfer, shares, vertices[at]);
        found[at] = 1;
      }
    });
    std::vector<uint32_t> left;
    for (size_t i = 0; i < vertices.size(); ++i)
      if (!found[i]) left.push_back(vertices[i]);
    return left;
  }

 private:
  void weigh(uint32_t vertex, const std::vector<uint32_t>& near, double radius, bool any_side,
             std::vector<WeightedCell>& shares) const {
    shares.clear();
    size_t heaviest = 0;
    for (const uint32_t cell : near) {
      const Vec3d d = Vec3d(network_.position[cell]) - Vec3d(mesh_.positions[vertex]);
      const double within = 1 - d.length2() / (radius * radius);
      if (within <= 0) continue;
      const double alike =
          any_side ? 1 : Vec3d(network_.normal[cell]).dot(Vec3d(mesh_.normals[vertex]));
      const double weight = alike > 0 ? within * within * alike * alike : 0;
      if (weight < std::numeric_limits<float>::min()) continue;
      shares.push_back({cell, weight});
      if (weight > shares[heaviest].weight) heaviest = shares.size() - 1;
    }
    if (!shares.empty()) std::swap(shares[0], shares[heaviest]);
  }

  const Network& network_;
  const mesh::Mesh& mesh_;
  std::vector<AttributeTransfer>& transfers_;
};

/// Takes the attribute of this name from the mesh; a new one is 0, colours are white.
mesh::Attribute take_attribute(mesh::Mesh& mesh, const std::string& name, int arity) {
  mesh::Attribute out{name, arity, {}};
  auto& all = mesh.attributes;
  const auto known = std::find_if(all.begin(), all.end(),
                                  [&](const mesh::Attribute& each) { return each.name == name; });
  if (known != all.end() && known->arity == arity) out.values = std::move(known->values);
  if (known != all.end()) all.erase(known);
  out.values.resize(mesh.positions.size() * static_cast<size_t>(arity),
                    name == mesh::kColour ? 1.0f : 0.0f);
  return out;
}

std::vector<AttributeTransfer> transfers_of(const Simulation& simulation, mesh::Mesh& mesh) {
  std::vector<AttributeTransfer> transfers;
  for (const Attribute& attribute : simulation.attributes().all()) {
    if (attribute.name == "P" || attribute.name == "N") continue;
    std::visit(
        [&](const auto& column) {
          const bool vector = std::is_same_v<std::decay_t<decltype(column)>, Column<Vec3f>>;
          transfers.push_back({&column.now, take_attribute(mesh, attribute.name, vector ? 3 : 1),
                               vector && attribute.name == mesh::kColour});
        },
        attribute.column);
  }
  if (!simulation.attributes().find(kTransparent))
    transfers.push_back(
        {&simulation.states(), take_attribute(mesh, std::string(kTransparent), 1), false});
  return transfers;
}

/// Displacement of each cell; empty if no rule moves cells.
std::vector<Vec3f> displacements(const Simulation& simulation) {
  const Attribute* place = simulation.attributes().find(kPlace);
  const auto* column = place ? std::get_if<Column<Vec3f>>(&place->column) : nullptr;
  if (!column) return {};
  std::vector<Vec3f> displacement(column->now.size());
  for (size_t i = 0; i < displacement.size(); ++i)
    displacement[i] = column->now[i] - simulation.network().position[i];
  return displacement;
}

/// Moves the vertices by `displacements` (three numbers each) and by `height` along their normals;
/// either may be null.
size_t move_vertices(mesh::Mesh& mesh, const std::vector<float>* displacements,
                     const std::vector<float>* height, bool folds) {
  const std::vector<Vec3f> before = mesh::vertex_normals(mesh), from = mesh.positions;
  size_t changed = 0;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    Vec3f& p = mesh.positions[v];
    if (displacements)
      p += Vec3f((*displacements)[3 * v], (*displacements)[3 * v + 1], (*displacements)[3 * v + 2]);
    if (height) p += mesh.normals[v] * (*height)[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw Error(ErrorCode::bad_input, "cells move the surface to positions that are not finite");
  }
  if (!folds) {
    const std::vector<Vec3f> full = mesh.positions;
    mesh::prevent_folds(from, mesh, !displacements);
    mesh::prevent_crossings(from, mesh);
    for (size_t v = 0; v < full.size(); ++v) changed += full[v] != mesh.positions[v];
  }
  const std::vector<Vec3f> after = mesh::vertex_normals(mesh);
  for (size_t v = 0; v < mesh.normals.size(); ++v) {
    const Vec3f turned = mesh.normals[v] + (after[v] - before[v]);
    mesh.normals[v] = turned.dot(after[v]) > 0 ? turned.normalized() : after[v];
  }
  return changed;
}

void add_normals(mesh::Mesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0));
  for (size_t face = 0; face < mesh.triangles.size(); ++face)
    for (const uint32_t v : mesh.triangles[face]) sums[v] += double_area_vector(mesh, face);
  for (const Vec3d& sum : sums) mesh.normals.emplace_back(Vec3f(sum.normalized()));
}

double mean_edge(const mesh::Mesh& mesh) {
  double sum = 0;
  for (const mesh::Triangle& t : mesh.triangles)
    for (size_t k = 0; k < 3; ++k)
      sum += (Vec3d(mesh.positions[t[k]]) - Vec3d(mesh.positions[t[(k + 1) % 3]])).length();
  return mesh.triangles.empty() ? 0 : sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

size_t transfer_to_mesh(const Simulation& simulation, mesh::Mesh& mesh,
                        const TransferOptions& options, Progress& progress) {
  const Network& network = simulation.network();
  std::vector<AttributeTransfer> transfers = transfers_of(simulation, mesh);
  const std::vector<Vec3f> displaced =
      options.move ? displacements(simulation) : std::vector<Vec3f>();
  if (!displaced.empty()) transfers.push_back({&displaced, take_attribute(mesh, "", 3), false});
  const bool bare = mesh.normals.empty();
  if (bare) add_normals(mesh);
  const Box3d box = mesh::bounds(mesh);
  progress.begin("cells onto the mesh", 1);
  if (network.size() > 0 && !box.isEmpty()) {
    Box3d all = box;
    for (const Vec3f& p : network.position) all.extendBy(Vec3d(p));
    const MeshTransfer mesh_transfer(network, mesh, transfers);
    double radius = std::max(network.reach, mean_edge(mesh));
    std::vector<uint32_t> left(mesh.positions.size());
    for (size_t i = 0; i < left.size(); ++i) left[i] = static_cast<uint32_t>(i);
    for (bool any_side = false; !left.empty(); radius *= 2) {
      progress.check();
      left = mesh_transfer.carry(left, radius, any_side);
      any_side = radius > all.size().length();
    }
  }
  progress.advance();
  const auto height =
      std::find_if(transfers.begin(), transfers.end(), [](const AttributeTransfer& transfer) {
        return transfer.to.name == kHeight && transfer.to.arity == 1;
      });
  const bool rises = options.move && height != transfers.end();
  size_t changed = 0;
  if (rises || !displaced.empty()) {
    progress.begin("displacement by the cells");
    changed = move_vertices(mesh, displaced.empty() ? nullptr : &transfers.back().to.values,
                            rises ? &height->to.values : nullptr, options.folds);
  }
  progress.end();
  if (!displaced.empty()) transfers.pop_back();
  if (bare) mesh.normals.clear();
  for (AttributeTransfer& transfer : transfers) mesh.attributes.push_back(std::move(transfer.to));
  return changed;
}

}  // namespace vug::cells
