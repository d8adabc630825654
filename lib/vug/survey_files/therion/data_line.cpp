// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/therion/data_line.h>

#include <fmt/format.h>

namespace vug::survey::therion {
namespace {

bool is_wall(Item item) {
  return item == Item::left || item == Item::right || item == Item::up || item == Item::down;
}
bool is_gradient(Item item) { return item == Item::clino || item == Item::back_clino; }
bool may_be_omitted(Item item) {
  return is_wall(item) || item == Item::compass || item == Item::back_compass ||
         item == Item::back_clino || item == Item::back_tape;
}

Value parse_value(const Token& token, Item item) {
  Value value;
  value.where = token.where;
  const std::string word = lower_case(token.text);
  if (token.kind == Token::Kind::bracketed) {
    const std::vector<Word> words = split_words(token.text);
    std::optional<double> first, second;
    if (is_wall(item) && words.size() == 2) {
      first = parse_number(words[0].text);
      second = parse_number(words[1].text);
    }
    if (!first || !second)
      fail(fmt::format("{} is not a pair of distances to the walls", quote_text(token.text)),
           token.where, "write [from to] with two numbers for left, right, up or down");
    value.kind = Value::Kind::number;
    value.number = *first;
    value.second = second;
  } else if (word == "-" || word == "." || word == "nan") {
    if (!may_be_omitted(item))
      fail("the reading must not be omitted", token.where, "write a number");
    value.kind = Value::Kind::omitted;
  } else if (is_gradient(item) && (word == "up" || word == "down")) {
    value.kind = word == "up" ? Value::Kind::up : Value::Kind::down;
  } else {
    value.kind = Value::Kind::number;
    value.number = read_number(token);
  }
  return value;
}

}  // namespace

void Values::add(const Values& other) {
  for (size_t i = 0; i < values_.size(); ++i)
    if (other.values_[i].kind != Value::Kind::absent) values_[i] = other.values_[i];
}

DataLine read_data_line(const std::vector<Token>& line, const Order& order, size_t first,
                        size_t end) {
  DataLine data;
  data.where = line.front().where.up_to(line.back().where);
  size_t at = 0;
  for (size_t i = first; i < end; ++i) {
    const Item item = order.items[i];
    if (item == Item::ignore_all) return data;
    if (at == line.size())
      fail(fmt::format("the line has {} of {} readings", at, end - first), data.where,
           "add the missing readings, or change the order with 'data'");
    const Token& token = line[at++];
    switch (item) {
      case Item::from:
        data.from = token;
        break;
      case Item::to:
        data.to = token;
        break;
      case Item::station:
        data.station = token;
        break;
      case Item::ignore:
        break;
      case Item::direction: {
        const std::string word = lower_case(token.text);
        if (word != "f" && word != "b" && word != "forward" && word != "backward" &&
            word != "foresight" && word != "backsight")
          fail(fmt::format("{} is not a direction", quote_text(token.text)), token.where,
               "write F or B");
        data.backwards = word[0] == 'b';
        break;
      }
      default:
        data.values[item] = parse_value(token, item);
    }
  }
  if (at < line.size())
    fail(fmt::format("the line has more than {} readings", end - first), line[at].where,
         "remove the reading, or add it to 'data'");
  return data;
}

}  // namespace vug::survey::therion
