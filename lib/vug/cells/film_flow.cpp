// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/cells/film_flow.h>
#include <vug/cells/outlets.h>
#include <vug/cells/simulation.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

/// The least sine of a slope for the thickness of films, so that level ground has a finite film.
constexpr double kLeastSteepness = 0.01;

std::vector<Vec3f> surface_positions(const Pass& pass) {
  const Network& n = pass.network();
  const AttributeReader<Vec3f> position = pass.positions();
  const OptionalReader height = pass.reads_optional("height", 0);
  std::vector<Vec3f> out(n.size());
  parallel_for(
      n.size(),
      [&](size_t i) {
        const auto cell = static_cast<uint32_t>(i);
        out[i] = position[cell] + n.normal[i] * height[cell];
      },
      kCellGrain);
  return out;
}

std::vector<uint8_t> outlets_of(Pass& pass) {
  const AttributeReader<CellState> states = pass.states();
  if (!pass.has("outlet")) {
    const std::vector<uint8_t> found = find_outlets(pass.network(), states.now);
    const auto outlet = pass.writes<float>("outlet");
    pass.run_everywhere([&](const auto&, uint32_t i) { outlet.set(i, found[i]); });
  }
  const auto outlet = pass.reads<float>("outlet");
  std::vector<uint8_t> out(pass.network().size());
  for (uint32_t i = 0; i < out.size(); ++i)
    out[i] = outlet[i] > 0 || states[i] != CellState::active;
  return out;
}

std::vector<Load> entering_loads(const Pass& pass, const FilmParams& params, double calcium) {
  constexpr double kDay = 86400;  // Seconds.
  const OptionalReader source = pass.reads_optional("source", 1),
                       condenses = pass.reads_optional("condensation", 1);
  const Network& n = pass.network();
  std::vector<Load> out(n.size());
  parallel_for(
      out.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        const double area = static_cast<double>(n.area[i]) / kDay;
        const double seeps = area * params.rate * std::max(0.0, static_cast<double>(source[i]));
        const double dew =
            area * params.condensation * std::max(0.0, static_cast<double>(condenses[i]));
        out[i] = {seeps + dew, calcium * seeps};
      },
      kCellGrain);
  return out;
}

}  // namespace

FilmFlow::FilmFlow(Pass& pass, const FilmParams& params, double calcium)
    : network_(&pass.network()),
      viscosity_(kinematic_viscosity(params.temperature)),
      outlet_(outlets_of(pass)),
      drainage_(pass.network().links, surface_positions(pass), outlet_,
                {params.gather, params.head}),
      sources_(entering_loads(pass, params, calcium)) {
  if (!drainage_.reaches_outlets() && !pass.is_trial())
    throw Error(ErrorCode::bad_input, "water cannot leave: the attribute 'outlet' is 0 in a piece",
                {}, "set 'outlet' to 1 somewhere in each piece, or let 'film' find outlets");
  set_speeds();
  const auto is_wet = [](const Load& load) { return load.water > 0; };
  if (!pass.is_trial() && std::none_of(sources_.begin(), sources_.end(), is_wet))
    throw Error(ErrorCode::bad_input, "no water enters: the attribute 'source' is 0 in all cells",
                {}, "set 'source' above 0 somewhere, for instance with set or sprinkle");
}

void FilmFlow::set_speeds() {
  width_.resize(network_->size());
  speed_.resize(network_->size());
  parallel_for(
      width_.size(),
      [&](size_t at) {
        const auto i = static_cast<uint32_t>(at);
        width_[i] = std::sqrt(network_->area[i]);
        // The cube of the speed of a discharge of 1.
        const double width = static_cast<double>(width_[i]);
        speed_[i] = static_cast<float>(kGravity * steepness(i) / (3 * viscosity_ * width * width));
      },
      kCellGrain);
}

double FilmFlow::steepness(uint32_t cell) const {
  return std::max(kLeastSteepness, static_cast<double>(drainage_.steepness(cell)));
}

double FilmFlow::thickness(uint32_t cell, double discharge) const {
  return film_thickness(discharge / width(cell), steepness(cell), viscosity_);
}

void write_film(Pass& pass, const FilmFlow& flow, const std::vector<Load>& load) {
  const auto discharge = pass.writes<float>("discharge"), film = pass.writes<float>("film"),
             pool = pass.writes<float>("pool");
  pass.run_everywhere([&](const auto&, uint32_t i) {
    const double water = load[i].water;
    const float depth = water > 0 ? flow.drainage().depth(i) : 0;
    discharge.set(i, static_cast<float>(water));
    pool.set(i, depth);
    film.set(i, std::max(depth, static_cast<float>(flow.thickness(i, water))));
  });
}

}  // namespace vug::cells
