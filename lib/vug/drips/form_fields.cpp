// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/drips/form_fields.h>
#include <vug/drips/growth.h>
#include <vug/field/affine.h>
#include <vug/field/displace.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/turned.h>

#include <algorithm>
#include <cmath>

namespace vug::drips {
namespace {

/// The depth of flutes over their width, and the radius over that of the trunk below which they
/// fade out.
constexpr double kFluteDepth = 0.09, kFluteCore = 0.8;
/// The layers of standing forms are uneven, because the drip wanders and its water runs
/// down in threads. Width and height of the lumps, and by how far they stand out, in radii (our
/// choice, from photographs); the finest lumps are not smaller than this number of tips.
constexpr double kLumpWidth = 2.4, kLumpHeight = 0.8, kLumps = 0.24, kLumpGain = 0.7,
                 kFinestLump = 2.2;
constexpr int kMostLumpOctaves = 4;

/// A function of the drip alone, so that it stays in place while the form grows.
field::Field lumpy(const field::Field& turned, const Form& form, double tip, RandomKey key) {
  const double height = kLumpHeight * form.radius;
  int octaves = 0;
  while (octaves < kMostLumpOctaves && height >= std::ldexp(kFinestLump * tip, octaves)) ++octaves;
  if (octaves == 0) return turned;
  RandomStream random(key.at("lumps"));
  const Vec3d scale(kLumpWidth * form.radius, height, kLumpWidth * form.radius);
  const field::Noise noise =
      field::make_noise("fbm", {{"scale", scale},
                                {"octaves", static_cast<double>(octaves)},
                                {"gain", kLumpGain},
                                {"seed", static_cast<double>(random.below(1u << 20))}});
  field::Displacement lumps;
  lumps.amount = kLumps * form.radius * form.cover;
  return field::displaced(turned, noise, lumps);
}

field::Field uneven(field::Field turned, const Form& form, const Vec3d& foot, double tip,
                    RandomKey key) {
  const double height = form.top.y - form.bottom.y;
  if (form.flutes > 0 && form.ribs > 0) {
    const double radius = form.cover * (form.radius + 0.7 * form.coat);
    turned = field::fluted(turned,
                           {.count = form.flutes,
                            .depth = form.ribs * kFluteDepth * 2 * kPi * radius / form.flutes,
                            .radius = kFluteCore * radius},
                           key);
  }
  if (form.kind == FormKind::stalagmite || form.kind == FormKind::column)
    turned = lumpy(turned, form, tip, key);
  if (form.kind == FormKind::stalagmite)
    return field::bent(turned, {field::BendProfile::foot, foot, 0, height});
  if (form.kind != FormKind::column) return turned;
  const double reach = std::max(2 * form.radius, 0.15 * height), waist = form.waist * height;
  const Vec3d offset(form.offset * maths::cos(form.heading), 0,
                     form.offset * maths::sin(form.heading));
  return field::bent(turned,
                     {field::BendProfile::joint, offset, waist - reach, waist + 0.5 * reach});
}

}  // namespace

field::Field form_field(const Form& form, const FormOptions& o,
                        const field::StalactiteCurve& curve) {
  constexpr const char* kKinds[] = {"soda_straw", "stalactite", "stalagmite", "column", "piece"};
  const field::Field turned =
      field::lathe(kKinds[static_cast<int>(form.kind)], outline_of(form, o, curve));
  const RandomKey key = RandomKey(o.seed).at("flutes").at(static_cast<uint64_t>(form.drip));
  // A stalagmite is plumb below its drop, and only its foot is aside.
  const bool stands = form.kind == FormKind::stalagmite;
  Vec3d aside = form.bottom - form.top;
  aside.y = 0;
  const Vec3d axis = stands ? Vec3d(0, 1, 0) : (form.top - form.bottom).normalized();
  const Transform placed = Transform::translation(stands ? form.bottom - aside : form.bottom) *
                           rotation_between(Vec3d(0, 1, 0), axis);
  return field::transformed(uneven(turned, form, aside, o.tip, key), placed);
}

std::vector<field::Field> form_fields(const std::vector<Form>& forms, const FormOptions& o) {
  const field::StalactiteCurve curve = common_curve(o.girth);
  std::vector<field::Field> fields(forms.size());
  parallel_for(fields.size(), [&](size_t i) { fields[i] = form_field(forms[i], o, curve); });
  return fields;
}

}  // namespace vug::drips
