// SPDX-License-Identifier: Apache-2.0
// The parameters that a vault and the blocks below it share.
#pragma once

#include <vug/field/kind.h>
#include <vug/passages/breakdown/vault.h>

#include <optional>

namespace vug::shot {

struct VaultParams {
  Vec3d at{0.0};
  double span = passages::VaultOptions().span;
  double length = 0;
  double bed = passages::VaultOptions().bed;
  double spacing = passages::VaultOptions().spacing;
  double strength = passages::VaultOptions().strength;
  double azimuth = passages::VaultOptions().azimuth;
  Vec3d bedding{0, 1, 0};
  int seed = 0;
  std::optional<field::Field> rock = {};

  passages::Vault vault() const;
};

template <class P>
void describe_vault(Schema<P>& s) {
  s.param("at", &P::at,
          {.doc = "the middle of the roof before the fall",
           .dimension = Dimension::length,
           .required = true})
      .param("span", &P::span, positive_length("of the roof before the fall"))
      .param("length", &P::length,
             {.doc = "of the roof along the chamber; by default the span",
              .dimension = Dimension::length,
              .min = 0})
      .param("bed", &P::bed, positive_length("thickness of the beds, on average"))
      .param("spacing", &P::spacing, positive_length("distance between joints, on average"))
      .param("strength", &P::strength,
             {.doc = "bending strength of the rock in MPa; 2 to 10 for limestone without joints",
              .min = 0,
              .above_min = true})
      .param("azimuth", &P::azimuth,
             {.doc = "direction of the span and of one set of joints, from x to z",
              .dimension = Dimension::angle})
      .param("bedding", &P::bedding, {.doc = "direction across the beds"})
      .param("seed", &P::seed, {.doc = "of beds, joints and blocks", .min = 0})
      .param(
          "rock", &P::rock,
          {.doc = "a solid with materials: the strength of each bed is divided by 1 - hardness"});
}

}  // namespace vug::shot
