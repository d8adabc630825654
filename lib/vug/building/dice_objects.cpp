// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/building/dice_objects.h>
#include <vug/building/memory_estimate.h>
#include <vug/field/deferred.h>
#include <vug/meshing/dice.h>
#include <vug/metrics/surface.h>
#include <vug/render/render.h>
#include <vug/shot/queries.h>
#include <vug/volume/voxelize.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

/// Share of the new vertices that may fail to follow the detail without a warning.
constexpr double kUnfollowed = 0.01;

/// The dicing of one object.
struct DicingJob {
  const shot::ObjectPlan* plan = nullptr;
  render::Object* object = nullptr;
  field::Field field;
  std::vector<render::CameraPtr> cameras;
  render::PictureSize picture;
  double triangles = 0;  ///< Estimated.
};

/// The eyes of a stereo camera; else the camera itself.
std::vector<render::CameraPtr> eyes_of(const render::CameraPtr& camera) {
  const render::CameraPtr left = camera->stereo_view(-1), right = camera->stereo_view(1);
  if (!left || !right) return {camera};
  return {left, right};
}

/// The field onto which an object's vertices move, with the faces of the volume's region.
field::Field detail_field(Builder& builder, const shot::ObjectPlan& plan) {
  const shot::VolumePtr& volume = plan.mesh->volume;
  const field::Field own = plan.detail->field ? *plan.detail->field : volume->field;
  field::compute_deferred(own, builder.progress(), builder.memory_budget());
  if (!volume || volume->source_mesh) return own;
  return volume::field_in_region(own, voxelize_options(*volume, builder.memory_budget()));
}

/// The mean edge of a mesh of regular triangles with the same area.
double mean_edge(const mesh::Mesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const double area = metrics::area(mesh) / static_cast<double>(mesh.triangles.size());
  return std::sqrt(area * 4 / std::sqrt(3.0));
}

/// `coarser`: factor on the edge lengths of the plan.
meshing::DiceOptions dice_options(const DicingJob& job, double coarser = 1) {
  const shot::Dicing& detail = *job.plan->detail;
  meshing::DiceOptions options;
  options.levels = detail.levels;
  const shot::VolumePtr& volume = job.plan->mesh->volume;
  options.reach = volume ? volume->voxel : mean_edge(*job.object->mesh);
  const double least = detail.least;
  if (detail.edge) {
    options.edge_length = [longest = std::max(*detail.edge * coarser, least)](const Vec3d&) {
      return longest;
    };
    return options;
  }
  const double pixels = detail.pixels * coarser;
  options.edge_length = [size = render::PixelSize(job.cameras, job.picture, detail.off_screen),
                         pixels,
                         least](const Vec3d& p) { return std::max(pixels * size.at(p), least); };
  return options;
}

/// Bytes of a diced mesh per triangle, with half as many vertices, and in the renderer.
double triangle_bytes(const mesh::Mesh& mesh) {
  double vertex = 2 * sizeof(Vec3f);
  for (const mesh::Attribute& each : mesh.attributes) vertex += 4.0 * each.arity;  // floats
  return sizeof(mesh::Triangle) + 0.5 * vertex + render::kTriangleBytes;
}

double bytes_of(const std::vector<DicingJob>& jobs) {
  double bytes = 0;
  for (const DicingJob& job : jobs) bytes += job.triangles * triangle_bytes(*job.object->mesh);
  return bytes;
}

void estimate(std::vector<DicingJob>& jobs, double coarser) {
  for (DicingJob& job : jobs)
    job.triangles =
        meshing::estimate_diced_triangles(*job.object->mesh, job.field, dice_options(job, coarser));
}

