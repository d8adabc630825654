// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/render/film/aovs.h>
#include <vug/render/film/cryptomatte.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::render {
namespace {

/// Requests every AOV.
constexpr const char* kAll = "all";

/// An AOV that is stored in the colours of a film: its index, its number of channels, and whether
/// it is a mean over the samples that hit a surface.
struct ColourAov {
  size_t index = 0, count = 3;
  bool surface = false;
};

size_t component_index(const std::string& name) {
  const auto& all = light_components();
  return static_cast<size_t>(
      std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; }) -
      all.begin());
}

/// The AOVs of the plan that are stored in the colours of a film, whose order is that of
/// LightPathPlan.
std::vector<ColourAov> colour_aovs(const AovPlan& plan) {
  std::vector<ColourAov> out;
  size_t group = plan.has_components() ? light_components().size() : 0;
  size_t surface = group + plan.groups.size();
  const size_t attributes = surface + plan.count(AovSource::surface);
  size_t attribute = 0;
  for (const std::string& name : plan.names) {
    const AovInfo& row = *find_aov(name);
    if (row.source == AovSource::light_component)
      out.push_back({component_index(name)});
    else if (row.source == AovSource::light_group)
      out.push_back({group++});
    else if (row.source == AovSource::surface)
      out.push_back({surface++, row.channels.size(), true});
    else if (row.source == AovSource::attribute) {
      out.push_back({attributes + attribute, plan.attributes[attribute].arity, true});
      ++attribute;
    } else if (row.source == AovSource::motion)
      out.push_back({attributes + plan.attributes.size(), row.channels.size(), true});
  }
  return out;
}

/// The attributes of all meshes, each once, with its largest arity.
std::vector<AovAttribute> attributes_of(const Scene& scene) {
  std::vector<AovAttribute> out;
  for (const Object& object : scene.objects) {
    if (!object.mesh) continue;
    for (const mesh::Attribute& attribute : object.mesh->attributes) {
      const auto arity = static_cast<uint32_t>(std::clamp(attribute.arity, 1, 3));
      auto found = std::find_if(out.begin(), out.end(), [&](const AovAttribute& known) {
        return known.name == attribute.name;
      });
      if (found == out.end()) found = out.insert(found, {attribute.name, arity});
      found->arity = std::max(found->arity, arity);
    }
  }
  return out;
}

/// Attributes that are requested by name.
std::vector<AovAttribute> named_attributes(const std::vector<std::string>& names) {
  std::vector<AovAttribute> out;
  for (const std::string& name : names)
    if (is_from(name, AovSource::attribute)) out.push_back({name_in_aov(name), 3});
  return out;
}

/// A Cryptomatte AOV: of objects or materials, from coverage; or of elements, from attribute
/// values.
struct CryptoAov {
  CryptoIds ids;
  bool elements;
};

/// The shares of the elements in a pixel; `first`: index of the first element in the film's
/// colours.
CryptoShares element_shares(const Film& film, int x, int y, size_t first, const CryptoIds& ids) {
  CryptoShares shares;
  const double samples = std::max(film.at(x, y).samples, 1u);
  for (size_t i = 0; i < ids.size(); ++i) {
    const double share = from_wide(film.colours(x, y)[3 * (first + i)], kLightBits) / samples;
    if (share > 0) shares.emplace_back(ids[i], static_cast<float>(share));
  }
  return shares;
}

/// An AOV that a scene offers.
struct Candidate {
  const AovInfo& row;
  std::string name;
  size_t index = 0;  ///< Index of the light group or attribute.

  bool is_in(const std::vector<std::string>& names) const {
    if (names.empty()) return row.is_default;
    return std::any_of(names.begin(), names.end(), [&](const std::string& requested) {
      return requested == name || requested == kAll || (requested == row.set && !requested.empty());
    });
  }
};

std::vector<Candidate> candidates(const std::vector<std::string>& groups,
                                  const std::vector<AovAttribute>& attributes, bool has_elements) {
  std::vector<Candidate> out;
  for (const AovInfo& row : aovs())
    if (row.source == AovSource::light_group)
      for (size_t i = 0; i < groups.size(); ++i) out.push_back({row, aov_name(row, groups[i]), i});
    else if (row.source == AovSource::attribute)
      for (size_t i = 0; i < attributes.size(); ++i)
        out.push_back({row, aov_name(row, attributes[i].name), i});
    else if (row.name != kCryptoElement || has_elements)
      out.push_back({row, row.name});
  return out;
}

/// The names that request several AOVs.
std::vector<std::string> set_names() {
  std::vector<std::string> out;
  for (const AovInfo& row : aovs())
    if (!row.set.empty() && std::find(out.begin(), out.end(), row.set) == out.end())
      out.push_back(row.set);
  out.emplace_back(kAll);
  return out;
}

void require_known(const std::vector<std::string>& names, const std::vector<Candidate>& offered) {
  std::vector<std::string> known;
  for (const Candidate& candidate : offered) known.push_back(candidate.name);
  const std::vector<std::string> sets = set_names();
  known.insert(known.end(), sets.begin(), sets.end());
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(ErrorCode::bad_input, fmt::format("unknown layer '{}'", name), {},
                  suggestion(name, known));
}

}  // namespace

