// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/building/rock_weights.h>
#include <vug/cells/to_points.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/cells_files.h>
#include <vug/delivery/export_set.h>
#include <vug/delivery/export_volume.h>
#include <vug/delivery/point_file.h>
#include <vug/delivery/write_products.h>
#include <vug/exchange/channels.h>
#include <vug/exchange/flat_mesh.h>
#include <vug/exchange/levels.h>
#include <vug/shot/queries.h>
#include <vug/volume/converted.h>
#include <vug/volume/io.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::delivery {
namespace {

exchange::Space space_of(const ExportOptions& options) {
  exchange::Space space = options.program->space;
  if (options.up) space.up = *options.up;
  if (options.metres_per_unit) space.metres_per_unit = *options.metres_per_unit;
  return space;
}

/// Paths of the files.
class FileNames {
 public:
  FileNames(const shot::Shot& shot, std::filesystem::path folder, const ExportOptions& options)
      : shot_(shot), folder_(std::move(folder)), options_(options) {}

  std::filesystem::path scene(const std::string& format, int level = 0) const {
    const std::string end = level > 0 ? fmt::format("_lod{}", level) : "";
    return folder_ / fmt::format("{}{}.{}", shot_.name, end, format);
  }
  std::filesystem::path volume(const shot::VolumePlan& plan) const {
    return folder_ / fmt::format("{}_{}.vdb", shot_.name, plan.name);
  }
  std::filesystem::path medium(const shot::MediumPlan& plan) const {
    return folder_ / fmt::format("{}_{}_medium.vdb", shot_.name, plan.name);
  }
  std::filesystem::path points(const shot::CellsPlan& plan) const {
    const std::string& format = options_.program->points_format;
    return folder_ /
           fmt::format("{}_{}_points.{}", shot_.name, plan.name, format.empty() ? "vdb" : format);
  }
  std::filesystem::path grids(const shot::CellsPlan& plan) const {
    return folder_ / fmt::format("{}_{}_grids.vdb", shot_.name, plan.name);
  }

 private:
  const shot::Shot& shot_;
  std::filesystem::path folder_;
  const ExportOptions& options_;
};

/// The number of available levels of detail, which may be fewer than requested.
int levels_of(const exchange::Assembly& assembly) {
  size_t most = 0;
  for (const exchange::Prototype& part : assembly.prototypes)
    most = std::max(most, part.coarser.size());
  return static_cast<int>(most);
}

class Exporter {
 public:
  Exporter(building::Builder& builder, const std::filesystem::path& folder,
           const ExportOptions& options)
      : builder_(builder),
        options_(options),
        names_(builder.shot(), folder, options),
        space_(space_of(options)),
        to_space_(exchange::space_transform({}, space_)) {
    vdb_ = write_options(builder.shot());
    vdb_.metadata["vug:frame"] = builder.shot().frame;
    vdb_.metadata["vug:upAxis"] = exchange::to_string(space_.up);
    vdb_.metadata["vug:metersPerUnit"] = space_.metres_per_unit;
  }

  /// Builds the assembly and writes the files of its volumes and cells.
  exchange::Assembly assemble() {
    AssemblyResult made = build_assembly(builder_);
    exchange::add_levels(made.assembly, options_.levels, builder_.progress());
    report_levels(made.assembly, levels_of(made.assembly));
    const shot::Shot& shot = builder_.shot();
    for (const shot::VolumePtr& plan : shot.volumes)
      made.assembly.volumes.push_back(write(export_volume(builder_, plan), names_.volume(*plan)));
    for (const shot::MediumPlan& plan : shot.media)
      if (has_own_grids(plan))
        made.assembly.volumes.push_back(write(export_medium(plan), names_.medium(plan)));
      else if (!plan.medium->has_grids())
        made.unsupported.push_back(
            fmt::format("the haze '{}', which fills all space and has no grid", plan.name));
    for (const shot::CellsPtr& plan : shot::declared_cells(shot)) write(plan);
    out_.unsupported = std::move(made.unsupported);
    return std::move(made.assembly);
  }

