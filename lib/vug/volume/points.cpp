// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/error.h>
#include <vug/volume/points.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::volume {
namespace {

template <class Named>
const Named* find_named(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

template <class Named>
const Named& require_named(const std::vector<Named>& all, const std::string& name,
                           const char* what) {
  if (const Named* found = find_named(all, name)) return *found;
  std::vector<std::string> known;
  for (const Named& each : all) known.push_back(each.name);
  throw Error(ErrorCode::bad_input, fmt::format("the points have no {} '{}'", what, name), {},
              suggestion(name, known));
}

}  // namespace

size_t PointAttribute::size() const {
  return std::visit([](const auto& v) { return v.size(); }, values);
}

const PointAttribute* Points::find(const std::string& name) const {
  return find_named(attributes, name);
}

template <class T>
const std::vector<T>& Points::values(const std::string& name) const {
  constexpr const char* kTypes[] = {"numbers", "vectors", "whole numbers"};
  const PointAttribute& found = require_named(attributes, name, "attribute");
  const auto* same = std::get_if<std::vector<T>>(&found.values);
  if (!same)
    throw Error(ErrorCode::bad_input,
                fmt::format("the attribute '{}' of the points has {}, not {}", name,
                            kTypes[found.values.index()],
                            kTypes[PointAttribute::Values(std::vector<T>()).index()]));
  return *same;
}
template const std::vector<float>& Points::values<float>(const std::string&) const;
template const std::vector<Vec3f>& Points::values<Vec3f>(const std::string&) const;
template const std::vector<int32_t>& Points::values<int32_t>(const std::string&) const;

const std::vector<uint8_t>& Points::members(const std::string& name) const {
  return require_named(groups, name, "group").member;
}

double voxel_for_points(double area_each) {
  // On average, a surface of area A crosses 1.5 A / v^2 voxels of edge v, for any orientation.
  constexpr double kPointsAVoxel = 12;
  return std::sqrt(1.5 * kPointsAVoxel * area_each);
}

Digest digest(const Points& points) {
  Hasher hasher;
  const auto add = [&](const auto& array) {
    hasher.add_value(array.size()).add(array.data(), array.size() * sizeof(array[0]));
  };
  hasher.add("points");
  add(points.position);
  for (const PointAttribute& each : points.attributes) {
    hasher.add(each.name).add_value(each.values.index());
    std::visit(add, each.values);
  }
  for (const PointGroup& each : points.groups) {
    hasher.add(each.name);
    add(each.member);
  }
  return hasher.finish();
}

}  // namespace vug::volume
