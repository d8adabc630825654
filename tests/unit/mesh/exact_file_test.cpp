// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/mesh/exact_file.h>

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace vug::mesh {
namespace {

Mesh sample_mesh() {
  const float tiny = std::numeric_limits<float>::denorm_min();
  return {{{0, 0, 0}, {1, -0.0f, tiny}, {0.1f, 1e30f, 3}},
          {{0, 1, 2}, {2, 1, 0}},
          {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
          {{"Cd", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, {"w_lime stone", 1, {0, 0.5f, 1}}}};
}

std::string to_bytes(const Mesh& mesh) {
  std::ostringstream out(std::ios::binary);
  write_exact(out, mesh);
  return out.str();
}

TEST(ExactFile, ReturnsTheSameMesh) {
  for (const Mesh& mesh : {sample_mesh(), Mesh()}) {
    std::istringstream in(to_bytes(mesh), std::ios::binary);
    const Mesh read = read_exact_mesh(in);
    EXPECT_EQ(read, mesh);
    EXPECT_EQ(digest(read), digest(mesh));
  }
}

TEST(ExactFile, RefusesEveryTruncation) {
  const std::string whole = to_bytes(sample_mesh());
  for (size_t size = 0; size < whole.size(); ++size) {
    std::istringstream in(whole.substr(0, size), std::ios::binary);
    EXPECT_THROW(read_exact_mesh(in), Error) << size;
  }
}

// A damaged number of elements must not allocate memory for them.
TEST(ExactFile, RefusesImpossibleLengths) {
  std::string bytes = to_bytes(sample_mesh());
  bytes[7] = '\x7f';
  std::istringstream in(bytes, std::ios::binary);
  EXPECT_THROW(read_exact_mesh(in), Error);
}

}  // namespace
}  // namespace vug::mesh
