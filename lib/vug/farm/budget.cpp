// SPDX-License-Identifier: Apache-2.0
#include <vug/farm/budget.h>

#include <algorithm>
#include <functional>
#include <queue>

namespace vug::farm {
namespace {

// Of a .vdb file with Blosc compression; 4.1 were measured for karst/maze at 10 cm.
constexpr double kBytesPerVoxel = 4.25;
// Of a .ply file: half a vertex (position, normal), and three indices.
constexpr double kBytesPerTriangle = 24;
// Of an .exr file with the usual AOVs; 27 to 41 were measured for the karst scenes.
constexpr double kBytesPerPixel = 35;
constexpr double kHour = 3600, kGigabyte = 1e9;

/// Seconds until the last task ends on `machines` machines, each of which starts the next task
/// whose needs are met when it is free. `duration` maps a task to seconds.
double makespan(const Job& job, int machines, const std::function<double(const Task&)>& duration) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free;
  for (int i = 0; i < machines; ++i) free.push(0);
  std::vector<double> ends;
  for (const Task& task : job.tasks) {
    double start = free.top();
    free.pop();
    for (const size_t need : task.needs) start = std::max(start, ends[need]);
    ends.push_back(start + duration(task));
    free.push(ends.back());
  }
  return ends.empty() ? 0 : *std::max_element(ends.begin(), ends.end());
}

Place with_money(Place place, double core_hour, double files) {
  place.money = place.core_hours * core_hour + files;
  return place;
}

}  // namespace

Budget budget(const JobOptions& job, bool frames_share_products, const BudgetOptions& options) {
  const Job plan = plan_job(job);
  const PictureCost& cost = job.cost;
  Budget out;
  out.pictures = plan.pictures.size();
  out.tasks = plan.tasks.size();
  const auto pictures = static_cast<double>(out.pictures);
  const double products = frames_share_products ? 1 : pictures;
  out.grid_bytes = kBytesPerVoxel * cost.voxels * products;
  out.mesh_bytes = kBytesPerTriangle * cost.triangles * products;
  out.picture_bytes = kBytesPerPixel * cost.samples / job.spp * pictures;
  out.task_bytes = cost.bytes;

  const double stored = (out.grid_bytes + out.mesh_bytes + out.picture_bytes) / kGigabyte;
  const double files = stored * options.months * options.prices.gigabyte_month +
                       out.picture_bytes / kGigabyte * options.prices.gigabyte_out;
  const double alone =
      (products * cost.build_seconds + pictures * (cost.learn_seconds + cost.render_seconds)) /
      kHour;
  out.places.push_back(with_money({"one machine", 1, alone, alone * options.cores, 0},
                                  options.prices.core_hour, files));

  const auto add = [&](const char* name, double core_hour,
                       const std::function<double(const Task&)>& duration) {
    double seconds = 0;
    for (const Task& task : plan.tasks) seconds += duration(task);
    out.places.push_back(
        with_money({name, options.machines, makespan(plan, options.machines, duration) / kHour,
                    seconds * options.cores / kHour, 0},
                   core_hour, files));
  };
  add("farm", options.prices.core_hour, [](const Task& task) { return task.seconds; });
  const SpotNodes& spot = options.spot;
  add("spot nodes", options.prices.spot_core_hour, [&](const Task& task) {
    return task.seconds + spot.start_seconds +
           spot.losses_per_hour / kHour * task.seconds * (spot.start_seconds + cost.build_seconds);
  });
  return out;
}

}  // namespace vug::farm
