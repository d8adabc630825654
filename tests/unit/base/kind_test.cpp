// SPDX-License-Identifier: Apache-2.0
#include <vug/base/kind.h>
#include <vug/base/pluralize.h>
#include <vug/base/require_kind.h>

#include <gtest/gtest.h>

#include <memory>

namespace vug {
namespace {

/// Common base of both kinds of rope below.
struct Strand {
  double length = 1;
};

struct Rope : Strand {
  std::filesystem::path file = "plain.png";
  int plies = 3;
  std::optional<int> knots;

  static void describe(Schema<Rope>& s) {
    s.param("length", &Strand::length, positive_length("of the rope"))
        .param("file", &Rope::file, {.doc = "a picture of it"})
        .param("plies", &Rope::plies, {.doc = "strands", .min = 1, .max = 1e6})
        .param("knots", &Rope::knots, {.doc = "in it; as many as it likes if not given"});
  }
  std::string fault() const { return plies > 10 * length ? "too many plies for its length" : ""; }
};
using RopePtr = std::shared_ptr<const Rope>;

}  // namespace

template <>
struct ValueTraits<RopePtr> : ObjectTraits<RopePtr> {
  static constexpr const char* kWord = "rope";
};

namespace {

const Kind<RopePtr>& rope() {
  static const auto kind = make_kind<RopePtr, Rope>("rope", "rope", [](const Rope& r) -> RopePtr {
    if (r.file == "torn.png") throw Error(ErrorCode::bad_input, "cannot read it", {}, "mend it");
    if (r.file == "gone.png") throw Error(ErrorCode::io, "the disk is gone");
    return std::make_shared<const Rope>(r);
  });
  return kind;
}
const Kinds<RopePtr> kRopes = {&rope()};

std::string refusal(const NamedValues& parameters) {
  try {
    make_product(kRopes, "rope", parameters);
  } catch (const Error& error) {
    return error.what() + (error.hint().empty() ? "" : " / " + error.hint());
  }
  return "accepted";
}

TEST(Kind, MakesItsProductFromArguments) {
  const RopePtr made = make_product(kRopes, "rope", {{"length", 2.0}, {"plies", 5}});
  EXPECT_EQ(made->length, 2);  // a member of a base of the parameter struct
  EXPECT_EQ(made->plies, 5);
  EXPECT_EQ(made->file, "plain.png");
  EXPECT_FALSE(made->knots);
  EXPECT_EQ(make_product(kRopes, "rope", {{"knots", 4}})->knots, 4);
}

TEST(Pluralize, FollowsTheSpelling) {
  EXPECT_EQ(plural_of("light"), "lights");
  EXPECT_EQ(plural_of("geology"), "geologies");
  EXPECT_EQ(plural_of("way"), "ways");
  EXPECT_EQ(plural_of("box"), "boxes");
}

TEST(Kind, RejectsInvalidArguments) {
  EXPECT_EQ(refusal({{"plies", 0}}), "'plies' must be at least 1, not 0");
  EXPECT_EQ(refusal({{"plies", 1000001}}), "'plies' must be at most 1000000, not 1000001");
  EXPECT_EQ(refusal({{"plies", 20}}), "too many plies for its length");
  EXPECT_EQ(refusal({{"plies", 0}, {"length", -1.0}}),
            "'plies' must be at least 1, not 0; 'length' must be above 0, not -1m");
  EXPECT_EQ(refusal({{"file", "torn.png"}}), "cannot read it / mend it");
  EXPECT_EQ(refusal({{"file", 3.0}}), "'file' expects a file, not a number");
  EXPECT_EQ(refusal({{"knots", 2.5}}), "'knots' expects a whole number, not 2.5");
  EXPECT_EQ(refusal({{"knots", "two"}}), "'knots' expects a whole number, not a text");
}

TEST(Kind, SuggestsTheNearestName) {
  try {
    make_product(kRopes, "rop");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()) + " / " + error.hint(),
              "unknown rope 'rop' / did you mean 'rope'?");
  }
  EXPECT_EQ(find_kind(kRopes, "thread"), nullptr);
}

TEST(Kind, IsFoundByName) {
  struct Knot {
    KindInfo info;
  };
  const Knot reef{{"reef", "knot", "Joins two ropes.", "", {}}};
  const Knot bowline{{"bowline", "knot", "A loop that holds.", "", {}}};
  const std::vector<const Knot*> knots = {&reef, &bowline};
  EXPECT_EQ(&require_kind(knots, "bowline", "no"), &bowline);
  try {
    require_kind(knots, "bowlin", "there is no such knot");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()) + " / " + error.hint(),
              "there is no such knot / did you mean 'bowline'?");
  }
}

TEST(Kind, PropagatesSystemErrors) {
  Diagnostics diagnostics;
  EXPECT_THROW(rope().make({{"file", Value("gone.png"), {}}}, {}, diagnostics), Error);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(Kind, FilesAreRelativeToTheNamingText) {
  const auto file = [](const std::string& name, const std::string& text) {
    Diagnostics diagnostics;
    const auto made = rope().make({{"file", Value(name), {text, 3, 1}}}, {}, diagnostics);
    return made ? (*made)->file.string() : "none";
  };
  EXPECT_EQ(file("wool.png", "shots/one/cave.vug"), "shots/one/wool.png");
  EXPECT_EQ(file("../wool.png", "shots/one/cave.vug"), "shots/wool.png");
  EXPECT_EQ(file("/stock/wool.png", "shots/one/cave.vug"), "/stock/wool.png");
  EXPECT_EQ(file("wool.png", "cave.vug"), "wool.png");
  EXPECT_EQ(file("wool.png", ""), "wool.png");
}

TEST(Kind, ObjectsAreStoredInValues) {
  EXPECT_TRUE(ValueTraits<RopePtr>::write(nullptr).empty());
  const RopePtr one = std::make_shared<const Rope>();
  const Value value = ValueTraits<RopePtr>::write(one);
  EXPECT_EQ(value.type_name(), "a rope");
  EXPECT_EQ(ValueTraits<RopePtr>::read(value), one);
  EXPECT_FALSE(ValueTraits<RopePtr>::read(Value(1.0)));
}

}  // namespace
}  // namespace vug
