#include <vug/base/parallel.h>
#include <vug/cells/build.h>
#include <vug/cells/onto_mesh.h>
#include <vug/session/blame.h>
#include <vug/session/wear.h>
#include <vug/volume/samples.h>

#include <fmt/format.h>

#include <map>

namespace vug::session {
namespace {

cells::NetworkPtr network(const mesh::Mesh& mesh, const CellsPlan& plan, uint64_t memory,
                          Progress& progress) {
  cells::BuildOptions options;
  options.grid = plan.grid ? *plan.grid : make_product(cells::grids(), "random");
  options.spacing = plan.spacing;
  options.key = plan.key;
  options.relax = plan.relax;
  options.memory = memory;
  try {
    const cells::Surface surface({std::make_shared<const mesh::Mesh>(mesh)});
    return std::make_shared<const cells::Network>(cells::build(surface, options, progress).network);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input && error.code() != ErrorCode::too_large) throw;
    throw blamed_on(plan.spacing_where, error);
  }
}

/// A cell is rewritten with the chance that the mask gives at its place.
std::vector<uint8_t> chosen(const CellStage& stage, const cells::Network& cells, RandomKey key,
                            const field::SampledGrid& solid) {
  std::vector<uint8_t> where(stage.where ? cells.size() : 0);
  parallel_for(where.size(), [&](size_t i) {
    const paint::Spot spot{Vec3d(cells.position[i]), Vec3d(cells.normal[i]), &solid};
    RandomStream random(key.at(cells::place_of(cells.position[i])));
    where[i] = random.uniform() < (*stage.where)(spot);
  });
  return where;
}

}  // namespace

void wear(mesh::Mesh& mesh, const CellsPlan& plan, const volume::LevelSet& solid, uint64_t memory,
          Progress& progress) {
  if (mesh.triangles.empty()) return;
  const cells::NetworkPtr cells = network(mesh, plan, memory, progress);
  const auto samples = volume::samples(solid);
  std::vector<cells::Stage> stages;
  std::map<std::string, int> used;
  for (const CellStagePtr& stage : plan.run) {
    // Two of one rule choose differently.
    const int before = used[stage->name]++;
    cells::Stage each{stage->rule, stage->name, stage->begin, stage->span(), {}};
    if (before > 0) each.name += fmt::format(" {}", before + 1);
    each.where = chosen(*stage, *cells, plan.key.at("where").at(each.name), *samples);
    stages.push_back(std::move(each));
  }
  cells::Simulation simulation(cells, plan.key.at("run"));
  try {
    simulation.run(stages, plan.length(), progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_input) throw;
    throw blamed_on(plan.where, error);
  }
  cells::onto_mesh(simulation, mesh, progress);
}

}  // namespace vug::session