  /// Writes the files of the assembly with its variants.
  ExportResult write_scene(const exchange::Assembly& assembly,
                           std::vector<exchange::AssemblyVariant> variants) {
    variants_ = std::move(variants);
    const int levels = levels_of(assembly);
    for (const std::string& name : options_.program->formats) {
      const exchange::Format& format = exchange::format(name);
      const std::filesystem::path whole = names_.scene(name);
      add_report(write(format, assembly, whole), whole);
      // Coarser files differ only in their meshes; all messages have been reported already.
      for (int level = 1; level <= levels && !format.levels; ++level)
        write(format, exchange::at_level(assembly, level), names_.scene(name, level), whole);
    }
    return std::move(out_);
  }

  /// Adds the files and the messages of another variant.
  void add_result(const std::string& variant, const Exporter& other) {
    out_.files.insert(out_.files.end(), other.out_.files.begin(), other.out_.files.end());
    for (const std::string& what : other.out_.unsupported)
      if (std::find(out_.unsupported.begin(), out_.unsupported.end(), what) ==
          out_.unsupported.end())
        out_.unsupported.push_back(fmt::format("{} (variant {})", what, variant));
    for (const std::string& what : other.out_.levels)
      out_.levels.push_back(fmt::format("{} (variant {})", what, variant));
  }

 private:
  /// `pictures_of`: the file next to which environment maps have already been written; empty: this
  /// one.
  exchange::WriteReport write(const exchange::Format& format, const exchange::Assembly& assembly,
                              const std::filesystem::path& file,
                              const std::filesystem::path& pictures_of = {}) {
    exchange::FormatOptions options = options_.program->options;
    options.pictures_of = pictures_of;
    options.variants = variants_;
    exchange::WriteReport more =
        exchange::write(format, assembly, space_, file, options, builder_.progress());
    out_.files.insert(out_.files.end(), more.files.begin(), more.files.end());
    return more;
  }
  void add_report(const exchange::WriteReport& written, const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    for (const std::string& what : written.unsupported)
      out_.unsupported.push_back(fmt::format("{} ({})", what, name));
    for (const std::string& what : written.notes)
      out_.notes.push_back(fmt::format("{} ({})", what, name));
  }
  void report_levels(const exchange::Assembly& assembly, int levels) {
    for (const exchange::Prototype& part : assembly.prototypes)
      for (size_t i = 0; i < part.coarser.size(); ++i)
        out_.levels.push_back(
            fmt::format("level {} of '{}': {} of {} triangles, {} off", i + 1, part.name,
                        part.coarser[i].mesh->triangles.size(), part.mesh->triangles.size(),
                        quantity_text(part.coarser[i].distance, Dimension::length)));
    if (levels == 0 && options_.levels > 0)
      out_.levels.push_back("no level of detail: the meshes cannot be decimated further");
    else if (levels < options_.levels)
      out_.levels.push_back(
          fmt::format("level {} is the last: no mesh can be decimated further", levels));
  }
  exchange::Volume write(const ExportVolume& volume, const std::filesystem::path& file) {
    write(file, volume.grids);
    exchange::Volume out{volume.name, file.filename().string(), {}, {}, volume.medium};
    for (const volume::Grid& grid : volume.grids) {
      out.grids.push_back({grid.name(), volume::to_string(grid.grid_class()),
                           exchange::is_color(grid.name()), grid.value_type() == "int32"});
      out.bounds.extendBy(grid.statistics().bounds);
    }
    return out;
  }
  void write(const shot::CellsPtr& plan) {
    const building::CellLayerPtr layer = builder_.cell_layer(plan);
    if (plan->writes("grids")) write(names_.grids(*plan), cell_grids(builder_, plan));
    if (!plan->writes("points")) return;
    constexpr double kBytes = 150;  // see write_products
    require_memory(kBytes * static_cast<double>(layer->network().size()), builder_.memory_budget(),
                   fmt::format("the points of '{}'", plan->name), "exclude points from its files");
    volume::Points points = cells::to_points(layer->simulation);
    building::add_rock_weights(points, *plan, layer->network());
    move(points);
    const std::filesystem::path file = names_.points(*plan);
    if (!options_.program->points_format.empty()) {
      write_points(points, file, exchange::comments_of(provenance_of(builder_.shot()), space_));
    } else {
      if (plan->half)
        for (volume::PointAttribute& each : points.attributes) each.half = true;
      const double voxel = cells::voxel_of_points(layer->network()) * to_space_.max_stretch();
      volume::write(file, {volume::point_grid(points, voxel).named(plan->name)}, vdb_);
    }
    out_.files.push_back(file);
  }
  /// Transforms positions, vectors and point sizes into the program's space.
  void move(volume::Points& points) const {
    if (space_ == exchange::Space()) return;
    const double scale = to_space_.max_stretch();
    for (Vec3f& p : points.position) p = Vec3f(to_space_.point(Vec3d(p)));
    for (volume::PointAttribute& each : points.attributes) {
      if (auto* vectors = std::get_if<std::vector<Vec3f>>(&each.values);
          vectors && !exchange::is_color(each.name))
        for (Vec3f& v : *vectors) v = Vec3f(to_space_.vector(Vec3d(v)) / scale);
      if (auto* sizes = std::get_if<std::vector<float>>(&each.values);
          sizes && each.name == "pscale")
        for (float& size : *sizes) size *= static_cast<float>(scale);
    }
  }
  void write(const std::filesystem::path& file, const std::vector<volume::Grid>& grids) {
    std::vector<volume::Grid> there;
    for (const volume::Grid& grid : grids)
      there.push_back(space_ == exchange::Space() ? grid : volume::converted(grid, to_space_));
    volume::write(file, there, vdb_);
    out_.files.push_back(file);
  }

