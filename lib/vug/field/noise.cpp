#include <vug/base/parallel.h>
#include <vug/field/noise.h>

#include <fmt/format.h>

namespace vug::field {

#define VUG_KIND(name) &name##_kind(),
const std::vector<const NoiseKind*>& noises() {
  static const std::vector<const NoiseKind*> kinds = {
#include <vug/field/noise_kinds.inc>
  };
  return kinds;
}
#undef VUG_KIND

Noise make_noise(const std::string& kind,
                 const std::vector<std::pair<std::string, Value>>& params) {
  const NoiseKind* found = find_kind(noises(), kind);
  if (!found) {
    std::vector<std::string> names;
    for (const NoiseKind* k : noises()) names.push_back(k->info.name);
    throw Error(ErrorCode::bad_input, fmt::format("there is no noise '{}'", kind), {},
                suggestion(kind, names));
  }
  Arguments arguments;
  for (const auto& [name, value] : params) arguments.push_back({name, value, {}});
  Diagnostics diagnostics;
  std::optional<Noise> noise = found->make(arguments, {}, diagnostics);
  if (noise) return *noise;
  std::string message;
  for (const Diagnostic& d : diagnostics.all())
    message += (message.empty() ? "" : "; ") + d.message;
  throw Error(ErrorCode::bad_input, message);
}

std::optional<Noise> default_noise(const std::string& kind) {
  const NoiseKind* found = find_kind(noises(), kind);
  if (!found) return std::nullopt;
  Diagnostics diagnostics;
  return found->make({}, {}, diagnostics);
}

Noise::Noise() : Noise(*default_noise("fbm")) {}

std::vector<float> sample(const Field& field, const std::vector<Vec3f>& points) {
  constexpr size_t kPacks = 64, kChunk = kPacks * Pack::kLanes;
  std::vector<float> out(points.size());
  parallel_for((points.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    thread_local Scratch scratch;
    Point<Pack> in[kPacks];
    Pack values[kPacks];
    const size_t first = chunk * kChunk, count = std::min(kChunk, points.size() - first);
    const size_t packs = (count + Pack::kLanes - 1) / Pack::kLanes;
    for (size_t k = 0; k < packs; ++k) {
      float lanes[3][Pack::kLanes];
      for (size_t lane = 0; lane < Pack::kLanes; ++lane) {
        const Vec3f& p = points[first + std::min(k * Pack::kLanes + lane, count - 1)];
        for (int axis = 0; axis < 3; ++axis) lanes[axis][lane] = p[axis];
      }
      in[k] = {Pack::load(lanes[0]), Pack::load(lanes[1]), Pack::load(lanes[2])};
    }
    field.values(in, static_cast<int>(packs), values, scratch);
    for (size_t k = 0; k < packs; ++k) {
      float lanes[Pack::kLanes];
      values[k].store(lanes);
      for (size_t lane = 0; lane < Pack::kLanes && k * Pack::kLanes + lane < count; ++lane)
        out[first + k * Pack::kLanes + lane] = lanes[lane];
    }
  });
  return out;
}

}  // namespace vug::field
