// SPDX-License-Identifier: Apache-2.0
// Lookups in picture textures, with wrapping and filtering by OpenImageIO's texture cache.
#include <vug/image/backend.h>

#include <OpenImageIO/texture.h>

namespace vug::image::oiio {
namespace {

constexpr float kCacheMegabytes = 1024;

/// The cache of all textures. It is never destroyed: it lives as long as the process, and
/// OpenImageIO 2.4 frees it with a size other than that of its allocation.
OIIO::TextureSystem& textures() {
  static OIIO::TextureSystem* const system = [] {
    OIIO::TextureSystem* const made = OIIO::TextureSystem::create(false);
    // Untiled files are tiled and MIP-mapped in memory.
    made->attribute("autotile", 64);
    made->attribute("automip", 1);
    made->attribute("max_memory_MB", kCacheMegabytes);
    return made;
  }();
  return *system;
}

class Lookup final : public TextureLookup {
 public:
  Lookup(const std::filesystem::path& path, int channels)
      : name_(path.string()), channels_(channels) {}

  bool sample(float s, float t, float width, float* values) const override {
    OIIO::TextureOpt options;
    options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    if (textures().texture(name_, options, s, t, width, 0, 0, width, channels_, values))
      return true;
    (void)textures().geterror();  // OpenImageIO's messages are for programmers.
    return false;
  }

 private:
  OIIO::ustring name_;
  int channels_;
};

}  // namespace

std::shared_ptr<const TextureLookup> texture(const std::filesystem::path& path, int channels) {
  return std::make_shared<const Lookup>(path, channels);
}

}  // namespace vug::image::oiio
