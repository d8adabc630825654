#include <vug/cells/kind.h>
#include <vug/facade/carve.h>
#include <vug/field/blend_kind.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/flora/distribution.h>
#include <vug/flora/shape.h>
#include <vug/loading/instance_source_kinds.h>
#include <vug/loading/kind_category.h>
#include <vug/loading/plants.h>
#include <vug/loading/plugin_kinds.h>
#include <vug/paint/kind.h>
#include <vug/render/kinds.h>
#include <vug/shot/cell_stages.h>
#include <vug/shot/curves.h>
#include <vug/shot/plan_values.h>
#include <vug/shot/volume_kinds.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace vug::loading {
namespace {

template <class Product, class... More>
Family family(const Kinds<Product>& kinds, const More&... more) {
  Family out{ValueTraits<Product>::type(), {}};
  for (const Kinds<Product>* each : {&kinds, &more...})
    for (const Kind<Product>* kind : *each) out.kinds.push_back(as_family_kind(*kind));
  return out;
}

}  // namespace

bool has_choice(const KindInfo& kind, const std::string& parameter, const std::string& word) {
  for (const ParamInfo& info : kind.params)
    if (info.name == parameter)
      return std::find(info.choices.begin(), info.choices.end(), word) != info.choices.end();
  return false;
}

const FamilyKind* Family::find(const std::string& name) const {
  for (const FamilyKind& kind : kinds)
    if (kind.info->name == name) return &kind;
  return nullptr;
}

namespace {

std::vector<Family>& own_families() {
  static std::vector<Family> all = {
      family(field::field_kinds(), plant_kinds(), facade::solids()),
      family(field::blends()),
      family(field::noises()),
      family(shot::volume_kinds()),
      family(paint::masks()),
      family(paint::paints()),
      family(render::materials()),
      family(render::lights()),
      family(render::media()),
      family(render::cameras()),
      family(render::samplers()),
      family(render::integrators()),
      family(places_kinds()),
      family(model_kinds()),
      family(cells::grids()),
      family(flora::distributions()),
      family(flora::shapes()),
      family(shot::cell_stages()),
      family(shot::curve_kinds()),
      family(facade::elements()),
  };
  return all;
}

std::atomic<bool> asked_for = false;

}  // namespace

const std::vector<Family>& families() {
  asked_for = true;
  return own_families();
}

void add_kinds(const std::vector<std::pair<std::string, FamilyKind>>& kinds) {
  if (asked_for)
    throw Error(ErrorCode::bad_input, "comes too late: the kinds are in use already", {},
                "load plugins before the first scene");
  std::vector<Family> all = own_families();
  for (const auto& [type, kind] : kinds) {
    const std::string& wanted = type;  // clang 14 captures no parts of a pair
    const auto family = std::find_if(all.begin(), all.end(),
                                     [&](const Family& each) { return each.type == wanted; });
    if (family == all.end())
      throw Error(ErrorCode::bad_input,
                  fmt::format("brings a {}, of which a scene knows none", type));
    if (family->find(kind.info->name))
      throw Error(ErrorCode::bad_input,
                  fmt::format("brings a {} '{}', which is there already", type, kind.info->name));
    family->kinds.push_back(kind);
  }
  own_families() = std::move(all);
}

const Family* find_family(const std::string& type) {
  for (const Family& family : families())
    if (family.type == type) return &family;
  return nullptr;
}

}  // namespace vug::loading
