// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/pass.h>
#include <vug/mesh/point_grid.h>

#include <algorithm>
#include <utility>

namespace vug::cells {
namespace {

/// The cells around each cell, in ascending order.
Links links_within(const Network& n, double radius) {
  const mesh::PointGrid grid(n.position, radius * 1.001);
  const auto limit = static_cast<float>(radius * radius);
  std::vector<std::vector<uint32_t>> rows(n.size());
  grid.for_each_cube([&](mesh::PointGrid::Run cube, const mesh::PointGrid::Runs& around) {
    for (uint32_t slot = cube.begin; slot < cube.end; ++slot) {
      const uint32_t i = grid.order()[slot];
      for (const mesh::PointGrid::Run& run : around)
        for (uint32_t other = run.begin; other < run.end; ++other) {
          const uint32_t j = grid.order()[other];
          if (j != i && (n.position[j] - n.position[i]).length2() < limit &&
              n.normal[i].dot(n.normal[j]) > 0)
            rows[i].push_back(j);
        }
      std::sort(rows[i].begin(), rows[i].end());
    }
  });
  return make_links(n.size(), [&](uint32_t i, const auto& add) {
    for (const uint32_t j : rows[i]) add(j);
  });
}

}  // namespace

Pass::Pass(Simulation& simulation, RandomKey key, int step, const std::vector<uint8_t>* where)
    : simulation_(&simulation),
      network_(simulation.network_.get()),
      blocks_(&simulation.blocks_),
      states_(&simulation.states_.now),
      key_(key),
      step_(step),
      where_(where) {}

const Attributes& Pass::attributes() const { return simulation_->attributes_; }

OptionalReader Pass::reads_optional(const std::string& name, float otherwise) const {
  const Attributes& all = attributes();
  return {all.find(name) ? all.values<float>(name).data() : nullptr, otherwise};
}

OptionalReader Pass::reads_expected(const std::string& name, float otherwise) const {
  simulation_->requested_.try_emplace(name, false);
  return reads_optional(name, otherwise);
}

NumericReader Pass::reads_as_numbers(const std::string& name) const {
  simulation_->requested_[name] = true;
  return {attributes().find(name)};
}

double Pass::evaluate(const paint::Mask& mask, uint32_t cell) const {
  return simulation_->evaluate(mask, cell);
}

bool Pass::has(const std::string& name) const { return attributes().find(name); }

AttributeReader<Vec3f> Pass::positions() const {
  const Attributes& all = attributes();
  return {all.find("P") ? all.values<Vec3f>("P").data() : network_->position.data()};
}

AttributeWriter<Vec3f> Pass::writes_positions() {
  const bool known = simulation_->attributes_.find("P");
  Column<Vec3f>& column = simulation_->attributes_.column<Vec3f>("P");
  if (!known) column.now = network_->position;
  return write(column);
}

bool Pass::is_trial() const { return simulation_->is_trial(); }

AttributeWriter<Vec3f> Pass::writes_normals() {
  const bool known = simulation_->attributes_.find("N");
  Column<Vec3f>& column = simulation_->attributes_.column<Vec3f>("N");
  if (!known) column.now = network_->normal;
  return write(column);
}

AttributeWriter<CellState> Pass::writes_states() {
  Column<CellState>& column = simulation_->states_;
  if (column.next.empty()) column.next = column.now;
  writes_states_ = true;
  return {column.now.data(), column.next.data()};
}

const Links& Pass::within(double radius) {
  const auto [at, fresh] = simulation_->within_.try_emplace(radius);
  if (fresh) at->second = links_within(*network_, radius);
  return at->second;
}

uint32_t Pass::pick(uint32_t block, uint32_t* picked) const {
  uint32_t count = 0;
  for (uint32_t i = blocks_->first(block); i < blocks_->end(block); ++i) {
    if (!receives((*states_)[i])) continue;
    if (!where_ || (*where_)[i])
      picked[count++] = i;
    else
      keep(i);
  }
  return count;
}

void Pass::keep(uint32_t cell) const {
  for (const auto& column : written_)
    std::visit([&](auto* c) { c->next[cell] = c->now[cell]; }, column);
  if (writes_states_) simulation_->states_.next[cell] = simulation_->states_.now[cell];
}

void Pass::finish(const std::vector<uint32_t>& blocks, bool everywhere) {
  Column<CellState>& states = simulation_->states_;
  for (const auto& column : written_)
    std::visit([](auto* c) { std::swap(c->now, c->next); }, column);
  written_.clear();
  const bool states_changed = std::exchange(writes_states_, false);
  if (states_changed) std::swap(states.now, states.next);
  if (!states_changed && !everywhere) return;
  // A cell that no longer receives is not written any more, so both of its buffers must agree.
  const auto rest = [&](uint32_t i) {
    for (Attribute& attribute : simulation_->attributes_.all())
      std::visit(
          [&](auto& c) {
            if (!c.next.empty()) c.next[i] = c.now[i];
          },
          attribute.column);
    if (!states.next.empty()) states.next[i] = states.now[i];
  };
  parallel_for(blocks.size(), [&](size_t b) {
    for (uint32_t i = blocks_->first(blocks[b]); i < blocks_->end(blocks[b]); ++i)
      if (!receives(states.now[i]) && (everywhere || receives(states.next[i]))) rest(i);
  });
  if (states_changed) simulation_->blocks_.update(blocks, states.now);
}

}  // namespace vug::cells
