// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/load.h>
#include <vug/scout/lamps.h>

#include <fmt/format.h>

namespace vug::scout {
namespace {

/// A lamp of the kit in a role.
struct Product {
  LampRole role;
  const char* name;     ///< In texts.
  const char* lamp;     ///< A function of data/kit/lamps.vug.
  bool aimed;           ///< It takes `towards`.
  const char* options;  ///< Further arguments.
  double most;          ///< Lumens of the strongest usual product.
};
constexpr Product kProducts[] = {
    {LampRole::key, "key", "led_panel", true, ", temperature: 4000K", 20000},
    {LampRole::rim, "rim", "led_panel", true, ", temperature: 6500K", 20000},
    {LampRole::glow, "glow", "bulb", false, ", temperature: 7500K", 10000},
    {LampRole::lantern, "lantern", "lantern", false, "", 2000}};

const Product& product(LampRole role) { return kProducts[static_cast<size_t>(role)]; }

}  // namespace

std::string role_name(LampRole role) { return product(role).name; }

double most_lumens(LampRole role) { return product(role).most; }

std::string lamp_call(const Lamp& lamp, const std::string& module) {
  const Product& of = product(lamp.role);
  return fmt::format("{}.{}({}{}, level: {:.6g}{})", module, of.lamp, point_text(lamp.at),
                     of.aimed ? ", towards: " + point_text(lamp.towards) : "", lamp.lumen,
                     of.options);
}

std::vector<render::LightPtr> lights_of(const std::vector<Lamp>& lamps,
                                        const std::vector<std::filesystem::path>& data_folders) {
  std::string text = "include \"kit/lamps.vug\" as lamps\n";
  for (size_t i = 0; i < lamps.size(); ++i)
    text += fmt::format("light lamp{} = {}\n", i, lamp_call(lamps[i], "lamps"));
  loading::LoadOptions options;
  options.include_folders = data_folders;
  const loading::Loaded loaded = loading::load_text(text, "lamps of the scout", options);
  if (!loaded.usable())
    throw Error(ErrorCode::bad_input, loaded.diagnostics.all().front().message, {},
                "kit/lamps.vug belongs to the data of Vug; $VUG_DATA names their folder");
  std::vector<render::LightPtr> lights;
  for (const auto& [name, light] : loaded.shot.lights) lights.push_back(light);
  return lights;
}

}  // namespace vug::scout
