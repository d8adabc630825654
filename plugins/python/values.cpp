// SPDX-License-Identifier: Apache-2.0
// Conversion of scene values from and to Python.
#include "scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace vug::python {
namespace {

bool is_numpy_truth(const py::handle& value) {
  return py::hasattr(value, "dtype") && py::str(value.attr("dtype")).cast<std::string>() == "bool";
}

std::string number_text(const std::string& name, const py::handle& value) {
  if (PyIndex_Check(value.ptr())) return py::str(py::int_(value.attr("__index__")()));
  const double number = py::float_(py::reinterpret_borrow<py::object>(value));
  if (!std::isfinite(number))
    throw py::value_error(fmt::format("'{}' is {}: a parameter must be finite", name, number));
  return py::repr(py::float_(number));
}

/// True for sequences and arrays, but not for arrays without dimensions, which are numbers.
bool has_length(const py::handle& value) {
  if (!py::hasattr(value, "__len__")) return false;
  if (PyObject_Size(value.ptr()) >= 0) return true;
  PyErr_Clear();
  return false;
}

bool is_number(const py::handle& value) {
  // Arrays of any size pass PyIndex_Check.
  return !has_length(value) && (PyIndex_Check(value.ptr()) || PyFloat_Check(value.ptr()) ||
                                py::hasattr(value, "__float__"));
}

bool is_sequence(const py::handle& value) {
  return has_length(value) && py::hasattr(value, "__getitem__") &&
         !py::isinstance<py::str>(value) && !py::isinstance<py::bytes>(value) &&
         !py::isinstance<py::dict>(value);
}

std::string argument_text(const std::string& name, const py::handle& value, int depth) {
  constexpr int kMaxDepth = 100;
  const bool vector = is_sequence(value) && !py::isinstance<py::list>(value) &&
                      py::len(value) == 3 && is_number(value[py::int_(0)]);
  if (vector || !is_sequence(value)) return override_text(name, value);
  if (depth >= kMaxDepth)
    throw py::value_error(fmt::format("'{}' has more than {} nested lists", name, kMaxDepth));
  std::vector<std::string> parts;
  for (const py::handle part : value) parts.push_back(argument_text(name, part, depth + 1));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

}  // namespace

std::string override_text(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::bool_>(value) || is_numpy_truth(value))
    return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "__fspath__")) {
    const auto path = py::str(value.attr("__fspath__")()).cast<std::string>();
    return to_string(Value(path));
  }
  if (is_number(value)) return number_text(name, value);
  if (has_length(value) && py::len(value) == 3) {
    std::vector<std::string> parts;
    for (const py::handle part : value) {
      if (!is_number(part)) break;
      parts.push_back(number_text(name, part));
    }
    if (parts.size() == 3) return fmt::format("({})", fmt::join(parts, ", "));
  }
  throw py::type_error(
      fmt::format("'{}' is a {}: a parameter takes a number, a bool, three numbers or text of the "
                  "scene language",
                  name, py::str(py::type::of(value).attr("__name__")).cast<std::string>()));
}

std::string argument_text(const std::string& name, const py::handle& value) {
  return argument_text(name, value, 0);
}

py::object to_python(const Value& value) {
  if (const auto* n = value.get<Number>()) return py::float_(n->value);
  if (const auto* v = value.get<Value::Vector>())
    return py::make_tuple(v->value.x, v->value.y, v->value.z);
  if (const auto* b = value.get<bool>()) return py::bool_(*b);
  if (const auto* s = value.get<std::string>()) return py::str(*s);
  if (const auto* n = value.get<Value::Name>()) return py::str(n->text);
  if (const auto* list = value.get<List>()) {
    py::list out;
    for (const Value& item : *list) out.append(to_python(item));
    return out;
  }
  if (value.empty()) return py::none();
  return py::str(to_string(value));
}

py::object to_plain_python(const Value& value) {
  if (const auto* list = value.get<List>()) {
    py::list out;
    for (const Value& item : *list) out.append(to_plain_python(item));
    return out;
  }
  if (value.get<Object>())
    throw py::type_error(
        fmt::format("the value is {}, which Python cannot represent: use it in a statement, e.g. "
                    "scene.with_text('volume v = level_set(...)'), and build this",
                    value.type_name()));
  return to_python(value);
}

}  // namespace vug::python
