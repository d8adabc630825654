// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/material_source.h>
#include <vug/passages/breakdown/vault.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

constexpr double kGravity = 9.81;
constexpr double kBedSpread = 0.3;    // Standard deviation of the logarithm of a thickness.
constexpr double kJointSpread = 0.4;  // Of the distance between joints.
constexpr double kJoin = 0.02;        // Metres by which places of blocks overlap.
constexpr size_t kMostBlocks = 20000;
constexpr int kMostBeds = 1000;
constexpr double kFarthest = 1e7;  // Metres; cells of blocks are counted with int.

void require_vault_options(const VaultOptions& o) {
  const auto check = [](const char* name, double value, double min, double max) {
    if (!(value >= min && value <= max))
      throw Error(
          ErrorCode::bad_input,
          fmt::format("invalid {} {:g} of a vault: must be {:g} to {:g}", name, value, min, max),
          {}, "give lengths in metres and strengths in MPa");
  };
  check("span", o.span, 0.5, 1000);
  check("length", o.length, 0.5, 1000);
  check("thickness of beds", o.bed, 0.02, 100);
  check("distance between joints", o.spacing, 0.05, 1000);
  check("strength", o.strength, 0.001, 1000);
  check("density", o.density, 500, 10000);
  check("azimuth", o.azimuth, -1e4, 1e4);
  if (!(o.bedding.length() > 1e-9 && std::isfinite(o.bedding.length())) ||
      !(std::fabs(o.bedding.y) > 0.5 * o.bedding.length()))
    throw Error(ErrorCode::bad_input, "the beds of a vault dip by more than 60 degrees", {},
                "give a direction across the beds that is less than 60 degrees from the vertical");
  if (!(o.at.length() <= kFarthest))
    throw Error(ErrorCode::bad_input,
                fmt::format("the position of a vault is not finite, or more than {:g} m away from "
                            "the origin",
                            kFarthest),
                {}, "give a point in metres");
}

/// Joints across [-half, half]: their positions, in ascending order, one beyond each end.
std::vector<double> joints(double half, double spacing, RandomKey key) {
  RandomStream random(key);
  std::vector<double> out{-half - spacing * random.uniform()};
  while (out.back() < half) {
    const double step =
        maths::exp(kJointSpread * random.normal() - 0.5 * kJointSpread * kJointSpread);
    out.push_back(out.back() + spacing * std::clamp(step, 0.35, 3.0));
    if (out.size() > kMostBlocks)
      throw Error(ErrorCode::too_large, "a vault has too many joints", {},
                  "use a larger distance between joints");
  }
  return out;
}

/// The bending strength of a bed at a point, MPa; infinite for hardness 1.
double strength_at(const VaultOptions& o, const Vec3d& p) {
  return o.rock ? o.strength / (1 - field::hardness_at(*o.rock, p)) : o.strength;
}

}  // namespace

double Vault::volume() const {
  double sum = 0;
  for (const OrientedBox& block : blocks) sum += block.volume();
  return sum;
}

double Vault::largest() const {
  double out = 0;
  for (const OrientedBox& block : blocks) out = std::max(out, 2 * block.half.length());
  return out;
}

double bridged_span(double thickness, double strength, double density) {
  return std::sqrt(2 * strength * 1e6 * thickness / (density * kGravity));
}

double ledge_length(double thickness, double strength, double density) {
  return std::sqrt(strength * 1e6 * thickness / (3 * density * kGravity));
}

Vault vault(const VaultOptions& o) {
  require_vault_options(o);
  const RandomKey key = RandomKey(o.seed).at("vault");
  const Vec3d up = (o.bedding.y > 0 ? o.bedding : -o.bedding).normalized();
  const Vec3d along(maths::cos(o.azimuth), 0, maths::sin(o.azimuth));
  const Vec3d u = (along - up * along.dot(up)).normalized(), v = u.cross(up);
  const std::vector<double> across_u = joints(0.5 * o.span, o.spacing, key.at("u"));
  const std::vector<double> across_v = joints(0.5 * o.length, o.spacing, key.at("v"));
  RandomStream random(key.at("beds"));
  Vault out;
  double span = o.span, length = o.length, height = 0;
  for (int bed = 0; bed < kMostBeds; ++bed) {
    const double spread = maths::exp(kBedSpread * random.normal() - 0.5 * kBedSpread * kBedSpread);
    const double thickness = o.bed * std::clamp(spread, 0.4, 2.5);
    const double strength = strength_at(o, o.at + up * (height + 0.5 * thickness));
    const double ledge = ledge_length(thickness, strength, o.density);
    const double left = 2 * ledge * random.uniform(0.3, 1);
    if (!(std::min(span, length) > bridged_span(thickness, strength, o.density))) break;
    for (size_t i = 0; i + 1 < across_u.size(); ++i)
      for (size_t j = 0; j + 1 < across_v.size(); ++j) {
        const double x = 0.5 * (across_u[i] + across_u[i + 1]);
        const double z = 0.5 * (across_v[j] + across_v[j + 1]);
        if (!(Vec2d(2 * x / span, 2 * z / length).length2() < 1)) continue;
        out.blocks.push_back({o.at + u * x + up * (height + 0.5 * thickness) + v * z,
                              {0.5 * (across_u[i + 1] - across_u[i]), 0.5 * thickness,
                               0.5 * (across_v[j + 1] - across_v[j])},
                              {u, up, v}});
        if (out.blocks.size() > kMostBlocks)
          throw Error(ErrorCode::too_large,
                      fmt::format("more than {} blocks fall from a vault", kMostBlocks), {},
                      "use a larger distance between joints, thicker beds or stronger rock");
      }
    out.beds.push_back(thickness);
    out.spans.push_back(span);
    height += thickness;
    span -= left;
    length -= left;
    if (!(span > 0 && length > 0)) break;
  }
  return out;
}

field::Field vault_body(const Vault& vault) {
  std::vector<Polytope> parts;
  for (OrientedBox block : vault.blocks) {
    block.half += Vec3d(kJoin);
    parts.push_back(block.polytope());
  }
  return polytopes("vault", std::move(parts));
}

}  // namespace vug::passages
