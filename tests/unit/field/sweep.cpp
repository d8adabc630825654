// SPDX-License-Identifier: Apache-2.0
#include "sweep.h"

#include "fixtures.h"

#include <vug/field/affine.h>
#include <vug/field/blend.h>
#include <vug/field/material_pair_kind.h>
#include <vug/field/noise.h>
#include <vug/field/translated.h>

#include <fmt/format.h>

#include <stdexcept>

namespace vug::field {
namespace {

double draw_number(const ParamInfo& info, RandomStream& random) {
  const double low = std::isfinite(info.min) ? info.min + (info.above_min ? 0.2 : 0.0) : -1.2;
  const double high = std::isfinite(info.max) ? info.max : std::max(low, 0.0) + 1.2;
  return random.uniform(low, high);
}

Field draw_field(RandomStream& random) {
  const Field solid =
      random.uniform() < 0.5
          ? make("sphere", {{"radius", random.uniform(0.3, 0.9)}})
          : make("box", {{"size", Vec3d(random.uniform(0.4, 1.5), random.uniform(0.4, 1.5), 0.8)}});
  return transformed(solid, Transform::translation(random_point(random, 0.5)) *
                                Transform::rotation({1, 2, 3}, random.uniform(0, 3)));
}

/// The same values with two materials, which the kinds of some operators need.
Field with_rocks(const Field& field) {
  const Field chert = make("made_of", {{"field", as_value(make("half_space"))}, {"of", "chert"}});
  return make("host_rock", {{"field", as_value(field)},
                            {"of", "limestone"},
                            {"bodies", List{as_value(chert)}},
                            {"contact", 0.4}});
}

/// Nothing if such a value cannot be generated.
Value draw(const std::string& type, const ParamInfo& info, const std::string& kind,
           RandomStream& random) {
  if (const size_t either = type.find(" or ");
      type != "true or false" && either != std::string::npos)
    return draw(random.uniform() < 0.5 ? type.substr(0, either) : type.substr(either + 4), info,
                kind, random);
  if (type.rfind("list of ", 0) == 0) {
    List list;
    for (int i = 0; i < 3; ++i) {
      Value item = draw(type.substr(8), info, kind, random);
      if (item.empty()) return {};
      list.push_back(std::move(item));
    }
    return list;
  }
  if (type == "number") return Number{draw_number(info, random), info.dimension};
  if (type == "whole number") return std::floor(draw_number(info, random));
  if (type == "vector")
    return Value::Vector{
        {draw_number(info, random), draw_number(info, random), draw_number(info, random)},
        info.dimension};
  if (type == "true or false") return Value(random.uniform() < 0.5);
  if (type == "name")
    return Value::Name{info.choices[random.below(static_cast<uint32_t>(info.choices.size()))]};
  if (type == "field") return as_value(with_rocks(draw_field(random)));
  if (type == "blend") {
    const Profile profiles[] = {Profile::smooth, Profile::round, Profile::chamfer};
    return Object{"blend", Blend{profiles[random.below(3)], random.uniform(0.05, 0.5)}};
  }
  if (type == "noise")
    return Value::Name{noises()[random.below(static_cast<uint32_t>(noises().size()))]->info.name};
  if (type == "material pair")
    return Object{"material pair",
                  MaterialPair{{random.uniform() < 0.5 ? "chert" : "limestone", "limestone"},
                               random.uniform(0.05, 0.5)}};
  if (type == "rock material") return std::string(random.uniform() < 0.5 ? "chert" : "limestone");
  if (type == "file") return fixture_file(kind);
  return {};
}

std::optional<SweepCase> random_case(const FieldKind& kind, RandomStream& random, bool defaults) {
  const Arguments arguments = draw_arguments(kind.info, random, defaults);
  std::string label = kind.info.name + "(";
  for (const Argument& each : arguments)
    label +=
        fmt::format(" {}: {}", each.name, each.value.get<Object>() ? "..." : to_string(each.value));
  Diagnostics diagnostics;
  std::optional<Field> field = kind.make(arguments, {}, diagnostics);
  if (!field) return std::nullopt;  // Incompatible parameters: draw again.
  return SweepCase{label + " )", *field};
}

}  // namespace

Value draw_value(const ParamInfo& info, const std::string& kind, RandomStream& random) {
  return draw(info.type, info, kind, random);
}

Arguments draw_arguments(const KindInfo& kind, RandomStream& random, bool defaults) {
  Arguments arguments;
  for (const ParamInfo& info : kind.params) {
    if (!info.required && (defaults || random.uniform() < 0.25)) continue;
    Value value = draw(info.type, info, kind.name, random);
    if (value.empty()) {
      if (!info.required) continue;
      throw std::runtime_error("sweep.cpp cannot draw a " + info.type + " for " + kind.name);
    }
    arguments.push_back({info.name, std::move(value), {}});
  }
  return arguments;
}

std::vector<SweepCase> sweep_cases(const FieldKind& kind, int count) {
  RandomStream random(RandomKey(7).at(kind.info.name));
  std::vector<SweepCase> cases;
  for (int attempt = 0; attempt < 100 * (count + 1); ++attempt) {
    if (static_cast<int>(cases.size()) == count + 1) return cases;
    auto next = random_case(kind, random, cases.empty());
    if (next) cases.push_back(std::move(*next));
  }
  throw std::runtime_error("too few random parameters fit together for " + kind.info.name);
}

const std::vector<SweepCase>& all_sweep_cases() {
  static const std::vector<SweepCase> cases = [] {
    std::vector<SweepCase> all;
    for (const FieldKind* kind : field_kinds()) {
      for (SweepCase& c : sweep_cases(*kind)) all.push_back(std::move(c));
      const SweepCase& last = all.back();
      all.push_back({last.label + ", translated", translated(last.field, {0.3, -0.2, 0.25})});
    }
    return all;
  }();
  return cases;
}

Vec3d random_point(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

Vec3d random_point(RandomStream& random, const Ball& ball) {
  for (;;) {
    const Vec3d p = random_point(random, 1);
    if (p.length2() <= 1) return ball.centre + p * ball.radius;
  }
}

Box3d probe_box(const Field& field) {
  const Box3d reach(Vec3d(-3), Vec3d(3)), box = intersection(field.bounds(), reach);
  return box.isEmpty() ? reach : box;
}

}  // namespace vug::field
