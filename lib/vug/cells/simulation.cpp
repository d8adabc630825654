// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/cells/rule.h>
#include <vug/mesh/point_grid.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::cells {

Simulation::Simulation(NetworkPtr network, RandomKey key)
    : network_(std::move(network)),
      key_(key),
      attributes_(network_->size()),
      states_{std::vector<CellState>(network_->size(), CellState::active), {}},
      blocks_(network_->links, states_.now) {}

void Simulation::set_states(std::vector<CellState> states) {
  if (states.size() != network_->size())
    throw Error(ErrorCode::internal, "the number of states differs from the number of cells");
  // Copies the values of cells that may have been written just before.
  for (Attribute& attribute : attributes_.all())
    std::visit(
        [](auto& column) {
          if (!column.next.empty()) column.next = column.now;
        },
        attribute.column);
  states_.now = std::move(states);
  if (!states_.next.empty()) states_.next = states_.now;
  blocks_.update(blocks_.all(), states_.now);
}

namespace {

template <class T>
uint64_t bytes_of(const Column<T>& column) {
  return sizeof(T) * (column.now.size() + column.next.size());
}

}  // namespace

uint64_t Simulation::bytes() const {
  uint64_t bytes = network_->bytes() + bytes_of(states_);
  for (const Attribute& attribute : attributes_.all())
    bytes += std::visit([](const auto& column) { return bytes_of(column); }, attribute.column);
  for (const auto& [radius, links] : within_)
    bytes += sizeof(uint32_t) * (links.begin.size() + links.to.size());
  return bytes;
}

namespace {

/// A cell's attributes, for the evaluation of masks.
struct CellAttributes : paint::Attributes {
  const Simulation* simulation;
  uint32_t cell;

  CellAttributes(const Simulation& s, uint32_t i) : simulation(&s), cell(i) {}
  std::optional<Vec3d> read(std::string_view name) const override {
    if (const Attribute* known = simulation->attributes().find(name))
      return std::visit([this](const auto& column) { return Vec3d(column.now[cell]); },
                        known->column);
    // Attributes that do not exist are 0.
    const bool is_transparent = simulation->states()[cell] == CellState::transparent;
    return Vec3d(name == kTransparent && is_transparent ? 1 : 0);
  }
};

}  // namespace

double Simulation::evaluate(const paint::Mask& mask, uint32_t cell) const {
  const CellAttributes attributes(*this, cell);
  const uint32_t object = network_->object[cell];
  const field::SampledGrid* solid = object < solids_.size() ? solids_[object].get() : nullptr;
  paint::EvalPoint point{Vec3d(network_->position[cell]), Vec3d(network_->normal[cell]), solid};
  point.attributes = &attributes;
  return (*mask)(point);
}

std::vector<uint8_t> Simulation::chosen(const Stage& stage) const {
  std::vector<uint8_t> where(network_->size());
  parallel_for(
      where.size(),
      [&](size_t i) {
        RandomStream random(stage.draws.at(position_key(network_->position[i])));
        where[i] = random.uniform() < evaluate(stage.mask, static_cast<uint32_t>(i));
      },
      1024);
  return where;
}

void Simulation::run(const std::vector<Stage>& stages, int steps, Progress& progress,
                     const std::function<void()>& after) {
  for (const Stage& stage : stages)
    if (!stage.where.empty() && stage.where.size() != network_->size())
      throw Error(ErrorCode::bad_input,
                  fmt::format("the mask of stage '{}' does not match these cells", stage.name));
  std::map<const Stage*, std::vector<uint8_t>> fixed;  // Where masks do not change.
  progress.begin(fmt::format("rewriting cells, {} steps", std::max(0, steps)),
                 static_cast<uint64_t>(std::max(0, steps)));
  for (int done = 0; done < steps; ++done) {
    progress.check();
    for (const Stage& stage : stages) {
      const int since = step_ - stage.begin;
      if (since < 0 || (stage.steps >= 0 && since >= stage.steps)) continue;
      const std::vector<uint8_t>* where = stage.where.empty() ? nullptr : &stage.where;
      if (stage.mask) {
        std::vector<uint8_t>& now = fixed[&stage];
        if (now.empty() || !stage.mask->uses().empty()) now = chosen(stage);
        where = &now;
      }
      Pass pass(*this, key_.at(stage.name), since, where);
      stage.rule->step(pass);
    }
    ++step_;
    if (after) after();
    progress.advance();
  }
  progress.end();
}

}  // namespace vug::cells
