// SPDX-License-Identifier: Apache-2.0
// The time and money that the pictures of a shot take on one machine, a farm, and spot nodes.
#pragma once

#include <vug/farm/plan_job.h>

#include <string>
#include <vector>

namespace vug::farm {

/// Prices in any one currency. The defaults are of the order of list prices in US dollars; they
/// differ by provider, region and year.
struct Prices {
  double core_hour = 0.05;        ///< On demand.
  double spot_core_hour = 0.015;  ///< Nodes that the provider may take back.
  double gigabyte_month = 0.023;  ///< Storage.
  double gigabyte_out = 0.09;     ///< Transfer from the provider to the studio.
};

/// How spot nodes are lost.
struct SpotNodes {
  double losses_per_hour = 0.05;  ///< Expected losses of one node per hour.
  double start_seconds = 20;      ///< From the request of a node to the start of its task.
};

struct BudgetOptions {
  int cores = 1;  ///< Cores of each machine.
  int machines = 10;
  double months = 1;  ///< How long the files are stored.
  Prices prices;
  SpotNodes spot;
};

/// The same work at one kind of place.
struct Place {
  std::string name;  ///< "one machine", "farm", "spot nodes".
  int machines = 1;
  double hours = 0;       ///< From the start to the last picture.
  double core_hours = 0;  ///< Paid time of all cores.
  double money = 0;       ///< Core-hours, storage and transfer.
};

struct Budget {
  size_t pictures = 0;
  size_t tasks = 0;          ///< Tasks of the farm.
  double grid_bytes = 0;     ///< Level sets as .vdb files.
  double mesh_bytes = 0;     ///< Meshes as .ply files.
  double picture_bytes = 0;  ///< All pictures.
  double task_bytes = 0;     ///< Peak memory of a task.
  std::vector<Place> places;
};

/// One machine makes the products once if `frames_share_products`, and else for each picture; tasks
/// of a farm make them again, since each machine has its own store. The farm's time follows from
/// starting the tasks of plan_job(job) in their order. A task on a spot node that is lost continues
/// from its checkpoint elsewhere, so that a loss costs a start and the preparation: with the
/// preparation p, the start c and the losses a, a task of t seconds is expected to take
/// t + c + a t (c + p).
Budget budget(const JobOptions& job, bool frames_share_products, const BudgetOptions& options);

}  // namespace vug::farm
