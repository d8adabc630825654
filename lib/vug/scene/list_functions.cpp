// SPDX-License-Identifier: Apache-2.0
#include <vug/scene/function_arguments.h>
#include <vug/scene/list_functions.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vug::scene {

namespace {

using ListResult = std::optional<Value>;

constexpr size_t kMaxElements = 1000000;

/// Reports an element of a type that a function does not take.
Value misfit(const char* function, const char* takes, size_t index, const Value& element,
             const FaultSite& site) {
  return site.fault(
      fmt::format("'{}' {}, and element {} is {}", function, takes, index, element.type_name()),
      "elements are counted from 0");
}

template <bool Smallest>
ListResult extreme(const Arguments& arguments, const FaultSite& site) {
  constexpr const char* kName = Smallest ? "min" : "max";
  std::vector<Number> all = numbers_of(arguments);
  if (const List* list = arguments.size() == 1 ? list_at(arguments, 0) : nullptr) {
    if (list->empty()) return site.fault(fmt::format("'{}' of an empty list", kName));
    for (size_t i = 0; i < list->size(); ++i)
      if (const Number* n = (*list)[i].get<Number>())
        all.push_back(*n);
      else
        return misfit(kName, "compares numbers", i, (*list)[i], site);
  }
  if (all.empty()) return std::nullopt;
  if (!unify_all_dimensions(all, site)) return Value();
  double best = all[0].value;
  for (const Number& one : all)
    best = Smallest ? std::min(best, one.value) : std::max(best, one.value);
  return Value(Number{best, all[0].dimension});
}

ListResult len(const Arguments& arguments, const FaultSite&) {
  const List* list = list_at(arguments, 0);
  if (arguments.size() != 1 || !list) return std::nullopt;
  return Value(static_cast<double>(list->size()));
}

ListResult at(const Arguments& arguments, const FaultSite& site) {
  if (arguments.size() != 2 || !arguments[0].name.empty()) return std::nullopt;
  const List* list = arguments[0].value.get<List>();
  const auto* vector = arguments[0].value.get<Value::Vector>();
  const Number* index = arguments[1].value.get<Number>();
  if ((!list && !vector) || !index || !is_plain(*index)) return std::nullopt;
  const double size = list ? static_cast<double>(list->size()) : 3;
  if (index->value != std::floor(index->value) || index->value < 0 || index->value >= size)
    return site.fault(fmt::format("no element {} in a list of {} elements", index->value, size),
                      "elements are counted from 0");
  if (list) return (*list)[static_cast<size_t>(index->value)];
  return Value(Number{vector->value[static_cast<int>(index->value)], vector->dimension});
}

/// All arguments as lists; empty if one has another type.
std::vector<const List*> lists_of(const Arguments& arguments) {
  std::vector<const List*> lists;
  for (size_t i = 0; i < arguments.size(); ++i) {
    lists.push_back(list_at(arguments, i));
    if (!lists.back()) return {};
  }
  return lists;
}

/// The number of elements of all lists together.
size_t total_of(const std::vector<const List*>& lists) {
  size_t total = 0;
  for (const List* list : lists)
    for (const Value& item : *list) total += item.element_count();
  return total;
}

ListResult concat(const Arguments& arguments, const FaultSite& site) {
  const auto lists = lists_of(arguments);
  if (lists.empty()) return std::nullopt;
  if (!may_have_elements(1 + total_of(lists), site)) return Value();
  List all;
  for (const List* list : lists) all.insert(all.end(), list->begin(), list->end());
  return Value(std::move(all));
}

/// The lists [a0, b0, ...], [a1, b1, ...], ... of several lists a, b, ...
ListResult zip(const Arguments& arguments, const FaultSite& site) {
  const auto lists = lists_of(arguments);
  if (lists.empty()) return std::nullopt;
  std::vector<size_t> sizes;
  for (const List* list : lists) sizes.push_back(list->size());
  if (std::adjacent_find(sizes.begin(), sizes.end(), std::not_equal_to<>()) != sizes.end())
    return site.fault(fmt::format("the lists of 'zip' have {} elements", fmt::join(sizes, " and ")),
                      "give it lists of the same length");
  if (!may_have_elements(1 + sizes[0] + total_of(lists), site)) return Value();
  List all;
  for (size_t i = 0; i < sizes[0]; ++i) {
    List tuple;
    for (const List* list : lists) tuple.push_back((*list)[i]);
    all.emplace_back(std::move(tuple));
  }
  return Value(std::move(all));
}

ListResult sum(const Arguments& arguments, const FaultSite& site) {
  const List* list = list_at(arguments, 0);
  if (arguments.size() != 1 || !list) return std::nullopt;
  Value total = 0;
  for (size_t i = 0; i < list->size(); ++i) {
    const Value& item = (*list)[i];
    if (!item.get<Number>() && !item.get<Value::Vector>())
      return misfit("sum", "adds numbers or vectors", i, item, site);
    total = i == 0 ? item : arithmetic('+', total, item, site).value_or(Value());
    if (total.empty()) return Value();
  }
  return total;
}

}  // namespace

bool may_have_elements(size_t count, const FaultSite& site) {
  if (count > kMaxElements)
    site.fault(fmt::format("the list would have {} elements, more than {}", count, kMaxElements));
  return count <= kMaxElements;
}

std::vector<Function> list_functions() {
  return {
      {"min", "numbers or a list of numbers", "the smallest", extreme<true>},
      {"max", "numbers or a list of numbers", "the largest", extreme<false>},
      {"len", "a list", "number of elements", len, false},
      {"at", "a list or vector and a number", "the element with that index, from 0", at, false},
      {"concat", "lists", "one list with the elements of all", concat},
      {"zip", "lists of the same length",
       "a list of the lists of their first elements, second "
       "elements, ...",
       zip},
      {"sum", "a list of numbers or vectors", "their sum; 0 for an empty list", sum},
  };
}

}  // namespace vug::scene
