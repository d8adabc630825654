// SPDX-License-Identifier: Apache-2.0
#include <vug/sgm/bond.h>

#include <cctype>
#include <cmath>

namespace vug::sgm {
namespace {

constexpr const char* kNames[] = {"-X", "+X", "-Y", "+Y", "-Z", "+Z", "random"};

}  // namespace

std::string to_string(Label label) { return kNames[static_cast<size_t>(label)]; }

std::vector<std::string> label_names() { return {std::begin(kNames), std::end(kNames)}; }

std::optional<Label> label_from(const std::string& text) {
  const auto same = [&](const std::string& name) {
    if (name.size() != text.size()) return false;
    for (size_t i = 0; i < name.size(); ++i)
      if (std::tolower(static_cast<unsigned char>(name[i])) !=
          std::tolower(static_cast<unsigned char>(text[i])))
        return false;
    return true;
  };
  for (size_t i = 0; i < std::size(kNames); ++i)
    if (same(kNames[i])) return static_cast<Label>(i);
  return std::nullopt;
}

Vec3d direction(Label side) {
  Vec3d out(0);
  const int index = static_cast<int>(side);
  out[index / 2] = index % 2 == 0 ? -1 : 1;
  return out;
}

Label opposite(Label side) {
  return side == Label::random ? side : static_cast<Label>(static_cast<int>(side) ^ 1);
}

Label sample_side(Label label, RandomKey key) {
  return label == Label::random ? static_cast<Label>(RandomStream(key).below(6)) : label;
}

bool on_side(const Bond& bond, Label side) {
  if (bond.free_direction()) return true;
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(bond.direction[i]) > std::fabs(bond.direction[axis])) axis = i;
  return static_cast<int>(side) == 2 * axis + (bond.direction[axis] > 0 ? 1 : 0);
}

bool makes_label(const Bond& a, const Bond& b, double size, double tolerance) {
  if (!((a.point - b.point).length() <= tolerance * size)) return false;
  return a.free_direction() || b.free_direction() ||
         (a.direction + b.direction).length() <= tolerance;
}

}  // namespace vug::sgm
