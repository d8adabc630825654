// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/render/film/aovs.h>
#include <vug/render/film/cryptomatte.h>
#include <vug/render/film/surface_aov.h>
#include <vug/render/scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace vug::render {
namespace {

/// Depth of pixels without a surface.
constexpr double kNoDepth = 1e10;
constexpr const char* kLight = "light_";
constexpr const char* kAttribute = "attribute_";

struct ChannelWriter {
  const PixelSum& sum;
  float* to;

  void put(double v) { *to++ = static_cast<float>(v); }
  /// Means over the samples that hit a surface.
  void hits(const std::array<int64_t, 3>& sums) {
    for (const int64_t v : sums) hit(v);
  }
  void hit(int64_t v) { put(from_plain(v) / std::max(sum.hits, 1u)); }
};

struct PixelAov {
  AovInfo info;
  void (*write)(ChannelWriter&);
};

/// AOVs that are computed from a PixelSum.
const std::vector<PixelAov>& pixel_aovs() {
  static const std::vector<PixelAov> all = {
      {{"beauty", "Radiance, in the working space.", {"R", "G", "B"}, true},
       [](ChannelWriter& o) {
         for (size_t i = 0; i < 3; ++i) o.put(o.sum.mean(i));
       }},
      {{"A", "Coverage: 1 for surfaces and visible lights, 0 for the sky.", {"A"}, true},
       [](ChannelWriter& o) { o.put(from_plain(o.sum.alpha) / std::max(o.sum.samples, 1u)); }},
      {{"Z", "Depth along the viewing axis in metres; 1e10 without a surface.", {"Z"}, true},
       [](ChannelWriter& o) { o.sum.hits > 0 ? o.hit(o.sum.depth) : o.put(kNoDepth); }},
      {{"N", "Normal of the first surface, in world axes.", {"N.X", "N.Y", "N.Z"}, true},
       [](ChannelWriter& o) { o.hits(o.sum.normal); }},
      {{"P", "Position of the first surface in metres.", {"P.X", "P.Y", "P.Z"}, true},
       [](ChannelWriter& o) { o.hits(o.sum.position); }},
      {{"albedo",
        "Fraction of light that the first surface reflects.",
        {"albedo.R", "albedo.G", "albedo.B"},
        true},
       [](ChannelWriter& o) { o.hits(o.sum.albedo); }},
      {{"variance",
        "Squared standard error of the beauty's pixels.",
        {"variance.R", "variance.G", "variance.B"},
        true},
       [](ChannelWriter& o) {
         for (size_t i = 0; i < 3; ++i) o.put(o.sum.variance(i));
       }},
      {{"samples", "Number of samples of the pixel.", {"samples"}, true},
       [](ChannelWriter& o) { o.put(o.sum.samples); }},
  };
  return all;
}

std::vector<std::string> colour(const std::string& layer) {
  return {layer + ".R", layer + ".G", layer + ".B"};
}

bool is_component(const std::string& name) {
  const auto& parts = component_names();
  return std::find(parts.begin(), parts.end(), name) != parts.end();
}

bool is_attribute(const std::string& name) { return name.rfind(kAttribute, 0) == 0; }

/// An AOV that is stored in the colours of a film: its index, its number of channels, and whether
/// it is a mean over the samples that hit a surface.
struct ColourAov {
  size_t index = 0, count = 3;
  bool surface = false;
};

/// The order is that of LightPathPlan.
ColourAov colour_aov(const AovPlan& plan, const std::string& name) {
  const auto& parts = component_names();
  const auto part = std::find(parts.begin(), parts.end(), name);
  if (part != parts.end()) return {static_cast<size_t>(part - parts.begin())};
  size_t index = plan.has_components() ? parts.size() : 0;
  for (const std::string& group : plan.groups) {
    if (kLight + group == name) return {index};
    ++index;
  }
  for (const SurfaceAov& aov : surface_aovs()) {
    if (aov.name == name) return {index, aov.channels.size(), true};
    if (plan.has(aov.name)) ++index;
  }
  for (const AovAttribute& attribute : plan.attributes) {
    if (kAttribute + attribute.name == name) return {index, attribute.arity, true};
    ++index;
  }
  if (name == kMotion) return {index, 2, true};
  return {};
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
    if (is_attribute(name)) out.push_back({name.substr(std::strlen(kAttribute)), 3});
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

}  // namespace

const std::vector<AovInfo>& aovs() {
  static const std::vector<AovInfo> all = [] {
    std::vector<AovInfo> list;
    for (const PixelAov& kind : pixel_aovs()) list.push_back(kind.info);
    for (const std::string& part : component_names())
      list.push_back({part, "A light component of the beauty: see docs/reference/rendering.md.",
                      colour(part), false});
    list.push_back({kMotion,
                    "Motion of the first surface until the next frame in pixels, to the right and "
                    "upwards.",
                    {"motion.X", "motion.Y"},
                    false});
    for (const SurfaceAov& aov : surface_aovs())
      list.push_back({aov.name, aov.doc, aov.channels, false});
    list.push_back(
        {kCryptoObject, "Cryptomatte of objects.", crypto_channels(kCryptoObject), false});
    list.push_back(
        {kCryptoMaterial, "Cryptomatte of materials.", crypto_channels(kCryptoMaterial), false});
    return list;
  }();
  return all;
}

std::vector<std::string> AovPlan::channels() const {
  std::vector<std::string> out;
  for (const std::string& name : names) {
    const auto& known = aovs();
    const auto layer = std::find_if(known.begin(), known.end(),
                                    [&](const AovInfo& info) { return info.name == name; });
    auto more = layer != known.end() ? layer->channels
                : is_crypto(name)    ? crypto_channels(name)
                                     : colour(name);
    for (const AovAttribute& attribute : attributes)
      if (kAttribute + attribute.name == name) {
        more.clear();
        for (uint32_t i = 0; i < attribute.arity; ++i) more.push_back(name + '.' + "XYZ"[i]);
      }
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

FilmLayout AovPlan::layout(bool deep) const {
  FilmLayout layout;
  layout.deep = deep;
  layout.colours = (has_components() ? component_names().size() : 0) + groups.size() +
                   attributes.size() + (has(kMotion) ? 1 : 0);
  for (const SurfaceAov& aov : surface_aovs()) layout.colours += has(aov.name) ? 1 : 0;
  layout.coverage = has(kCryptoObject) || has(kCryptoMaterial);
  return layout;
}

size_t AovPlan::first_element() const {
  return static_cast<size_t>(std::count_if(names.begin(), names.end(), is_attribute));
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

bool AovPlan::has_components() const {
  return std::any_of(names.begin(), names.end(), is_component);
}

AovPlan plan_aovs(const std::vector<std::string>& names, const std::vector<std::string>& groups,
                  const std::vector<AovAttribute>& attributes,
                  const std::vector<std::string>& elements) {
  std::vector<std::string> known;
  for (const AovInfo& layer : aovs()) known.push_back(layer.name);
  for (const std::string& group : groups) known.push_back(kLight + group);
  const size_t lights_end = known.size();
  for (const AovAttribute& attribute : attributes) known.push_back(kAttribute + attribute.name);
  const size_t attributes_end = known.size();
  if (!elements.empty()) known.emplace_back(kCryptoElement);
  std::vector<bool> chosen(known.size());
  for (size_t i = 0; i < aovs().size(); ++i) chosen[i] = names.empty() && aovs()[i].is_default;
  for (const std::string& name : names) {
    bool found = name == "parts" || name == "lights" || name == "attributes" ||
                 name == "cryptomatte" || name == "all";
    for (size_t i = 0; i < known.size(); ++i) {
      const bool light = i >= aovs().size() && i < lights_end;
      if (!(known[i] == name || name == "all" || (name == "parts" && is_component(known[i])) ||
            (name == "lights" && light) ||
            (name == "attributes" && i >= lights_end && i < attributes_end) ||
            (name == "cryptomatte" && is_crypto(known[i]))))
        continue;
      chosen[i] = found = true;
    }
    if (found) continue;
    known.insert(known.end(), {"parts", "lights", "attributes", "cryptomatte", "all"});
    throw Error(ErrorCode::bad_input, fmt::format("unknown layer '{}'", name), {},
                suggestion(name, known));
  }
  AovPlan plan;
  for (size_t i = 0; i < known.size(); ++i) {
    if (!chosen[i]) continue;
    plan.names.push_back(known[i]);
    if (i >= attributes_end)
      for (const std::string& element : elements) plan.attributes.push_back({element, 1});
    else if (i >= lights_end)
      plan.attributes.push_back(attributes[i - lights_end]);
    else if (i >= aovs().size())
      plan.groups.push_back(groups[i - aovs().size()]);
  }
  // `develop` writes these last.
  std::stable_partition(plan.names.begin(), plan.names.end(),
                        [](const std::string& name) { return !is_crypto(name); });
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
  std::vector<ColourAov> colours;
  std::vector<CryptoAov> cryptos;
  for (const std::string& name : plan.names) {
    const auto kind = std::find_if(pixel_aovs().begin(), pixel_aovs().end(),
                                   [&](const PixelAov& k) { return k.info.name == name; });
    if (kind != pixel_aovs().end())
      writers.push_back(kind->write);
    else if (is_crypto(name))
      cryptos.push_back({crypto_ids(plan.crypto_names(name)), name == kCryptoElement});
    else
      colours.push_back(colour_aov(plan, name));
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
