// SPDX-License-Identifier: Apache-2.0
// The geometric meaning of parameters, for handles in a picture. It follows from the schema, so
// that kinds of plugins have handles, too.
#pragma once

#include <vug/base/schema.h>

#include <optional>
#include <string>

namespace vug::language {

enum class HandleRole {
  point,      ///< A position, or a displacement from the origin.
  direction,  ///< Its length has no meaning.
  extent,     ///< A size along each of the axes.
  length      ///< A radius, height, width, ...
};

/// The role of a parameter of a kind of that category (of a declaration: its keyword); nothing for
/// parameters that have no place in the scene.
std::optional<HandleRole> handle_role(const ParamInfo& param, const std::string& category);

/// The share of an extent between the middle and the surface: 0.5 for sizes, 1 for radii.
double extent_share(const ParamInfo& param);

/// The axis along which a length is shown: 0 to 2 for x, y and z.
int length_axis(const ParamInfo& param);

}  // namespace vug::language
