// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/scratch_folder.h>
#include <vug/base/xml.h>
#include <vug/delivery/assembly.h>
#include <vug/delivery/measure.h>
#include <vug/delivery/recipe.h>
#include <vug/exchange/format.h>
#include <vug/exchange/levels.h>
#include <vug/grammar/tree_output.h>
#include <vug/picture/exposure.h>
#include <vug/picture/stereo_views.h>
#include <vug/session/preview.h>
#include <vug/shot/queries.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::session {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() / 3 * 4 + 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// JSON for a script element; "<", which could end the element, is escaped.
std::string script_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  for (const char c : text) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

/// Replaces the marks of the page by texts, which are not searched for marks.
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string, std::string>>& texts) {
  std::string out;
  for (const auto& [mark, text] : texts) {
    const size_t at = page.find(mark);
    if (at == std::string_view::npos)
      throw Error(ErrorCode::bad_input, fmt::format("the page has no mark {}", mark));
    out.append(page.substr(0, at)).append(text);
    page.remove_prefix(at + mark.size());
  }
  return out.append(page);
}

std::string text_of(const Value& value) {
  if (const Number* number = value.get<Number>())
    return quantity_text(number->value, number->dimension);
  return value.empty() ? "" : to_string(value);
}

Json parameters(const loading::Loaded& loaded) {
  Json out = Json::array();
  for (const loading::Parameter& each : loaded.parameters) {
    Json one = {{"name", each.name},
                {"value", text_of(each.value)},
                {"fallback", text_of(each.fallback)},
                {"low", text_of(each.low)},
                {"high", text_of(each.high)},
                {"doc", each.doc}};
    const Number *value = each.value.get<Number>(), *low = each.low.get<Number>(),
                 *high = each.high.get<Number>();
    if (value && low && high && high->value > low->value)
      one["share"] = (value->value - low->value) / (high->value - low->value);
    out.push_back(std::move(one));
  }
  return out;
}

/// File names in the page omit their folders for privacy.
Json trees(const shot::Shot& shot) {
  Json out = Json::array();
  for (const shot::Derivation& derivation : shot.derivations) {
    Json tree = Json::parse(grammar::tree_json(derivation.tree));
    for (Json& production : tree["productions"]) {
      auto& file = production["where"]["file"];
      file = std::filesystem::path(file.get<std::string>()).filename().string();
    }
    out.push_back({{"name", derivation.name}, {"tree", std::move(tree)}});
  }
  return out;
}

Json picture(const std::filesystem::path& file, const std::string& note) {
  const std::string bytes = read_text(file);
  const auto begins = [&](std::string_view with) {
    return bytes.compare(0, with.size(), with) == 0;
  };
  const char* type = begins("\x89PNG\r\n")    ? "image/png"
                     : begins("\xff\xd8\xff") ? "image/jpeg"
                                              : "";
  if (!*type)
    throw Error(ErrorCode::bad_input,
                fmt::format("'{}' is neither a PNG nor a JPEG", file.string()), {},
                "vug render writes a PNG next to its .exr");
  return {{"type", type}, {"data", base64(bytes)}, {"note", note}};
}

/// A small denoised picture, which takes at most a minute for most scenes.
Json rendered_picture(building::Builder& builder, const shot::RenderSettings& settings,
                      const ScratchFolder& scratch) {
  constexpr int kWidth = 960, kSamples = 32;
  const double shrink = std::min(1.0, double(kWidth) / settings.size[0]);
  const auto shrunk = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(side * shrink)));
  };
  const int width = shrunk(settings.size[0]), height = shrunk(settings.size[1]);
  const int spp = std::min(settings.spp, kSamples);
  picture::PictureOptions options;
  options.settings = {
      {"size", List{width, height}}, {"spp", spp}, {"denoise", true}, {"deep", false}};
  const std::vector<picture::RenderResult> rendered =
      picture::render_views(builder, picture::plan_picture(builder.shot(), options));
  const std::filesystem::path png = scratch.file("picture.png");
  picture::write_picture_file(png, picture::picture_views(rendered));
  return picture(png, fmt::format("Rendered small for this page: {} x {}, {} samples a pixel, "
                                  "smoothed",
                                  width, height, spp));
}

