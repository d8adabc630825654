// SPDX-License-Identifier: Apache-2.0
// Labels of the speleothems of named drips, which contain the numbers of their drips.
#include <vug/field/boolean.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/thickened.h>
#include <vug/shot/drips_plan.h>
#include <vug/shot/label_lists.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug::shot {
namespace {

constexpr const char* kFlowstone = "flowstone";

struct FormLabels {
  DripsPtr of;
  int most = 100;

  static void describe(Schema<FormLabels>& s) {
    s.doc(
         "Labels for the entry `labels` of a mesh: the attribute KIND_DRIP, such as stalagmite_96, "
         "is 1 at the vertices of the stalagmite of drip 96, and the AOV CryptoElement has that "
         "name there. Drips that were added are added1, added2, ... The smaller speleothems share "
         "one label for each kind, e.g. stalagmite. Bare rock has the label rock.")
        .param("of", &FormLabels::of, {.doc = "the drips", .required = true})
        .param("most", &FormLabels::most,
               {.doc = "the number of speleothems with labels of their own: the largest forms and "
                       "draperies, "
                       "then flowstone",
                .min = 0,
                .max = 240});
  }
};

/// A speleothem with its solid.
struct Grown {
  std::string kind;
  int64_t drip = 0;
  double volume = 0;  ///< In m3, roughly.
  field::Field solid;
};

std::string underscored(const char* kind) {
  std::string out = kind;
  std::replace(out.begin(), out.end(), ' ', '_');
  return out;
}

std::string label_of(const Grown& part) {
  return part.drip < 0 ? fmt::format("{}_added{}", part.kind, -part.drip)
                       : fmt::format("{}_{}", part.kind, part.drip);
}

std::vector<Grown> solids_of(const DripsPlan& plan) {
  const drips::Dripstone& grown = plan.grown();
  const drips::DripstoneOptions& o = plan.options();
  std::vector<Grown> parts;
  const std::vector<field::Field> forms = drips::form_fields(grown.forms, o.forms);
  for (size_t i = 0; i < forms.size(); ++i) {
    const drips::Form& form = grown.forms[i];
    parts.push_back({underscored(drips::kind_name(form.kind)), form.drip,
                     form.radius * form.radius * (form.top - form.bottom).length(), forms[i]});
  }
  const std::vector<field::Field> sheets = drips::drapery_fields(grown.draperies, o.draperies);
  for (size_t i = 0; i < sheets.size(); ++i) {
    const drips::HungDrapery& drapery = grown.draperies[i];
    parts.push_back({"drapery", drapery.drip, drapery.sheet.edge * std::pow(drapery.sheet.width, 2),
                     sheets[i]});
  }
  std::map<int64_t, std::vector<field::Deposit>> layers;
  for (const field::Deposit& layer : grown.layers) layers[layer.drip].push_back(layer);
  for (const auto& [drip, of_drip] : layers) {
    double volume = 0;
    for (const field::Deposit& layer : of_drip)
      volume += layer.thickness_from * layer.half_width_from *
                std::max((layer.to - layer.from).length(), layer.half_width_from);
    parts.push_back(
        {kFlowstone, drip, volume,
         field::thickened(plan.rock(), field::thickness_field(of_drip), field::kThickestDeposit)});
  }
  return parts;
}

std::vector<SurfaceLabel> labels(const FormLabels& p) {
  std::vector<Grown> parts = solids_of(*p.of);
  std::stable_sort(parts.begin(), parts.end(), [](const Grown& a, const Grown& b) {
    // Flowstone has more volume than most forms, but is looked for less.
    const bool skin = a.kind == kFlowstone, other = b.kind == kFlowstone;
    return skin != other ? other : a.volume > b.volume;
  });
  // First, because the first of equal values counts, and flowstone has that of the rock next to it.
  std::vector<SurfaceLabel> out{{"rock", p.of->rock()}};
  std::map<std::string, std::vector<field::Field>> rest;
  for (size_t i = 0; i < parts.size(); ++i)
    if (i < static_cast<size_t>(p.most))
      out.push_back({label_of(parts[i]), parts[i].solid});
    else
      rest[parts[i].kind].push_back(parts[i].solid);
  for (auto& [kind, solids] : rest) out.push_back({kind, field::unite(std::move(solids))});
  return out;
}

}  // namespace
}  // namespace vug::shot

VUG_LABEL_LIST_KIND(form_labels) {
  return make_kind<std::vector<SurfaceLabel>, FormLabels>("form_labels", "labels", labels);
}
