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
      states_{std::vector<State>(network_->size(), State::active), {}},
      blocks_(network_->links, states_.now) {}

void Simulation::set_states(std::vector<State> states) {
  if (states.size() != network_->size())
    throw Error(ErrorCode::internal, "there is not one state for each cell");
  // Cells that may have been written a moment ago come to rest.
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
  uint64_t bytes = network_->bytes() + bytes_of(states_) + sizeof(float) * pairs_.size();
  for (const Attribute& attribute : attributes_.all())
    bytes += std::visit([](const auto& column) { return bytes_of(column); }, attribute.column);
  for (const auto& [radius, links] : within_)
    bytes += sizeof(uint32_t) * (links.begin.size() + links.to.size());
  return bytes;
}

void Simulation::run(const std::vector<Stage>& stages, int steps, Progress& progress,
                     const std::function<void()>& after) {
  for (const Stage& stage : stages)
    if (!stage.where.empty() && stage.where.size() != network_->size())
      throw Error(ErrorCode::bad_input,
                  fmt::format("the mask of stage '{}' is not of these cells", stage.name));
  progress.begin(fmt::format("rewriting cells, {} steps", std::max(0, steps)),
                 static_cast<uint64_t>(std::max(0, steps)));
  for (int done = 0; done < steps; ++done) {
    progress.check();
    for (const Stage& stage : stages) {
      const int since = step_ - stage.begin;
      if (since < 0 || (stage.steps >= 0 && since >= stage.steps)) continue;
      Pass pass(*this, key_.at(stage.name), since, stage.where.empty() ? nullptr : &stage.where);
      stage.rule->step(pass);
    }
    ++step_;
    if (after) after();
    progress.advance();
  }
  progress.end();
}

}  // namespace vug::cells
