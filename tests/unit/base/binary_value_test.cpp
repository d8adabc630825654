// SPDX-License-Identifier: Apache-2.0
// Values return from streams as they were written, and streams that end too early are refused.
#include <vug/base/binary_value.h>
#include <vug/base/vec.h>

#include <gtest/gtest.h>

#include <sstream>

namespace vug {
namespace {

enum class Tint { red, green };

struct Part {
  Vec3d at{0.0};
  bool is_open = false;
  Tint colour = Tint::red;
  bool operator==(const Part&) const = default;
};

struct Tree {
  std::string name{};
  std::optional<double> height{}, age{};
  std::vector<Part> leaves{};
  std::vector<std::vector<Vec2d>> paths{};
  std::vector<std::string> notes{};
  std::vector<int32_t> numbers{};
  bool operator==(const Tree&) const = default;
};

Tree example() {
  return {"oak",
          2.5,
          std::nullopt,
          {{{1, 2, 3}, true, Tint::green}, {{-0.0, 5, 1e-300}, false, Tint::red}},
          {{}, {{1, 2}, {3, 4}}},
          {"", "a note"},
          {7, -8, 9}};
}

std::string written(const Tree& tree) {
  std::ostringstream out;
  write_value(out, tree);
  return out.str();
}

TEST(BinaryValue, ReturnsAsItWasWritten) {
  const Tree tree = example();
  std::istringstream in(written(tree));
  Tree read;
  read.age = 3;  // Old values do not remain.
  read.notes = {"old", "old", "old"};
  read_value(in, read);
  EXPECT_EQ(read, tree);
  EXPECT_EQ(written(read), written(tree));
  EXPECT_EQ(in.peek(), std::istringstream::traits_type::eof()) << "nothing is left";
}

TEST(BinaryValue, EveryMemberIsWritten) {
  Tree other = example();
  other.leaves[1].colour = Tint::green;
  EXPECT_NE(written(other), written(example()));
  other = example();
  other.age = 1;
  EXPECT_NE(written(other), written(example()));
}

TEST(BinaryValue, StreamsThatEndTooEarlyAreRefused) {
  const std::string whole = written(example());
  for (size_t length = 0; length < whole.size(); ++length) {
    std::istringstream in(whole.substr(0, length));
    Tree read;
    EXPECT_THROW(read_value(in, read), Error) << length;
  }
}

}  // namespace
}  // namespace vug