std::vector<std::string> AovPlan::channels() const {
  std::vector<std::string> out;
  size_t attribute = 0;
  for (const std::string& name : names) {
    std::vector<std::string> more = aov_channels(name);
    if (is_from(name, AovSource::attribute)) more.resize(attributes[attribute++].arity);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

FilmLayout AovPlan::layout(bool deep) const {
  FilmLayout layout;
  layout.colours = (has_components() ? light_components().size() : 0) + groups.size() +
                   count(AovSource::surface) + attributes.size() + (has(kMotion) ? 1 : 0);
  layout.coverage = has(kCryptoObject) || has(kCryptoMaterial);
  layout.deep = deep;
  return layout;
}

size_t AovPlan::count(AovSource source) const {
  return static_cast<size_t>(
      std::count_if(names.begin(), names.end(),
                    [source](const std::string& name) { return is_from(name, source); }));
}

size_t AovPlan::first_element() const { return count(AovSource::attribute); }

bool AovPlan::is_consistent() const {
  return std::all_of(names.begin(), names.end(), find_aov) &&
         count(AovSource::light_group) == groups.size() && first_element() <= attributes.size() &&
         std::all_of(attributes.begin(), attributes.end(),
                     [](const AovAttribute& each) { return each.arity >= 1 && each.arity <= 3; });
}

std::vector<std::string> AovPlan::crypto_names(const std::string& layer) const {
  if (layer == kCryptoObject) return objects;
  if (layer == kCryptoMaterial) return materials;
  std::vector<std::string> elements;
  for (size_t i = first_element(); i < attributes.size(); ++i)
    elements.push_back(attributes[i].name);
  return elements;
}

bool AovPlan::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool AovPlan::has_components() const { return count(AovSource::light_component) > 0; }

AovPlan plan_aovs(const std::vector<std::string>& names, const std::vector<std::string>& groups,
                  const std::vector<AovAttribute>& attributes,
                  const std::vector<std::string>& elements) {
  const std::vector<Candidate> offered = candidates(groups, attributes, !elements.empty());
  require_known(names, offered);
  AovPlan plan;
  for (const Candidate& candidate : offered) {
    if (!candidate.is_in(names)) continue;
    plan.names.push_back(candidate.name);
    if (candidate.row.source == AovSource::light_group)
      plan.groups.push_back(groups[candidate.index]);
    if (candidate.row.source == AovSource::attribute)
      plan.attributes.push_back(attributes[candidate.index]);
    if (candidate.name == kCryptoElement)
      for (const std::string& element : elements) plan.attributes.push_back({element, 1});
  }
  if (!plan.has("beauty"))
    throw Error(ErrorCode::bad_input, "a picture needs the layer 'beauty'", {}, "add it to layers");
  return plan;
}

AovPlan scene_aovs(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<std::string> groups;
  const auto add_group = [&](const std::string& group) {
    if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end())
      groups.push_back(group);
  };
  for (const LightPtr& light : scene.lights)
    if (light) add_group(light->linking().group);
  for (const Object& object : scene.objects) add_group(object.light_group);
  std::set<std::string> elements;
  for (const Object& object : scene.objects)
    elements.insert(object.elements.begin(), object.elements.end());
  const bool has_geometry =
      !scene.objects.empty() &&
      std::all_of(scene.objects.begin(), scene.objects.end(),
                  [](const Object& object) { return object.mesh || object.surface; });
  AovPlan plan =
      plan_aovs(names, groups, has_geometry ? attributes_of(scene) : named_attributes(names),
                {elements.begin(), elements.end()});
  if (!plan.layout().coverage) return plan;
  for (const Object& object : scene.objects) {
    plan.objects.push_back(object.name);
    plan.materials.push_back(object.material_name);
  }
  return plan;
}

void develop(const Film& film, const AovPlan& plan, const Region& origin, image::Image& image) {
  std::vector<void (*)(ChannelWriter&)> writers;
  const std::vector<ColourAov> colours = colour_aovs(plan);
  std::vector<CryptoAov> cryptos;
  for (const std::string& name : plan.names) {
    const AovInfo& row = *find_aov(name);
    if (row.write) writers.push_back(row.write);
    if (row.source == AovSource::cryptomatte)
      cryptos.push_back({crypto_ids(plan.crypto_names(name)), name == kCryptoElement});
  }
  const size_t first_element = film.layout().colours - (plan.has(kMotion) ? 1 : 0) -
                               plan.attributes.size() + plan.first_element();
  const Region& region = film.region();
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      ChannelWriter out{film.at(x, y), &image.at(x - origin.x0, y - origin.y0)};
      for (const auto& write : writers) write(out);
      for (const ColourAov& colour : colours) {
        const uint32_t over = colour.surface ? out.sum.hits : out.sum.samples;
        const double share = 1.0 / std::max(over, 1u);
        for (size_t i = 0; i < colour.count; ++i)
          out.put(from_wide(film.colours(x, y)[3 * colour.index + i], kLightBits) * share);
      }
      for (const CryptoAov& crypto : cryptos)
        out.to = crypto.elements
                     ? write_ranks(element_shares(film, x, y, first_element, crypto.ids), out.to)
                     : write_crypto(film.coverage(x, y), out.sum.samples, crypto.ids, out.to);
    }
}

}  // namespace vug::render
