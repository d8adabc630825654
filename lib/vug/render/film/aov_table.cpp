// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/aov_table.h>
#include <vug/render/film/cryptomatte.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/film/surface_aov.h>

#include <algorithm>
#include <string_view>

namespace vug::render {
namespace {

/// Depth of pixels without a surface.
constexpr double kNoDepth = 1e10;
constexpr std::string_view kPlaceholder = "NAME";

/// A mean over the samples that hit a surface.
void put_hit(ChannelWriter& out, int64_t sum) {
  out.put(from_plain(sum) / std::max(out.sum.hits, 1u));
}
void put_hits(ChannelWriter& out, const std::array<int64_t, 3>& sums) {
  for (const int64_t sum : sums) put_hit(out, sum);
}

std::vector<std::string> with_suffixes(const std::string& name, std::string_view suffixes) {
  std::vector<std::string> out;
  for (const char suffix : suffixes) out.push_back(name + '.' + suffix);
  return out;
}

AovInfo pixel_aov(const std::string& name, const std::string& doc,
                  std::vector<std::string> channels, void (*write)(ChannelWriter&)) {
  return {name, doc, std::move(channels), AovSource::pixel_sum, true, {}, write};
}

AovInfo crypto_aov(const std::string& name, const std::string& doc) {
  return {name, doc, crypto_channels(name), AovSource::cryptomatte, false, "cryptomatte"};
}

std::vector<AovInfo> table() {
  std::vector<AovInfo> rows = {
      pixel_aov("beauty", "Radiance, in the working space.", {"R", "G", "B"},
                [](ChannelWriter& o) {
                  for (size_t i = 0; i < 3; ++i) o.put(o.sum.mean(i));
                }),
      pixel_aov(
          "A", "Coverage: 1 for surfaces and visible lights, 0 for the sky.", {"A"},
          [](ChannelWriter& o) { o.put(from_plain(o.sum.alpha) / std::max(o.sum.samples, 1u)); }),
      pixel_aov(
          "Z", "Depth along the viewing axis in metres; 1e10 without a surface.", {"Z"},
          [](ChannelWriter& o) { o.sum.hits > 0 ? put_hit(o, o.sum.depth) : o.put(kNoDepth); }),
      pixel_aov("N", "Normal of the first surface in world space, on the viewer's side.",
                with_suffixes("N", "XYZ"), [](ChannelWriter& o) { put_hits(o, o.sum.normal); }),
      pixel_aov("P", "Position of the first surface in metres.", with_suffixes("P", "XYZ"),
                [](ChannelWriter& o) { put_hits(o, o.sum.position); }),
      pixel_aov("albedo", "Fraction of light that the first surface reflects.",
                with_suffixes("albedo", "RGB"),
                [](ChannelWriter& o) { put_hits(o, o.sum.albedo); }),
      pixel_aov("variance", "Squared standard error of the beauty.",
                with_suffixes("variance", "RGB"),
                [](ChannelWriter& o) {
                  for (size_t i = 0; i < 3; ++i) o.put(o.sum.variance(i));
                }),
      pixel_aov("samples", "Number of samples of the pixel.", {"samples"},
                [](ChannelWriter& o) { o.put(o.sum.samples); }),
  };
  for (const LightComponentInfo& component : light_components())
    rows.push_back({component.name, component.doc, with_suffixes(component.name, "RGB"),
                    AovSource::light_component, false, "parts"});
  rows.push_back({kMotion,
                  "Motion of the first surface until the next frame in pixels, to the right and "
                  "upwards.",
                  with_suffixes(kMotion, "XY"), AovSource::motion});
  for (const SurfaceAov& aov : surface_aovs())
    rows.push_back({aov.name, aov.doc, aov.channels, AovSource::surface});
  rows.push_back({"light_NAME", "The contribution of the lights whose group is NAME.",
                  with_suffixes("light_NAME", "RGB"), AovSource::light_group, false, "lights"});
  rows.push_back({"attribute_NAME",
                  "The attribute NAME of the visible mesh, with as many channels as it has "
                  "components.",
                  with_suffixes("attribute_NAME", "XYZ"), AovSource::attribute, false,
                  "attributes"});
  rows.push_back(crypto_aov(kCryptoObject, "Cryptomatte of objects."));
  rows.push_back(crypto_aov(kCryptoMaterial, "Cryptomatte of materials."));
  rows.push_back(
      crypto_aov(kCryptoElement,
                 "Cryptomatte of labels and facade elements (window, door, wall, ...), for meshes "
                 "that distinguish them."));
  return rows;
}

/// The part of the name before NAME; empty for other rows.
std::string_view prefix_of(const AovInfo& row) {
  const std::string_view name = row.name;
  return name.ends_with(kPlaceholder) ? name.substr(0, name.size() - kPlaceholder.size()) : "";
}

}  // namespace

const std::vector<AovInfo>& aovs() {
  static const std::vector<AovInfo> all = table();
  return all;
}

const AovInfo* find_aov(const std::string& name) {
  for (const AovInfo& row : aovs()) {
    const std::string_view prefix = prefix_of(row);
    if (prefix.empty() ? name == row.name : name.starts_with(prefix)) return &row;
  }
  return nullptr;
}

std::vector<std::string> aov_channels(const std::string& name) {
  const AovInfo& row = *find_aov(name);
  std::vector<std::string> channels = row.channels;
  if (!prefix_of(row).empty())
    for (std::string& channel : channels) channel.replace(0, row.name.size(), name);
  return channels;
}

std::string aov_name(const AovInfo& row, const std::string& name) {
  return std::string(prefix_of(row)) + name;
}

std::string name_in_aov(const std::string& aov) {
  return aov.substr(prefix_of(*find_aov(aov)).size());
}

bool is_from(const std::string& aov, AovSource source) {
  const AovInfo* row = find_aov(aov);
  return row && row->source == source;
}

}  // namespace vug::render
