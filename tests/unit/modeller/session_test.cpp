// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <vug/base/rng.h>
#include <vug/modeller/session.h>

namespace vug::modeller {
namespace {

StyleLoader loader() {
  return [](const std::string& file, const std::string&) {
    if (file != "ripperda.vug")
      throw Error(ErrorCode::bad_input, "there is no file '" + file + "'");
    return ripperda();
  };
}

Session read(const std::string& text) { return read_session(text, "s.json", loader()); }

const std::string kStart =
    "{\n  \"format\": \"vug facade session\",\n  \"version\": 1,\n"
    "  \"grammar\": \"ripperda.vug\",\n  \"width\": 12,\n  \"height\": 9,\n";

/// "line:column: message (hint)"
std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_EQ(error.where().file, "s.json");
    return std::to_string(error.where().line) + ':' + std::to_string(error.where().column) + ": " +
           error.what() + (error.hint().empty() ? "" : " (" + error.hint() + ")");
  }
  return "";
}

TEST(Session, RoundTrip) {
  Session session = new_session({.grammar = "ripperda.vug", .width = 12, .height = 9}, loader());
  for (const char* edit :
       {"apply 0 rows heights=3.1", "act 0.1 Grid columns=4 dx=2.5,3,2.6",
        "toggle 0.1.0 column=1 row=0", "move 0.1.0 line=1 to=3.3333333333333335"})
    session.history.apply(parse_edit(edit));
  session.history.set_checkpoint("all \"four\"");
  session.history.undo(1);
  session.history.set_checkpoint("three");
  const std::string text = session_text(session);
  const Session again = read(text);
  EXPECT_EQ(session_text(again), text);
  EXPECT_EQ(bytes(again.current()), bytes(session.current()));
  EXPECT_EQ(again.history.done(), 3u);
  EXPECT_EQ(again.history.edits(), session.history.edits());
  EXPECT_EQ(again.history.checkpoints(), session.history.checkpoints());
}

TEST(Session, ReplayGivesTheSameTree) {
  // Numbers of all magnitudes are restored bit for bit.
  RandomStream random(RandomKey(5));
  for (int trial = 0; trial < 50; ++trial) {
    Session session = new_session({.grammar = "ripperda.vug",
                                   .width = random.uniform(4, 40),
                                   .height = random.uniform(4, 40),
                                   .min_size = random.uniform(1e-6, 1e-2)},
                                  loader());
    const double height = random.uniform(0.1, 0.9) * session.current().canvas().height;
    session.history.apply({"apply", "0", "rows", {{"heights", {height}}}});
    session.history.apply({"act", "0.1", "RegularGrid", {{"columns", {random.below(5) + 1.0}}}});
    const Session again = read(session_text(session));
    ASSERT_EQ(bytes(again.current()), bytes(session.current()));
    ASSERT_EQ(again.current().node(1).rect, session.current().node(1).rect);
    ASSERT_EQ(session_text(again), session_text(session));
  }
}

TEST(Session, PhotosDetermineTheSize) {
  const std::string text =
      "{\"format\": \"vug facade session\", \"version\": 1, \"grammar\": \"ripperda.vug\",\n"
      "\"photo\": {\"file\": \"front.png\", \"pixels\": [600, 450], \"scale\": 0.02}, \"edits\": "
      "[]}";
  const Session session = read(text);
  EXPECT_EQ(session.current().canvas().width, 12);
  EXPECT_EQ(session.current().canvas().height, 9);
  EXPECT_EQ(session.metres_per_pixel(), 0.02);
  EXPECT_EQ(session_text(read(session_text(session))), session_text(session));
  const Session wide =
      read(kStart + "\"photo\": {\"file\": \"front.png\", \"pixels\": [600, 450]}, \"edits\": []}");
  EXPECT_EQ(wide.metres_per_pixel(), 0.02);
}