/// The rate at which the first object would fit if all rates were multiplied by the same factor.
std::string fitting_rate(std::vector<DicingJob> jobs, uint64_t budget) {
  for (const double coarser : {1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 16.0, 32.0}) {
    estimate(jobs, coarser);
    if (bytes_of(jobs) > static_cast<double>(budget)) continue;
    const shot::Dicing& detail = *jobs[0].plan->detail;
    return detail.edge
               ? fmt::format("it fits with: detail dice(edge: {:.3g}mm)",
                             *detail.edge * coarser * 1000)
               : fmt::format("it fits with: detail dice(pixels: {:.3g})", detail.pixels * coarser);
  }
  return "remove 'detail' of some objects";
}

void require_detail_memory(const Builder& builder, std::vector<DicingJob>& jobs) {
  run_stage(builder.progress(), "estimating the detail", [&] { estimate(jobs, 1); });
  const double bytes = bytes_of(jobs);
  const uint64_t budget = builder.memory_budget();
  if (bytes <= static_cast<double>(budget)) return;
  double triangles = 0;
  for (const DicingJob& job : jobs) triangles += job.triangles;
  try {
    require_memory(bytes, budget,
                   fmt::format("detail of {:.3g} million triangles", triangles / 1e6),
                   fitting_rate(jobs, budget));
  } catch (const Error& error) {
    throw error.at(jobs[0].plan->where);
  }
}

void dice_object(Builder& builder, const DicingJob& job) {
  const Progress::Product product(builder.progress(), job.plan->name);
  const double bytes = job.triangles * triangle_bytes(*job.object->mesh);
  builder.progress().begin(fmt::format("dicing into {:.2f} million triangles, {}",
                                       job.triangles / 1e6, bytes_text(bytes)));
  meshing::DiceResult diced =
      meshing::dice(*job.object->mesh, job.field, dice_options(job), builder.progress());
  builder.progress().end();
  const auto added = static_cast<double>(diced.report.added_vertices);
  const auto unfollowed = static_cast<double>(diced.report.unfollowed);
  if (unfollowed > kUnfollowed * added && unfollowed > 1)
    builder.warn(job.plan->where,
                 fmt::format("{:.3g} % of the vertices of '{}' could not follow its detail and "
                             "stayed in the middle of their edge",
                             100 * unfollowed / std::max(added, unfollowed), job.plan->name),
                 "the field has no surface near the mesh there: use smaller voxels");
  job.object->mesh = std::make_shared<const mesh::Mesh>(std::move(diced.mesh));
}

void warn_about_instances(const Builder& builder, const shot::Shot& part) {
  for (const shot::ObjectPlan& object : part.objects)
    for (const shot::PointInstancer& place : part.instancers)
      for (const shot::Model& model : place.of)
        if (object.detail && !model.mesh && !model.scene && model.name == object.name)
          builder.warn(place.where,
                       fmt::format("'{}' places '{}' without its detail", place.name, object.name),
                       "only objects that are not placed are diced");
}

}  // namespace

void dice_objects(Builder& builder, const shot::Shot& part, const DicingView& view,
                  std::vector<render::Object>& objects) {
  const std::vector<shot::ObjectPlan> shown = shot::shown_objects(part);
  std::vector<DicingJob> jobs;
  for (size_t i = 0; i < shown.size(); ++i) {
    const shot::ObjectPlan& plan = shown[i];
    if (!plan.detail || builder.shot().draft) continue;
    const bool fixed = plan.detail->edge.has_value();
    if (!fixed && view.cameras.empty()) continue;
    DicingJob job{&plan, &objects.at(i), detail_field(builder, plan), {}, view.picture};
    for (const render::CameraPtr& camera : view.cameras)
      if (!plan.detail->camera)
        for (const render::CameraPtr& eye : eyes_of(camera)) job.cameras.push_back(eye);
    if (plan.detail->camera) job.cameras = eyes_of(plan.detail->camera);
    jobs.push_back(std::move(job));
  }
  warn_about_instances(builder, part);
  if (jobs.empty()) return;
  require_detail_memory(builder, jobs);
  for (const DicingJob& job : jobs) dice_object(builder, job);
}

}  // namespace vug::building
