// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/validate.h>
#include <vug/render/render.h>
#include <vug/shot/queries.h>
#include <vug/shot/selection.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::loading {
namespace {

/// The text after "NAME/"; nothing if it does not begin with that.
std::optional<std::string> name_after(const std::string& text, const std::string& name) {
  if (text.compare(0, name.size() + 1, name + "/") != 0) return std::nullopt;
  return text.substr(name.size() + 1);
}

bool shows_several(const shot::Shot& shot) {
  return shot::shown_objects(shot).size() != 1 || !shot.instancers.empty();
}

/// `rest`: the name after that of the `place`.
bool contains(const shot::PointInstancer& place, std::string rest) {
  if (place.apart) {
    const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits == 0) return false;
    if (digits == rest.size()) return true;
    if (rest[digits] != '/') return false;
    rest = rest.substr(digits + 1);
  }
  return std::any_of(place.of.begin(), place.of.end(), [&](const shot::Model& model) {
    return model.scene && shows_several(*model.scene) && is_linkable(*model.scene, rest);
  });
}

/// The location of the declaration of the light.
SourceLocation location_of_light(const std::string& light, const scene::Document& document) {
  const scene::Declaration* made = document.find(light, "light");
  return made ? made->where : SourceLocation();
}

std::string link_hint(const shot::Shot& shot, const std::string& name) {
  std::vector<std::string> names;
  for (const shot::ObjectPlan& object : shot::shown_objects(shot)) names.push_back(object.name);
  for (const shot::PointInstancer& place : shot.instancers) {
    names.push_back(place.name);
    shot::PointInstancer told_apart = place;
    told_apart.apart = true;
    if (const auto rest = name_after(name, place.name); rest && contains(told_apart, *rest))
      return fmt::format("write 'apart true' in the place '{}' to name its instances separately",
                         place.name);
    for (const shot::Model& model : place.of)
      if (model.name == name)
        return fmt::format("as an instance, '{}' has the name of its place: '{}'", name,
                           place.name);
  }
  return suggestion(name, names);
}

/// Whether the name is declared in the text or may be declared in its unparsed parts.
bool is_declared(const std::string& name, const scene::Document& document) {
  const std::string first = name.substr(0, name.find('/'));
  return document.skipped.may_declare(scene::name_without_index(first)) || document.find(first);
}

/// The location of a name in an expression.
SourceLocation find_name(const scene::Expr& expr, const std::string& name) {
  if (expr.kind == scene::ExprKind::name && expr.text == name) return expr.where;
  for (const scene::Operand& part : expr.operands)
    if (const SourceLocation where = find_name(*part.value, name); where.known()) return where;
  return {};
}

const scene::Entry* find_entry(const shot::RenderPlan& plan, const std::string& key,
                               const scene::Document& document) {
  const scene::Declaration* made = document.find(plan.name, "render");
  return made ? made->find_entry(key) : nullptr;
}

/// The location of the name in the entry of the render block, else that of the block's name.
SourceLocation location_of_selected(const shot::SelectionFault& fault, const shot::RenderPlan& plan,
                                    const scene::Document& document) {
  const scene::Entry* entry = find_entry(plan, fault.setting, document);
  if (entry)
    for (const scene::ExprPtr& value : entry->values)
      if (const SourceLocation where = find_name(*value, fault.name); where.known()) return where;
  return entry ? entry->where : plan.where;
}

/// Reports unknown names of lights, objects and media, and a missing choice of the air. `whole`:
/// the text has no other errors, which may be the reason why a name is unknown.
void check_selections(const shot::Shot& shot, const scene::Document& document, bool whole,
                      Diagnostics& diagnostics) {
  std::vector<shot::RenderPlan> renders = shot.renders;
  if (renders.empty() && !is_empty_scene(shot) && shot.media.size() > 1)
    renders.push_back({"main", {}, shot.media[1].where, false, {}});
  for (const shot::RenderPlan& plan : renders)
    for (const shot::SelectionFault& fault : shot::find_selection_faults(shot, plan.settings))
      if (whole || (!fault.name.empty() && !is_declared(fault.name, document)))
        diagnostics.error(location_of_selected(fault, plan, document), fault.message, fault.hint);
}

/// Warns about portals in scenes without a sky that needs them.
void warn_about_dark_portals(const shot::Shot& shot, const scene::Document& document,
                             Diagnostics& diagnostics) {
  const auto shines_through = [](const auto& named) {
    const render::Light& light = *named.second;
    return light.is_infinite() && !light.is_portal() && !light.sampled_with_portals();
  };
  if (std::any_of(shot.lights.begin(), shot.lights.end(), shines_through)) return;
  for (const auto& [name, light] : shot.lights)
    if (light->is_portal())
      diagnostics.warning(
          location_of_light(name, document),
          fmt::format("no light comes through the portal '{}': the scene has no sky", name),
          "a portal emits no light itself: declare a sky, as light NAME = daylight()");
}

