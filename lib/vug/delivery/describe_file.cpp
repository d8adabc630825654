// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/delivery/describe_file.h>
#include <vug/exchange/format.h>
#include <vug/image/deep_info.h>
#include <vug/mesh/format.h>
#include <vug/picture/picture_file.h>
#include <vug/render/film/guiding_file.h>
#include <vug/volume/io.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vug::delivery {
namespace {

using Json = nlohmann::ordered_json;

Json corners(const Box3d& box) {
  if (box.isEmpty()) return nullptr;
  return {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
}

Json metadata(const volume::Metadata& entries) {
  Json out = Json::object();
  for (const auto& [key, value] : entries)
    std::visit([&, name = key](const auto& v) { out[name] = v; }, value);
  return out;
}

Json describe_points(const volume::PointsInfo& points) {
  Json attributes = Json::array(), groups = Json::array();
  for (const auto& each : points.attributes)
    attributes.push_back(fmt::format("{} {} {}", each.name, each.type, each.codec));
  for (const auto& each : points.groups)
    groups.push_back({{"name", each.name}, {"points", each.points}});
  return {{"count", points.count},
          {"bounds", corners(points.bounds)},
          {"attributes", attributes},
          {"groups", groups}};
}

Json describe_vdb(const std::filesystem::path& file) {
  const volume::FileInfo info = volume::info(file);
  Json grids = Json::array();
  for (const volume::GridInfo& grid : info.grids) {
    grids.push_back({{"name", grid.name},
                     {"class", volume::to_string(grid.grid_class)},
                     {"type", grid.value_type},
                     {"half", grid.half},
                     {"voxel_size", {grid.voxel_size.x, grid.voxel_size.y, grid.voxel_size.z}},
                     {"active_voxels", grid.statistics.active_voxels},
                     {"leaves", grid.statistics.leaves},
                     {"memory_bytes", grid.statistics.memory_bytes},
                     {"bounds", corners(grid.statistics.bounds)},
                     {"metadata", metadata(grid.metadata)}});
    if (grid.points) grids.back()["points"] = describe_points(*grid.points);
  }
  return {{"file", file.string()}, {"type", "vdb"},
          {"bytes", info.bytes},   {"version", info.format_version},
          {"id", info.identifier}, {"metadata", metadata(info.metadata)},
          {"grids", grids}};
}

Json describe_picture(const std::filesystem::path& file) {
  const std::optional<image::DeepInfo> deep = image::read_deep_info(file);
  const image::FileInfo info = deep ? deep->file : image::read_info(file);
  if (!deep) image::read(file);  // a truncated file may have a valid header
  Json channels = Json::array();
  for (size_t i = 0; i < info.channels.size(); ++i)
    channels.push_back(fmt::format("{} {}", info.channels[i], info.formats.at(i)));
  Json texts = Json::object();
  for (const auto& [key, text] : info.metadata) texts[key] = text;
  Json out = {{"file", file.string()},
              {"type", deep ? "deep picture" : "picture"},
              {"width", info.width},
              {"height", info.height},
              {"channels", channels}};
  if (deep) out["samples"] = deep->samples;
  out["metadata"] = std::move(texts);
  return out;
}

Json texts_of(const std::vector<std::pair<std::string, std::string>>& texts) {
  Json out = Json::object();
  for (const auto& [name, text] : texts) out[name] = text;
  return out;
}

/// glTF and USD: only the provenance; other programs show the contents.
Json describe_scene(const std::filesystem::path& file) {
  // First, because it reports why a file cannot be read.
  Json metadata = texts_of(exchange::read_metadata(file));
  return {{"file", file.string()},
          {"type", "scene of another program"},
          {"bytes", std::filesystem::file_size(file)},
          {"metadata", std::move(metadata)}};
}

Json describe_mesh(const std::filesystem::path& file) {
  const mesh::Mesh mesh = mesh::read_mesh(file);
  Json attributes = Json::array();
  if (!mesh.normals.empty()) attributes.push_back("N 3");
  for (const mesh::Attribute& attribute : mesh.attributes)
    attributes.push_back(fmt::format("{} {}", attribute.name, attribute.arity));
  return {{"file", file.string()},
          {"type", "mesh"},
          {"vertices", mesh.positions.size()},
          {"triangles", mesh.triangles.size()},
          {"attributes", attributes},
          {"bounds", corners(mesh::bounds(mesh))},
          {"metadata", texts_of(mesh::read_comments(read_text(file)))}};
}

/// A table with a header line, as written for cells.
Json describe_table(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  const size_t end = std::min(text.find('\n'), text.size());
  std::istringstream names(text.substr(0, end - (end > 0 && text[end - 1] == '\r')));
  Json columns = Json::array();
  for (std::string name; std::getline(names, name, ',');) columns.push_back(name);
  const auto lines = std::count(text.begin(), text.end(), '\n') +
                     static_cast<std::ptrdiff_t>(!text.empty() && text.back() != '\n');
  return {{"file", file.string()},
          {"type", "table"},
          {"rows", std::max<std::ptrdiff_t>(0, lines - 1)},
          {"columns", columns}};
}

/// The learned light of a picture.
Json describe_guiding(const std::filesystem::path& file) {
  const render::PartialRenderHeader header = render::read_guiding_header(file);
  Json texts = Json::object();
  for (const auto& [key, text] : picture::from_header_attributes(header.notes).metadata)
    texts[key] = text;
  return {{"file", file.string()},
          {"type", "learned light of a picture"},
          {"bytes", std::filesystem::file_size(file)},
          {"width", header.width},
          {"height", header.height},
          {"spp", header.spp},
          {"seed", header.seed},
          {"scene", header.identity},  // a hash of all inputs of the picture
          {"metadata", std::move(texts)}};
}

/// A partial render or a checkpoint; a checkpoint has remaining samples.
Json describe_part(const std::filesystem::path& file) {
  const render::PartialRenderInfo part = render::read_partial_render_info(file);
  render::verify_partial_render(file);
  const render::PartialRenderHeader& header = part.header;
  const picture::PictureOutput output = picture::from_header_attributes(header.notes);
  Json out = {{"file", file.string()},
              {"type", part.samples_left > 0 ? "checkpoint" : "part of a picture"},
              {"bytes", std::filesystem::file_size(file)},
              {"width", header.width},
              {"height", header.height},
              {"spp", header.spp},
              {"seed", header.seed}};
  const render::Region &crop = header.crop, &region = part.region;
  if (!(crop == render::Region{0, 0, header.width, header.height}))
    out["crop"] = {crop.x0, crop.y0, crop.x1, crop.y1};
  if (header.noise > 0) out["noise"] = header.noise;
  out["layers"] = header.aovs.names;
  out["scene"] = header.identity;  // a hash of all inputs of the picture
  out["holds"] = {{"pixels", {region.x0, region.y0, region.x1, region.y1}},
                  {"samples", {part.begin, part.end}},
                  {"done", fmt::format("{:.1f} %", std::floor(1000 * part.fraction) / 10)},
                  {"samples_left", part.samples_left}};
  Json texts = Json::object();
  for (const auto& [key, text] : output.metadata) texts[key] = text;
  out["metadata"] = std::move(texts);
  return out;
}

}  // namespace

nlohmann::ordered_json describe_file(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".vdb") return describe_vdb(file);
  if (extension == ".csv") return describe_table(file);
  for (const mesh::Format* format : mesh::formats())
    if (extension == "." + format->info.name) return describe_mesh(file);
  for (const exchange::Format* format : exchange::formats())
    if (extension == "." + format->info.name) return describe_scene(file);
  if (render::is_guiding(file)) return describe_guiding(file);
  return render::is_partial_render(file) || extension == ".vugpart" ? describe_part(file)
                                                                    : describe_picture(file);
}

}  // namespace vug::delivery
