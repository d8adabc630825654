// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/sky.h>
#include <vug/image/io.h>

#include <fmt/format.h>

namespace vug::exchange {

std::optional<std::filesystem::path> sky_file(const Light& light, const std::filesystem::path& file,
                                              const std::string& name) {
  if (light.shape != Light::Shape::dome || !light.picture) return std::nullopt;
  return file.parent_path() / fmt::format("{}_{}.exr", file.stem().string(), name);
}

std::optional<std::filesystem::path> write_sky(const Light& light,
                                               const std::filesystem::path& file,
                                               const std::string& name) {
  const auto path = sky_file(light, file, name);
  if (path) image::write_exr(*path, *light.picture);
  return path;
}

}  // namespace vug::exchange