  building::Builder& builder_;
  const ExportOptions& options_;
  FileNames names_;
  exchange::Space space_;
  Transform to_space_;
  volume::WriteOptions vdb_;
  std::vector<exchange::AssemblyVariant> variants_;
  ExportResult out_;
};

}  // namespace

bool has_variants(const exchange::Program& program) {
  return std::all_of(program.formats.begin(), program.formats.end(),
                     [](const std::string& name) { return exchange::format(name).variants; });
}

std::vector<std::filesystem::path> export_paths(const shot::Shot& shot,
                                                const std::filesystem::path& folder,
                                                const ExportOptions& options) {
  const FileNames names(shot, folder, options);
  std::vector<std::filesystem::path> paths;
  for (const shot::VolumePtr& plan : shot.volumes) paths.push_back(names.volume(*plan));
  for (const shot::MediumPlan& plan : shot.media)
    if (has_own_grids(plan)) paths.push_back(names.medium(plan));
  for (const shot::CellsPtr& plan : shot::declared_cells(shot)) {
    if (plan->writes("grids")) paths.push_back(names.grids(*plan));
    if (plan->writes("points")) paths.push_back(names.points(*plan));
  }
  for (const ExportVariant& each : options.variants) {
    ExportOptions alone = options;
    alone.variants.clear();
    for (auto& path : export_paths(each.builder->shot(), folder, alone))
      paths.push_back(std::move(path));
  }
  for (const std::string& format : options.program->formats) {
    paths.push_back(names.scene(format));
    for (int level = 1; level <= options.levels && !exchange::format(format).levels; ++level)
      paths.push_back(names.scene(format, level));
  }
  return paths;
}

ExportResult export_set(building::Builder& builder, const std::filesystem::path& folder,
                        const ExportOptions& options) {
  for (const auto& path : export_paths(builder.shot(), folder, options)) require_writable(path);
  Exporter exporter(builder, folder, options);
  const exchange::Assembly assembly = exporter.assemble();
  std::vector<exchange::AssemblyVariant> variants;
  for (const ExportVariant& each : options.variants) {
    Exporter other(*each.builder, folder, options);
    auto version = std::make_shared<exchange::Assembly>(other.assemble());
    version->name = assembly.name;
    exporter.add_result(each.name, other);
    variants.push_back({each.name, std::move(version)});
  }
  return exporter.write_scene(assembly, std::move(variants));
}

}  // namespace vug::delivery
