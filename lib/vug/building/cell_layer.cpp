// SPDX-License-Identifier: Apache-2.0
#include <vug/building/cell_context.h>
#include <vug/building/cell_layer.h>
#include <vug/building/cell_points.h>
#include <vug/building/cells_checkpoint.h>
#include <vug/cells/inherit.h>

#include <fmt/format.h>

#include <map>

namespace vug::building {
namespace {

cells::BuildOptions build_options(const shot::CellsPlan& plan, uint64_t memory) {
  cells::BuildOptions options;
  options.grid = plan.grid ? *plan.grid : make_product(cells::grids(), "random");
  options.spacing = plan.spacing;
  options.key = plan.key;
  options.relax = plan.relax;
  options.force = plan.harmonise;
  options.memory = memory;
  return options;
}

/// Errors about unsuitable meshes, such as partly inverted ones, are located at the cells' name.
cells::Surface surface_of(const std::vector<mesh::MeshPtr>& meshes, const shot::CellsPlan& plan) {
  try {
    return cells::Surface(meshes);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw error.at(plan.where);
  }
}

cells::BuildResult network(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                           uint64_t memory, Progress& progress) {
  std::vector<mesh::MeshPtr> meshes;
  std::vector<uint32_t> numbers;  // indices of the non-empty meshes
  for (uint32_t i = 0; i < supports.size(); ++i)
    if (!supports[i].mesh->triangles.empty())
      meshes.push_back(supports[i].mesh), numbers.push_back(i);
  if (meshes.empty()) return {};
  progress.begin("surface of the cells");
  const cells::Surface surface = surface_of(meshes, plan);
  try {
    cells::BuildResult built = cells::build(surface, build_options(plan, memory), progress);
    for (uint32_t& object : built.network.object) object = numbers[object];
    return built;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
    throw error.at(plan.spacing_where);
  }
}

std::vector<cells::Stage> stages(const shot::CellsPlan& plan) {
  std::vector<cells::Stage> all;
  std::map<std::string, int> used;
  for (const shot::CellStagePtr& stage : plan.run) {
    // Repeated rules need different random numbers.
    const int before = used[stage->name]++;
    cells::Stage each{stage->rule, stage->name, stage->begin, stage->span(), {}};
    if (before > 0) each.name += fmt::format(" {}", before + 1);
    each.mask = stage->where;
    each.draws = plan.key.at("where").at(each.name);
    all.push_back(std::move(each));
  }
  return all;
}

CellLayer new_cell_layer(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                         uint64_t memory, Progress& progress, const CellLayer* before) {
  cells::BuildResult built = network(plan, supports, memory, progress);
  const auto cells = std::make_shared<const cells::Network>(std::move(built.network));
  CellLayer layer{cells::Simulation(cells, plan.key.at("run")), std::move(built.relaxation)};
  layer.simulation.set_step(plan.first_step);
  if (before && cells->size() > 0)
    cells::inherit_attributes(before->simulation, layer.simulation, progress);
  return layer;
}

void restore_points(const volume::Grid& points, const shot::CellsPlan& plan,
                    cells::Simulation& cells) {
  try {
    restore_cells(points, cells);
  } catch (const Error& error) {
    throw Error(error.code(),
                fmt::format("cannot continue from '{}': {}", plan.from.string(), error.what()),
                error.where(), error.hint());
  }
}

/// Adds the data on the supporting meshes that masks and rules query.
void add_context(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                 cells::Simulation& cells, Progress& progress) {
  std::vector<mesh::MeshPtr> meshes;
  std::vector<std::shared_ptr<const field::SampledGrid>> solids;
  for (const CellSupport& support : supports)
    meshes.push_back(support.mesh), solids.push_back(support.solid);
  cells.set_solids(std::move(solids));
  if (!plan.context_attributes.empty()) progress.begin("surroundings of the cells");
  for (const std::string& name : plan.context_attributes)
    if (!cells.attributes().find(name))
      cells.attributes().column<float>(name).now =
          cell_context(cells.network(), name, meshes, progress);
}

}  // namespace

CellLayer make_cell_layer(const shot::CellsPlan& plan, const std::vector<CellSupport>& supports,
                          uint64_t memory, Progress& progress, const CellRunOptions& how) {
  const std::optional<volume::Grid> before = how.from ? std::nullopt : initial_points(plan);
  CellLayer layer =
      how.from ? *how.from : new_cell_layer(plan, supports, memory, progress, how.before.get());
  if (layer.network().size() == 0) return layer;
  try {
    if (before) restore_points(*before, plan, layer.simulation);
    if (how.checkpoint) how.checkpoint->restore(plan, layer);
    if (layer.simulation.step() > plan.length() && !how.from)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the points are already at step {}, but the run ends at step {}",
                              layer.simulation.step(), plan.length()),
                  {}, "increase 'steps' or remove 'from'");
    add_context(plan, supports, layer.simulation, progress);
    const auto after = [&] { how.checkpoint->after_step(plan, layer); };
    layer.simulation.run(stages(plan), plan.length() - layer.simulation.step(), progress,
                         how.checkpoint ? std::function<void()>(after) : nullptr);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::cancelled && how.checkpoint)
      throw how.checkpoint->save_cancelled(plan, layer, error);
    if (error.code() != ErrorCode::bad_input) throw;
    throw error.at(plan.where);
  }
  if (how.checkpoint) how.checkpoint->finish(plan, layer);
  return layer;
}

void require_cell_memory(const shot::CellsPlan& plan, double area, uint64_t memory) {
  const cells::BuildOptions options = build_options(plan, memory);
  try {
    cells::require_feasible(cells::estimate(area, options.grid, options.spacing), options);
  } catch (const Error& error) {
    throw error.at(plan.spacing_where);
  }
}

bool cells_fit(const shot::CellsPlan& plan, double area, uint64_t memory) {
  try {
    require_cell_memory(plan, area, memory);
    return true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
    return false;
  }
}

}  // namespace vug::building
