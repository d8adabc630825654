// Noise: a scalar function of space with bounds, for displacement, warping and colour.
#pragma once

#include <vug/field/kind.h>

namespace vug::field {

constexpr const char* kDefaultNoise = "fbm";

/// Values without a unit, about -1..1; `field` evaluates it (points in metres) and knows its
/// Lipschitz constant per metre. By default: fbm with its defaults.
struct Noise {
  Noise();
  Noise(Field values, Interval bounds) : field(std::move(values)), range(bounds) {}

  Field field;
  Interval range;           ///< Holds every value.
  bool is_default = false;  ///< Whether it is the one by default.
};

using NoiseKind = Kind<Noise>;

/// Makers of noise: perlin, fbm, worley, ...
const Kinds<Noise>& noises();
/// By kind name and named values; Error(bad_input) as make() of fields.
Noise make_noise(const std::string& kind, const NamedValues& params = {});
/// The noise of that kind with its defaults; nothing when there is no such kind.
std::optional<Noise> default_noise(const std::string& kind);

/// Values at points, e.g. to colour the vertices of a mesh; 8 at a time, in parallel.
std::vector<float> sample(const Field& field, const std::vector<Vec3f>& points);

inline Value as_value(const Noise& noise);

}  // namespace vug::field

/// Opens the one definition that a file in noise/ exports; see VUG_FIELD_KIND.
#define VUG_NOISE_KIND(name) VUG_EXPORT_KIND(vug::field, NoiseKind, name##_kind)

namespace vug {

/// A noise, or a kind's bare name for its defaults: `noise: ridged`.
template <>
struct ValueTraits<field::Noise> : ObjectTraits<field::Noise> {
  static constexpr const char* kWord = "noise";
  static std::optional<field::Noise> read(const Value& v) {
    if (const auto* n = v.object<field::Noise>()) return *n;
    const auto* name = v.get<Value::Name>();
    return name ? field::default_noise(name->text) : std::nullopt;
  }
  static Value write(const field::Noise& noise) {
    if (noise.is_default) return Value::Name{field::kDefaultNoise};
    return ObjectTraits::write(noise);
  }
};

inline Value field::as_value(const Noise& noise) { return ValueTraits<Noise>::write(noise); }

}  // namespace vug
