// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/cells/build.h>
#include <vug/cells/frames.h>
#include <vug/cells/link.h>
#include <vug/cells/scatter_cells.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::cells {
namespace {

/// Peak memory of scattering, sorting and linking per cell.
constexpr double kBytes = 360;

void require_fit(const Surface& surface, const BuildOptions& options) {
  if (!(options.spacing > 0) || !std::isfinite(options.spacing))
    throw Error(ErrorCode::bad_input, "the spacing of cells must be above 0");
  if (options.spacing > surface.least_size())
    throw Error(ErrorCode::bad_input,
                fmt::format("cells {:.4g} m apart are larger than the object, which is {:.4g} m",
                            options.spacing, surface.least_size()),
                {}, "use a smaller spacing");
  require_feasible(estimate(surface, options.grid, options.spacing), options);
}

}  // namespace

double estimate(double area, const Grid& grid, double spacing) {
  double each = 1;
  if (!grid.motif.empty())
    each = std::fabs(grid.across.x * grid.along.y - grid.across.y * grid.along.x) /
           static_cast<double>(grid.motif.size());
  return area / (each * spacing * spacing);
}

void require_feasible(double cells, const BuildOptions& options) {
  const std::string what = fmt::format("{:.3g} cells", cells);
  if (!(cells * options.grid.full < 4e9))
    throw Error(ErrorCode::too_large, what + " are more than can be indexed", {},
                "use a larger spacing");
  require_memory(cells * kBytes, options.memory > 0 ? options.memory : available_memory(), what,
                 "use a larger spacing");
}

BuildResult build(const Surface& surface, const BuildOptions& options, Progress& progress) {
  require_fit(surface, options);
  const double reach = options.grid.reach * options.spacing;
  BuildResult out;
  std::vector<SurfacePoint> places =
      scatter_cells(surface, options.grid, options.spacing, options.key.at("cells"), progress);
  RelaxOptions relaxation;
  relaxation.force = options.force;
  relaxation.steps = options.relax.value_or(options.grid.relax);
  if (relaxation.steps > 0)
    out.relaxation = relax(places, surface, options.spacing, reach, relaxation, progress);
  out.network = link(places, surface, options.spacing, reach, options.grid.full, progress);
  run_stage(progress, "orienting cells", [&] { orient(out.network); });
  return out;
}

}  // namespace vug::cells
