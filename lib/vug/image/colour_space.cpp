// SPDX-License-Identifier: Apache-2.0
#include <vug/image/colour_space.h>

#include <algorithm>
#include <cmath>

namespace vug::image {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;
using Vector3 = std::array<double, 3>;

Vector3 multiply(const Matrix3& m, const Vector3& v) {
  Vector3 out{};
  for (size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Matrix3 multiply(const Matrix3& a, const Matrix3& b) {
  Matrix3 out{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}

/// Inverse by cofactors.
Matrix3 inverse(const Matrix3& m) {
  const auto minor = [&](size_t i, size_t j) {
    const size_t r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[r][c] * m[s][d] - m[r][d] * m[s][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix3 out{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) out[j][i] = minor(i, j) / determinant;
  return out;
}

Vector3 xyz(const Chromaticities& c, size_t which) {
  const double x = c[2 * which], y = c[2 * which + 1];
  return {x / y, 1, (1 - x - y) / y};
}

/// Converts from the primaries to CIE XYZ, with white at luminance 1.
Matrix3 to_xyz(const Chromaticities& c) {
  Matrix3 columns{};
  for (size_t j = 0; j < 3; ++j)
    for (size_t i = 0; i < 3; ++i) columns[i][j] = xyz(c, j)[i];
  const Vector3 shares = multiply(inverse(columns), xyz(c, 3));
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) columns[i][j] *= shares[j];
  return columns;
}

Matrix3 adaptation(const Vector3& from, const Vector3& to) {
  constexpr Matrix3 kBradford = {
      {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const Vector3 a = multiply(kBradford, from), b = multiply(kBradford, to);
  Matrix3 scaled = kBradford;
  for (size_t i = 0; i < 3; ++i)
    for (double& v : scaled[i]) v *= b[i] / a[i];
  return multiply(inverse(kBradford), scaled);
}

bool same(const Chromaticities& a, const Chromaticities& b) {
  constexpr double kSame = 1e-5;  // Precision of 32-bit headers.
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::fabs(x - y) < kSame; });
}

}  // namespace

const std::vector<WorkingSpaceInfo>& working_spaces() {
  static const std::vector<WorkingSpaceInfo> all = {
      {WorkingSpace::rec709,
       "rec709",
       "lin_rec709_scene",
       {"lin_rec709_scene", "lin_rec709", "lin_srgb", "Linear Rec.709 (sRGB)", "Linear Rec.709",
        "Utility - Linear - sRGB", "Utility - Linear - Rec.709", "Linear",
        "scene-linear Rec.709-sRGB"},
       {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290}},
      {WorkingSpace::acescg,
       "acescg",
       "lin_ap1_scene",
       {"lin_ap1_scene", "ACEScg", "lin_ap1", "ACES - ACEScg"},
       {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767}},
  };
  return all;
}

const WorkingSpaceInfo& info(WorkingSpace space) {
  return working_spaces()[static_cast<size_t>(space)];
}

std::optional<WorkingSpace> find_space(const Chromaticities& chromaticities) {
  for (const WorkingSpaceInfo& each : working_spaces())
    if (same(each.chromaticities, chromaticities)) return each.space;
  return std::nullopt;
}

ColourMatrix::ColourMatrix(const Chromaticities& from, const Chromaticities& to) {
  is_identity_ = same(from, to);
  if (is_identity_) return;
  rows_ =
      multiply(inverse(to_xyz(to)), multiply(adaptation(xyz(from, 3), xyz(to, 3)), to_xyz(from)));
}

ColourMatrix::ColourMatrix(WorkingSpace from, WorkingSpace to)
    : ColourMatrix(info(from).chromaticities, info(to).chromaticities) {}

}  // namespace vug::image
