// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <new>

namespace vug::python {
namespace {

/// A class defined in vug/_errors.py. It is never released, because static objects may be destroyed
/// after the interpreter.
py::handle defined(const char* name) {
  return py::object(py::module_::import("vug._errors").attr(name)).release();
}
struct Types {
  py::handle error = defined("Error");
  py::handle cancelled = defined("Cancelled");
  py::handle warning = defined("SceneWarning");
  py::handle diagnostic = defined("Diagnostic");
};
const Types& types() {
  static const Types all;
  return all;
}

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_input:
      return "bad_input";
    case ErrorCode::too_large:
      return "too_large";
    case ErrorCode::io:
      return "io";
    case ErrorCode::cancelled:
      return "cancelled";
    case ErrorCode::internal:
      break;
  }
  return "internal";
}

/// Converts a message, which may quote files with arbitrary bytes.
py::str text(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<py::ssize_t>(bytes.size()), "backslashreplace"));
}

py::object text_or_none(const std::string& bytes) {
  return bytes.empty() ? py::object(py::none()) : text(bytes);
}

py::object number_or_none(int number) {
  return number > 0 ? py::object(py::int_(number)) : py::none();
}

py::object as_diagnostic(const Diagnostic& d) {
  return types().diagnostic(d.severity == Severity::error ? "error" : "warning",
                            text_or_none(d.where.file), number_or_none(d.where.line),
                            number_or_none(d.where.column), text(d.message), text_or_none(d.hint));
}

py::object as_error(const Error& error) {
  py::list context;
  for (const std::string& doing : error.context()) context.append(text(doing));
  const SourceLocation& where = error.where();
  const py::handle type = error.code() == ErrorCode::cancelled ? types().cancelled : types().error;
  return type(text(error.what()), "code"_a = name_of(error.code()),
              "file"_a = text_or_none(where.file), "line"_a = number_or_none(where.line),
              "column"_a = number_or_none(where.column), "hint"_a = text_or_none(error.hint()),
              "context"_a = context);
}

void set(const py::object& error) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void translate(std::exception_ptr thrown) {
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    set(as_error(error));
  }
}

}  // namespace

void raise(const loading::Loaded& loaded, const Diagnostics& faults) {
  py::list all;
  const Diagnostic* first = nullptr;
  for (const Diagnostic& each : faults.all()) {
    all.append(as_diagnostic(each));
    if (!first && each.severity == Severity::error) first = &each;
  }
  set(types().error(text(first->message), "file"_a = text_or_none(first->where.file),
                    "line"_a = number_or_none(first->where.line),
                    "column"_a = number_or_none(first->where.column),
                    "hint"_a = text_or_none(first->hint), "diagnostics"_a = all,
                    "report"_a = text(loaded.report(faults))));
  throw py::error_already_set();
}

void warn(const std::vector<std::string>& texts) {
  for (const std::string& each : texts)
    if (PyErr_WarnEx(types().warning.ptr(), text(each).cast<std::string>().c_str(), 1) != 0)
      throw py::error_already_set();
}

std::vector<std::string> warnings_of(const loading::Loaded& loaded,
                                     const Diagnostics& diagnostics) {
  std::vector<std::string> texts;
  for (const Diagnostic& each : diagnostics.all()) {
    if (each.severity == Severity::error) continue;
    Diagnostics one;
    one.warning(each.where, each.message, each.hint);
    std::string told = loaded.report(one);
    while (!told.empty() && told.back() == '\n') told.pop_back();
    texts.push_back(std::move(told));
  }
  return texts;
}

void bind_errors(py::module_& module) {
  types();
  py::register_exception_translator(translate);
  module.attr("Error") = types().error;
  module.attr("Cancelled") = types().cancelled;
  module.attr("SceneWarning") = types().warning;
  module.attr("Diagnostic") = types().diagnostic;
}

}  // namespace vug::python
