// SPDX-License-Identifier: Apache-2.0
#include <vug/language/words.h>

namespace vug::language {

const std::vector<LanguageWord>& statement_words() {
  static const std::vector<LanguageWord> all = {
      {"param", "param NAME = VALUE in LOW..HIGH \"description\"",
       "A number or another value that `-D NAME=VALUE` can change."},
      {"let", "let NAME = VALUE", "A name for a value."},
      {"def", "def NAME(PARAMETER = DEFAULT, ...) \"description\" = VALUE where NAME = VALUE",
       "A function, which expressions call."},
      {"seed", "seed NUMBER", "The number that determines all random choices."},
      {"include", "include \"file.vug\" as NAME { PARAMETER VALUE }",
       "Reads another file; `as` gives its names a prefix and its parameters values."},
      {"grammar", "grammar NAME: KIND { axiom ...  SYMBOL -> ... }",
       "Rules that generate a shape, a facade or the word of an L-system."},
  };
  return all;
}

const std::vector<LanguageWord>& inner_words() {
  static const std::vector<LanguageWord> all = {
      {"in", "in LOW..HIGH; for NAME in LIST", "The range of a param, or the list of a loop."},
      {"on", "KEYWORD NAME on TARGET { ... }",
       "The mesh or volume to which a declaration belongs."},
      {"as", "include \"file.vug\" as NAME", "The prefix of the names of an included file."},
      {"where", "where NAME = VALUE, ...", "Names of a single function or rule."},
      {"axiom", "axiom SYMBOL ...", "The symbols with which a derivation starts."},
      {"for", "[for NAME in LIST if CONDITION: VALUE]", "A value for each element of a list."},
      {"if", "SYMBOL if CONDITION -> ...", "The condition of a rule or a loop."},
      {"and", "A and B", "True if both are true."},
      {"or", "A or B", "True if one of both is true."},
      {"not", "not A", "True if A is false."},
      {"nothing", "SYMBOL -> nothing", "The empty right-hand side of a rule."},
  };
  return all;
}

const std::vector<LanguageWord>& value_words() {
  static const std::vector<LanguageWord> all = {
      {"if", "if(CONDITION, THEN, ELSE)", "One of two values."},
      {"pick", "pick(A, B, ...)", "A random one of its values."},
      {"keys", "keys(FRAME: VALUE, ...)", "A value that changes from frame to frame."},
      {"by", "by rock { MATERIAL -> VALUE, ... }", "A value for each material of a rock."},
      {"true", "true", "The truth value."},
      {"false", "false", "The truth value."},
      {"pi", "pi", "The ratio of a circle's circumference to its diameter."},
      {"frame", "frame", "The number of the frame."},
      {"X", "+X or -X", "The first axis."},
      {"Y", "+Y or -Y", "The second axis, which points up."},
      {"Z", "+Z or -Z", "The third axis."},
  };
  return all;
}

const LanguageWord* find_word(const std::vector<LanguageWord>& words, const std::string& name) {
  for (const LanguageWord& word : words)
    if (word.name == name) return &word;
  return nullptr;
}

}  // namespace vug::language
