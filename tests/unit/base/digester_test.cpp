// SPDX-License-Identifier: Apache-2.0
#include <vug/base/digester.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <map>
#include <set>

namespace vug {
namespace {

enum class Colour { red, green };

struct Inner {
  Vec3d point{1, 2, 3};
  float weight = 0.5f;
};

struct Outer {
  double number = 1;
  bool flag = false;
  Colour colour = Colour::red;
  std::string text = "text";
  Inner inner;
  std::optional<Inner> maybe;
  std::vector<double> list{1, 2};
  std::vector<Inner> inners{1};
  std::array<int, 3> triple{1, 2, 3};
  std::shared_ptr<const Inner> pointer = std::make_shared<Inner>();
  std::variant<std::monostate, int, double> either;
  Box3d box{Vec3d(0), Vec3d(1)};
  Interval interval{0, 1};
  std::pair<int, double> pair{1, 2};
  std::filesystem::path file = "a/b";
  std::map<std::string, int> table{{"a", 1}};
};
static_assert(detail::member_count<Outer>() == 16);
static_assert(detail::member_count<Inner>() == 2);

class Hidden {
 public:
  explicit Hidden(int value) : value_(value) {}
  void add_to(Digester& digester) const { digester(value_); }

 private:
  int value_;
};

TEST(Digester, EveryMemberCounts) {
  const std::vector<std::function<void(Outer&)>> edits = {
      [](Outer& o) { o.number = 2; },
      [](Outer& o) { o.number = std::nextafter(1.0, 2.0); },
      [](Outer& o) { o.flag = true; },
      [](Outer& o) { o.colour = Colour::green; },
      [](Outer& o) { o.text = "texu"; },
      [](Outer& o) { o.inner.point.z = 4; },
      [](Outer& o) { o.inner.weight = 0.25f; },
      [](Outer& o) { o.maybe.emplace(); },
      [](Outer& o) { o.list.push_back(0); },
      [](Outer& o) { o.list[1] = 3; },
      [](Outer& o) { o.inners[0].weight = 1; },
      [](Outer& o) { o.triple[2] = 4; },
      [](Outer& o) { o.pointer = nullptr; },
      [](Outer& o) {
        o.pointer = std::make_shared<Inner>(Inner{{0, 0, 0}, 1});
      },
      [](Outer& o) { o.either = 1; },
      [](Outer& o) { o.either = 1.0; },
      [](Outer& o) { o.box.max.y = 2; },
      [](Outer& o) { o.interval.lo = -1; },
      [](Outer& o) { o.pair.second = 3; },
      [](Outer& o) { o.file = "a/c"; },
      [](Outer& o) { o.table["b"] = 1; },
      [](Outer& o) { o.table["a"] = 2; },
  };
  std::set<std::string> digests{digest_of(Outer()).hex()};
  for (const auto& edit : edits) {
    Outer changed;
    edit(changed);
    EXPECT_TRUE(digests.insert(digest_of(changed).hex()).second) << digests.size();
  }
}

TEST(Digester, PointersCountByContent) {
  EXPECT_EQ(digest_of(Outer()), digest_of(Outer()));
  EXPECT_EQ(digest_of(Hidden(3)), digest_of(Hidden(3)));
  EXPECT_NE(digest_of(Hidden(3)), digest_of(Hidden(4)));
}

TEST(Digester, TheEndsOfListsCount) {
  using List = std::vector<int>;
  EXPECT_NE(digest_of(List{1}, List{2, 3}), digest_of(List{1, 2}, List{3}));
  EXPECT_NE(digest_of(std::string("a"), std::string("bc")),
            digest_of(std::string("ab"), std::string("c")));
  EXPECT_NE(digest_of(std::vector<Inner>(1), std::vector<Inner>(2)),
            digest_of(std::vector<Inner>(2), std::vector<Inner>(1)));
}

}  // namespace
}  // namespace vug
