// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/render/geometry/instance_transform.h>

#include <algorithm>
#include <cmath>

namespace vug::render {

InstanceTransform::InstanceTransform(const std::vector<Transform>& transforms) {
  if (transforms.empty())
    throw Error(ErrorCode::bad_input, "an instance needs at least one transform");
  for (const Transform& transform : transforms) {
    keyframes_.emplace_back(transform);
    error_scale_ = std::max(error_scale_,
                            static_cast<float>(transform.max_stretch() / transform.min_stretch()));
    const Vec3d& o = transform.origin();
    const double far = std::max(std::fabs(o.x), std::max(std::fabs(o.y), std::fabs(o.z)));
    origin_extent_ = std::max(origin_extent_, static_cast<float>(far));
  }
  const Transform& middle = transforms[transforms.size() / 2];
  inverse_ = middle.inverse();
  mean_scale_ = static_cast<float>(maths::pow(std::fabs(middle.determinant()), 1.0 / 3));
}

Transform InstanceTransform::inverse(float time) const {
  if (!moves()) return inverse_;
  const Affine now = interpolate(time);
  return Transform(Vec3d(now.x), Vec3d(now.y), Vec3d(now.z), Vec3d(now.origin)).inverse();
}

Affine InstanceTransform::interpolate(float time) const {
  const float last = static_cast<float>(keyframes_.size() - 1);
  const float position = std::clamp(time, 0.0f, 1.0f) * last;
  const float first = std::min(std::floor(position), last - 1);
  const Affine& a = keyframes_[static_cast<size_t>(first)];
  const Affine& b = keyframes_[static_cast<size_t>(first) + 1];
  const float share = position - first, rest = 1 - share;
  Affine mix;
  mix.x = a.x * rest + b.x * share, mix.y = a.y * rest + b.y * share;
  mix.z = a.z * rest + b.z * share, mix.origin = a.origin * rest + b.origin * share;
  return mix;
}

}  // namespace vug::render
