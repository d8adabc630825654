#include <vug/cells/kind.h>
#include <vug/field/blend_kind.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/paint/kind.h>
#include <vug/render/kinds.h>
#include <vug/session/family.h>
#include <vug/session/objects.h>
#include <vug/session/places.h>
#include <vug/session/stages.h>
#include <vug/session/volume_kinds.h>

#include <algorithm>

namespace vug::session {
namespace {

template <class Product>
Family family(const Kinds<Product>& kinds) {
  Family out{ValueTraits<Product>::type(), {}};
  for (const Kind<Product>* kind : kinds)
    out.kinds.push_back({&kind->info,
                         [kind](const Arguments& arguments, const SourceLocation& where,
                                Diagnostics& diagnostics) -> std::optional<Value> {
                           auto product = kind->make(arguments, where, diagnostics);
                           if (!product) return std::nullopt;
                           return ValueTraits<Product>::write(*product);
                         }});
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

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      family(field::field_kinds()), family(field::blends()),    family(field::noises()),
      family(volume_kinds()),       family(paint::masks()),     family(paint::paints()),
      family(render::materials()),  family(render::lights()),   family(render::media()),
      family(render::cameras()),    family(render::samplers()), family(render::integrators()),
      family(places_kinds()),       family(model_kinds()),      family(cells::grids()),
      family(cell_stages()),
  };
  return all;
}

const Family* find_family(const std::string& type) {
  for (const Family& family : families())
    if (family.type == type) return &family;
  return nullptr;
}

}  // namespace vug::session
