// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/assembly.h>
#include <vug/exchange/channels.h>

#include <vug/mesh/mesh.h>

namespace vug::exchange {

Look blend(const Look& a, const Look& b, double share) {
  const auto mix = [&](const auto& x, const auto& y) { return x * (1 - share) + y * share; };
  Look out;
  out.base_color = mix(a.base_color, b.base_color);
  out.roughness = mix(a.roughness, b.roughness);
  out.specular = mix(a.specular, b.specular);
  out.ior = mix(a.ior, b.ior);
  out.metallic = mix(a.metallic, b.metallic);
  out.transmission = mix(a.transmission, b.transmission);
  out.through = mix(a.through, b.through);
  out.subsurface = mix(a.subsurface, b.subsurface);
  out.wetness = mix(a.wetness, b.wetness);
  out.coat_roughness = mix(a.coat_roughness, b.coat_roughness);
  out.opacity = mix(a.opacity, b.opacity);
  out.emission = mix(a.emission, b.emission);
  out.thin = (share < 0.5 ? a : b).thin;
  return out;
}

Prototype of_rock(const Prototype& prototype, const RockLook& rock) {
  Prototype out = prototype;
  out.material += '_' + rock.rock;
  out.look = rock.look;
  out.rocks.clear();
  return out;
}

const std::vector<Channel>& channels() {
  static const std::vector<Channel> all = {
      {mesh::kColour, nullptr, &Look::base_color},
      {"roughness", &Look::roughness},
      {"wetness", &Look::wetness},
      {"metallic", &Look::metallic},
      {"transmission", &Look::transmission},
      {"opacity", &Look::opacity},
      {"through", nullptr, &Look::through},
      {"emission", nullptr, &Look::emission},
  };
  return all;
}

bool is_color(std::string_view attribute) {
  const auto ends_with = [&](std::string_view end) {
    return attribute.size() >= end.size() && attribute.substr(attribute.size() - end.size()) == end;
  };
  return ends_with("Cd") || ends_with("color") || attribute == "emission" || attribute == "through";
}

}  // namespace vug::exchange
