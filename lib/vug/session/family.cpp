#include <vug/field/blend_kind.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/paint/kind.h>
#include <vug/render/kinds.h>
#include <vug/session/family.h>
#include <vug/session/objects.h>
#include <vug/session/volume_kinds.h>

namespace vug::session {
namespace {

template <class Product>
Family family(const std::string& type, const std::vector<const Kind<Product>*>& kinds) {
  Family out{type, {}};
  for (const Kind<Product>* kind : kinds)
    out.kinds.push_back({&kind->info,
                         [kind, type](const Arguments& arguments, SourceLocation where,
                                      Diagnostics& diagnostics) -> std::optional<Value> {
                           auto product = kind->make(arguments, std::move(where), diagnostics);
                           if (!product) return std::nullopt;
                           return Value(Object{type, std::move(*product)});
                         }});
  return out;
}

}  // namespace

const FamilyKind* Family::find(const std::string& name) const {
  for (const FamilyKind& kind : kinds)
    if (kind.info->name == name) return &kind;
  return nullptr;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      family("field", field::field_kinds()), family("blend", field::blends()),
      family("noise", field::noises()),      family("volume", volume_kinds()),
      family("mask", paint::masks()),        family("paint", paint::paints()),
      family("material", render::bsdfs()),   family("light", render::lights()),
      family("medium", render::media()),     family("camera", render::cameras()),
      family("sampler", render::samplers()), family("integrator", render::integrators()),
  };
  return all;
}

const Family* find_family(const std::string& type) {
  for (const Family& family : families())
    if (family.type == type) return &family;
  return nullptr;
}

}  // namespace vug::session