TEST(Session, ErrorsHaveALocationAndAHint) {
  const auto edits = [](const std::string& all) {
    return kStart + "  \"edits\": [\n" + all + "\n]}";
  };
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"node\": \"0\", \"rule\": \"rows\"},\n"
                           "  {\"edit\": \"act\", \"node\": \"0.1\", \"rule\": \"Grid\", "
                           "\"numbers\": {\"dx\": 2, \"rows\": 0}}")),
            "9:79: /edits/1/numbers/rows: 'rows' is 0, while dividing Grid 12 x 5.5 m at (0, 3.5) "
            "(it must be 1 to 1000 here)");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"applyy\", \"node\": \"0\", \"rule\": \"rows\"}")),
            "8:10: /edits/0/edit: unknown edit 'applyy' (did you mean 'apply'?)");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"node\": \"1\", \"rule\": \"rows\"}")),
            "8:27: /edits/0/node: the facade has no part '1' (it has 1 of them, counted from 0)");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"node\": \"0\", \"rule\": \"row\"}")),
            "8:40: /edits/0/rule: 'Facade' has no rule 'row' (did you mean 'rows'?)");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"nod\": \"0\", \"rule\": \"rows\"}")),
            "8:26: /edits/0/nod: unknown key 'nod' (did you mean 'node'?)");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"node\": 0, \"rule\": \"rows\"}")),
            "8:27: /edits/0/node: expected a string");
  EXPECT_EQ(fault_of(edits("{\"edit\": \"apply\", \"node\": \"0\"}")),
            "8:1: /edits/0: 'apply' needs a rule");
  EXPECT_EQ(
      fault_of(edits("{\"edit\": \"apply\", \"node\": \"0\", \"rule\": \"rows\", \"numbers\": "
                     "{\"heights\": [3, null]}}")),
      "8:75: /edits/0/numbers/heights/1: expected a number");
  EXPECT_EQ(fault_of("[]"), "1:1: expected an object");
  EXPECT_EQ(fault_of(""), "1:1: invalid JSON");
  EXPECT_EQ(fault_of("{\n \"format\": \"vug facade session\",,"), "2:33: invalid JSON");
  EXPECT_EQ(fault_of("{\"format\": \"other\"}"),
            "1:12: /format: this is not a facade session (\"format\": \"vug facade session\")");
  EXPECT_EQ(fault_of("{\"format\": \"vug facade session\", \"version\": 2}"),
            "1:45: /version: unsupported session version 2 (this program reads version 1)");
  EXPECT_EQ(fault_of(kStart + "\"width\": 3}"), "7:1: duplicate key 'width' in one object");
  EXPECT_EQ(fault_of(kStart + "\"edits\": [], \"done\": 1}").substr(0, 12), "7:22: /done:");
  EXPECT_EQ(fault_of(kStart + "\"edits\": [], \"done\": -1}").substr(0, 12), "7:22: /done:");
  EXPECT_NE(fault_of(kStart + "\"edits\": [], \"checkpoints\": {\"a\": 1}}"), "");
  EXPECT_NE(fault_of(kStart + "\"edits\": [], \"checkpoints\": {\"\": 0}}"), "");
  EXPECT_NE(fault_of(kStart + "\"edits\": [], \"least\": 0}"), "");
  EXPECT_NE(fault_of(kStart + "\"edits\": [], \"least\": 100}"), "");
  EXPECT_NE(fault_of(kStart + "\"edits\": [], \"least\": 1e999}"), "");
  EXPECT_NE(fault_of(kStart + "\"edits\": {}}"), "");
  EXPECT_EQ(fault_of(kStart + "\"editss\": []}").substr(0, 12), "7:11: /edits");
  EXPECT_NE(fault_of("{\"format\": \"vug facade session\", \"version\": 1, \"grammar\": "
                     "\"ripperda.vug\", \"edits\": []}")
                .find("the facade's width is unknown"),
            std::string::npos);
  EXPECT_EQ(fault_of("{\"format\": \"vug facade session\", \"version\": 1, \"grammar\": "
                     "\"ripperdaa.vug\", \"edits\": []}"),
            "1:59: /grammar: there is no file 'ripperdaa.vug'");
  for (const char* photo :
       {"3", "{}", "{\"file\": 3}", "{\"file\": \"a\", \"pixels\": [3]}",
        "{\"file\": \"a\", \"pixels\": [0, 3]}", "{\"file\": \"a\", \"scale\": 1}",
        "{\"file\": \"a\", \"pixels\": [3, 3], \"scale\": 0}"})
    EXPECT_NE(fault_of(kStart + "\"edits\": [], \"photo\": " + photo + "}"), "") << photo;
}

}  // namespace
}  // namespace vug::modeller
