// Noise: a scalar function of space with bounds, for displacement, warping and colour.
#pragma once

#include <vug/field/kind.h>

namespace vug::field {

/// Values without a unit, about -1..1; `field` evaluates it (points in metres) and knows its
/// Lipschitz constant per metre. By default: fbm with its defaults.
struct Noise {
  Noise();
  Noise(Field values, Interval bounds) : field(std::move(values)), range(bounds) {}

  Field field;
  Interval range;  ///< Holds every value.
};

using NoiseKind = Kind<Noise>;

#define VUG_KIND(name) const NoiseKind& name##_kind();
#include <vug/field/noise_kinds.inc>
#undef VUG_KIND

/// Makers of noise: perlin, fbm, worley, ...
const std::vector<const NoiseKind*>& noises();
/// By kind name and named values; Error(bad_input) as make() of fields.
Noise make_noise(const std::string& kind,
                 const std::vector<std::pair<std::string, Value>>& params = {});
/// The noise of that kind with its defaults; nothing when there is no such kind.
std::optional<Noise> default_noise(const std::string& kind);

/// Values at points, e.g. to colour the vertices of a mesh; 8 at a time, in parallel.
std::vector<float> sample(const Field& field, const std::vector<Vec3f>& points);

inline Value as_value(const Noise& noise);

}  // namespace vug::field

/// Opens the one definition that a file in noise/ exports; see VUG_FIELD_KIND.
#define VUG_NOISE_KIND(name)                               \
  static vug::field::NoiseKind make_##name##_kind();       \
  const vug::field::NoiseKind& vug::field::name##_kind() { \
    static const NoiseKind kind = make_##name##_kind();    \
    return kind;                                           \
  }                                                        \
  static vug::field::NoiseKind make_##name##_kind()

namespace vug {

/// A noise, or a kind's bare name for its defaults: `noise: ridged`.
template <>
struct ValueTraits<field::Noise> {
  static std::string type() { return "noise"; }
  static std::optional<field::Noise> read(const Value& v) {
    if (const auto* n = v.object<field::Noise>()) return *n;
    const auto* name = v.get<Value::Name>();
    return name ? field::default_noise(name->text) : std::nullopt;
  }
  static Value write(const field::Noise& n) { return Object{"noise", n}; }
};

inline Value field::as_value(const Noise& noise) { return Object{"noise", noise}; }

}  // namespace vug
