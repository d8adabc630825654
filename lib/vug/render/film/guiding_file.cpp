// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/render/film/guiding_file.h>
#include <vug/render/film/partial_render_header.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace vug::render {
namespace {

constexpr char kGuidingMagic[8] = {'v', 'u', 'g', 'g', 'u', 'i', 'd', '\n'};
constexpr uint32_t kGuidingVersion = 1;

template <class File, class Portal>
void portal(File& file, Portal& p) {
  Vec3d up = p.up.value_or(Vec3d(0, 0, 1));
  for (auto* vector : {&p.center, &p.normal}) file.number(*vector);
  file.number(up), file.number(p.width), file.number(p.height);
  if constexpr (File::kReads) p.up = up;
}

template <class File, class Light>
void learned_of(File& file, Light& light) {
  list(file, light.portals, sizeof(Vec3d), [&](auto& each) { portal(file, each); });
  uint8_t learned = light.guiding ? 1 : 0;
  file.number(learned);
  if (learned == 0) return;
  if constexpr (File::kReads) {
    auto guiding = std::make_shared<GuidingData>();
    value_of(file, *guiding);
    if (!guiding->is_consistent()) file.refuse("its content was changed");
    light.guiding = std::move(guiding);
  } else {
    value_of(file, *light.guiding);
  }
}

PartialRenderHeader read_header(HashedReader& file) {
  char magic[sizeof kGuidingMagic];
  uint32_t version = 0;
  file.bytes(magic, sizeof magic);
  if (std::memcmp(magic, kGuidingMagic, sizeof magic) != 0) file.refuse("it is not a guiding file");
  file.number(version);
  if (version != kGuidingVersion)
    file.refuse(fmt::format("its version is {}, this program reads {}", version, kGuidingVersion));
  PartialRenderHeader header;
  header_of(file, header);
  return header;
}

}  // namespace

void write_guiding(const std::filesystem::path& path, const PartialRenderHeader& picture,
                   const LearnedLight& light) {
  AtomicFile target(path);
  HashedWriter file(target.path());
  file.bytes(kGuidingMagic, sizeof kGuidingMagic);
  file.number(kGuidingVersion);
  header_of(file, picture);
  learned_of(file, light);
  if (!file.finish())
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
  target.commit();
}

LearnedLightPtr read_guiding(const std::filesystem::path& path,
                             const PartialRenderHeader& picture) {
  HashedReader file(path, "guiding file");
  if (const std::string what = difference(read_header(file), picture); !what.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("the guiding file '{}' belongs to another picture: different {}",
                            path.string(), what),
                {}, "remove it, or give another name, to learn the light again");
  auto light = std::make_shared<LearnedLight>();
  learned_of(file, *light);
  file.finish();
  return light;
}

PartialRenderHeader read_guiding_header(const std::filesystem::path& path) {
  HashedReader file(path, "guiding file");
  PartialRenderHeader header = read_header(file);
  file.skip();
  file.finish();
  return header;
}

bool is_guiding(const std::filesystem::path& path) {
  if (!unreadable_reason(path).empty()) return false;
  char magic[sizeof kGuidingMagic] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return std::memcmp(magic, kGuidingMagic, sizeof magic) == 0;
}

}  // namespace vug::render
