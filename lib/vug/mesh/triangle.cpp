// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/triangle.h>

namespace vug::mesh {

NearestOnTriangle nearest_on_triangle(const Vec3d& p, const std::array<Vec3d, 3>& triangle) {
  const Vec3d& a = triangle[0];
  const Vec3d ab = triangle[1] - a;
  const Vec3d ac = triangle[2] - a;
  // Projections of p, relative to each corner, onto the two edges that leave a.
  const Vec3d from_a = p - a;
  const double a1 = ab.dot(from_a);
  const double a2 = ac.dot(from_a);
  if (a1 <= 0 && a2 <= 0) return {a, 0};
  const Vec3d from_b = p - triangle[1];
  const double b1 = ab.dot(from_b);
  const double b2 = ac.dot(from_b);
  if (b1 >= 0 && b2 <= b1) return {triangle[1], 1};
  const Vec3d from_c = p - triangle[2];
  const double c1 = ab.dot(from_c);
  const double c2 = ac.dot(from_c);
  if (c2 >= 0 && c1 <= c2) return {triangle[2], 2};
  // Barycentric coordinates times twice the squared area; none is positive outside its edge.
  const double of_c = a1 * b2 - b1 * a2;
  if (of_c <= 0 && a1 >= 0 && b1 <= 0) return {a + ab * (a1 / (a1 - b1)), 3};
  const double of_b = c1 * a2 - a1 * c2;
  if (of_b <= 0 && a2 >= 0 && c2 <= 0) return {a + ac * (a2 / (a2 - c2)), 5};
  const double of_a = b1 * c2 - c1 * b2;
  const double along_b = b2 - b1;
  const double along_c = c1 - c2;
  if (of_a <= 0 && along_b >= 0 && along_c >= 0)
    return {triangle[1] + (triangle[2] - triangle[1]) * (along_b / (along_b + along_c)), 4};
  const double sum = of_a + of_b + of_c;
  return {a + ab * (of_b / sum) + ac * (of_c / sum), 6};
}

}  // namespace vug::mesh