size_t triangles(const exchange::Assembly& assembly) {
  size_t sum = 0;
  for (const exchange::Prototype& part : assembly.prototypes) sum += part.mesh->triangles.size();
  return sum;
}

/// The name of the shown mesh with the most triangles; empty if there is none.
std::string largest_mesh(building::Builder& builder) {
  std::string name;
  size_t most = 0;
  for (const shot::ObjectPlan& object : shot::shown_objects(builder.shot()))
    if (const size_t size = builder.mesh(object.mesh)->triangles.size(); size > most)
      most = size, name = object.mesh->name;
  return name;
}

void decimate(exchange::Assembly& assembly, size_t most, Progress& progress) {
  const size_t all = triangles(assembly);
  if (all <= most) return;
  const double share = static_cast<double>(most) / static_cast<double>(all);
  progress.begin("thinning out", assembly.prototypes.size());
  for (exchange::Prototype& part : assembly.prototypes) {
    progress.check();
    mesh::Mesh made = exchange::coarser(*part.mesh, share);
    if (!made.triangles.empty()) part.mesh = std::make_shared<const mesh::Mesh>(std::move(made));
    progress.advance();
  }
  progress.end();
}

/// The exposure in stops; null if the picture is metered, which the page does itself.
Json exposure(const shot::OutputSettings& settings) {
  if (settings.exposure.metered()) return nullptr;
  return picture::exposure_stops(settings, {});
}

}  // namespace

Preview make_preview(building::Builder& builder, const loading::Loaded& loaded,
                     const PreviewOptions& options) {
  const shot::Shot& shot = builder.shot();
  const shot::RenderPlan plan = picture::plan_picture(shot).render;
  const ScratchFolder scratch("vug_preview");
  Json data = {{"name", shot.name},
               {"seed", std::to_string(shot.seed)},
               {"frame", shot.frame},
               {"version", VUG_VERSION},
               {"camera", picture::camera_name(shot, plan)},
               {"exposure", exposure(plan.settings)},
               {"picture", nullptr},
               {"metrics", nullptr}};
  if (!options.picture.empty())
    data["picture"] = picture(options.picture, options.picture.filename().string());
  delivery::AssemblyResult made = delivery::build_assembly(builder);
  Preview out;
  out.whole = triangles(made.assembly);
  decimate(made.assembly, options.max_triangles, builder.progress());
  out.triangles = triangles(made.assembly);
  const std::filesystem::path glb = scratch.file("model.glb");
  const exchange::Format& format = exchange::format("glb");
  exchange::WriteReport written =
      exchange::write(format, made.assembly, *format.space, glb, {}, builder.progress());
  out.unsupported = std::move(made.unsupported);
  for (const shot::MediumPlan& air : shot.media)
    out.unsupported.push_back(
        fmt::format("the medium '{}': the page shows only surfaces", air.name));
  for (const auto& more :
       {written.unsupported, written.notes})  // the page is not read by an add-on
    out.unsupported.insert(out.unsupported.end(), more.begin(), more.end());

  const std::string mesh = options.mesh.empty() ? largest_mesh(builder) : options.mesh;
  if (!shot.meshes.empty() || !mesh.empty()) {
    metrics::Report report = delivery::measure(builder, mesh);
    data["mesh"] = mesh;
    report.build_seconds.reset();  // varies from run to run
    data["metrics"] = Json::parse(metrics::to_json(report));
  }
  if (options.picture.empty() && options.render)
    data["picture"] = rendered_picture(builder, plan.settings, scratch);
  data["triangles"] = out.triangles;
  data["whole"] = out.whole;
  data["trees"] = trees(shot);
  data["parameters"] = parameters(loaded);
  data["recipe"] = delivery::parse_recipe(shot.recipe).scene;
  out.page = filled(options.page, {{"@VUG_TITLE@", xml_text(shot.name)},
                                   {"@VUG_DATA@", script_text(data)},
                                   {"@VUG_MODEL@", base64(read_text(glb))}});
  return out;
}

}  // namespace vug::session