/// Whether an expression calls a kind, itself or through the names of lets, which have no cycles in
/// a scene without errors.
bool calls(const scene::Expr& expr, const std::string& kind, const scene::Document& document) {
  if (expr.kind == scene::ExprKind::call && expr.text == kind) return true;
  if (expr.kind == scene::ExprKind::name)
    if (const scene::Let* let = document.find_let(full_name(expr)); let && let->value)
      return calls(*let->value, kind, document);
  return std::any_of(expr.operands.begin(), expr.operands.end(), [&](const scene::Operand& each) {
    return each.value && calls(*each.value, kind, document);
  });
}

/// Warns about more lights along a network than a picture needs.
void warn_about_long_rows(const shot::Shot& shot, const scene::Document& document,
                          Diagnostics& diagnostics) {
  constexpr std::ptrdiff_t kLongRow = 200;
  for (const scene::Declaration& row : document.declarations) {
    if (row.kind != "light" || !row.loop || !calls(*row.loop, "along", document)) continue;
    const auto count =
        std::count_if(shot.lights.begin(), shot.lights.end(), [&](const auto& named) {
          return named.first != row.name && scene::name_without_index(named.first) == row.name;
        });
    if (count > kLongRow)
      diagnostics.warning(row.where, fmt::format("'{}' is a row of {} lights", row.name, count),
                          "give 'along' a larger 'spacing', or of: part(...) of the network, if "
                          "fewer are enough");
  }
}

}  // namespace

bool is_linkable(const shot::Shot& shot, const std::string& name) {
  for (const shot::ObjectPlan& object : shot::shown_objects(shot))
    if (object.name == name) return true;
  for (const shot::PointInstancer& place : shot.instancers) {
    if (place.name == name) return true;
    if (const auto rest = name_after(name, place.name); rest && contains(place, *rest)) return true;
  }
  return false;
}

bool is_empty_scene(const shot::Shot& shot) {
  return shot::shown_objects(shot).empty() && shot.instancers.empty() && shot.lights.empty();
}

render::AovPlan expected_aovs(const shot::Shot& shot, const shot::RenderPlan& plan) {
  render::Scene lights;
  for (const std::string& group : shot::light_groups(shot))
    lights.objects.emplace_back().light_group = group;
  for (const shot::MeshPtr& mesh : shot.meshes)
    lights.objects.emplace_back().elements = shot::element_names(*mesh);
  try {
    return render::scene_aovs(lights, plan.settings.layers);
  } catch (const Error& error) {
    throw error.at(plan.where);
  }
}

namespace {

void require_valid_crop(const shot::RenderPlan& plan) {
  const shot::RenderSettings& settings = plan.settings;
  if (settings.crop.empty()) return;
  render::Options options;
  options.width = settings.size.at(0), options.height = settings.size.at(1);
  const std::vector<int>& crop = settings.crop;
  options.crop = {crop.at(0), crop.at(1), crop.at(2), crop.at(3)};
  try {
    render::render_region(options);
  } catch (const Error& error) {
    throw error.at(plan.where);
  }
}

/// Warns about settings of an exposure that the chosen one ignores.
void warn_about_unused_exposure(const shot::RenderPlan& plan, const scene::Document& document,
                                Diagnostics& diagnostics) {
  using Mode = shot::Exposure::Mode;
  const Mode mode = plan.settings.exposure.mode;
  const auto warn = [&](const char* key, const char* hint) {
    if (const scene::Entry* entry = find_entry(plan, key, document))
      diagnostics.warning(entry->extent, fmt::format("'{}' has no effect on this exposure", key),
                          hint);
  };
  if (mode != Mode::physical)
    for (const char* key : {"iso", "f_number", "exposure_time"})
      warn(key, "it belongs to 'exposure physical'");
  if (mode == Mode::stops)
    warn("compensation", "it is added to 'exposure auto'; add the stops to 'exposure' instead");
}

/// Reports the error of a check at the entry that it checks.
template <class Check>
void report_entry(const char* key, const shot::RenderPlan& plan, const scene::Document& document,
                  Diagnostics& diagnostics, const Check& check) {
  try {
    check();
  } catch (const Error& error) {
    const scene::Entry* entry = find_entry(plan, key, document);
    diagnostics.error(entry ? entry->extent : error.where(), error.what(), error.hint());
  }
}

}  // namespace

void validate(const shot::Shot& shot, const scene::Document& document, Diagnostics& diagnostics) {
  const bool whole = !diagnostics.has_errors();
  for (const auto& [name, light] : shot.lights)
    for (const auto* names : {&light->linking().only, &light->linking().except})
      for (const std::string& linked : *names)
        if (!is_linkable(shot, linked) && (whole || !is_declared(linked, document)))
          diagnostics.error(
              location_of_light(name, document),
              fmt::format("the light is linked to '{}', but no shown object has that name", linked),
              link_hint(shot, linked));
  check_selections(shot, document, whole, diagnostics);
  if (!whole) return;
  warn_about_dark_portals(shot, document, diagnostics);
  warn_about_long_rows(shot, document, diagnostics);
  for (const shot::RenderPlan& plan : shot.renders) {
    warn_about_unused_exposure(plan, document, diagnostics);
    report_entry("layers", plan, document, diagnostics, [&] { expected_aovs(shot, plan); });
    report_entry("crop", plan, document, diagnostics, [&] { require_valid_crop(plan); });
  }
}

}  // namespace vug::loading
