// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "app/python/bindings.hpp"
#include "core/base/errors.hpp"

namespace py = pybind11;

namespace contactsim {

namespace {

/// The exceptions live as long as the interpreter.
PyObject *deck_error = nullptr, *file_error = nullptr, *solve_error = nullptr;

std::string format_all(const Diagnostics& diagnostics) {
  std::string text;
  for (const DiagnosticGroup& group : diagnostics.grouped()) text += format_machine(group);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// Raises an exception of Python with one more attribute.
void raise(PyObject* type, const std::string& text, const char* attribute, const py::object& value) {
  const py::object error = py::reinterpret_borrow<py::object>(type)(text);
  error.attr(attribute) = value;
  PyErr_SetObject(type, error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const DeckError& error) {
    raise(deck_error, format_all(error.diagnostics()), "problems", py::cast(error.diagnostics().all()));
  } catch (const FileError& error) {
    PyErr_SetString(file_error, error.what());
  } catch (const SolveError& error) {
    raise(solve_error, error.what(), "time", py::float_(error.time()));
  }
}

PyObject* add_exception(py::module_& module, const char* name, const char* help, PyObject* base) {
  const std::string path = std::string("contactsim.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(path.c_str(), help, base, nullptr);
  module.add_object(name, type);
  return type;
}

}  // namespace

void bind_errors(py::module_& module) {
  PyObject* any = add_exception(module, "Error", "What the others are", PyExc_RuntimeError);
  deck_error = add_exception(module, "DeckError", "The deck is wrong; problems is a list of Problem", any);
  file_error = add_exception(module, "FileError", "A file cannot be read or written", any);
  solve_error = add_exception(module, "SolveError", "The run cannot go on; time says when", any);
  py::register_exception_translator(translate);

  py::class_<Diagnostic>(module, "Problem", "One thing that is wrong, or to decide about")
      .def_property_readonly("is_error", [](const Diagnostic& d) { return d.severity == Severity::error; })
      .def_readonly("id", &Diagnostic::id, "of a warning, \"surface-overlap\"")
      .def_property_readonly(
          "file",
          [](const Diagnostic& d) { return d.location.is_known() ? d.location.file->name : std::string(); },
          "of the deck, \"\" where no line is at fault")
      .def_property_readonly("line", [](const Diagnostic& d) { return d.location.line; })
      .def_property_readonly("column", [](const Diagnostic& d) { return d.location.column; })
      .def_readonly("text", &Diagnostic::text)
      .def_readonly("hint", &Diagnostic::hint)
      .def("__repr__", [](const Diagnostic& d) {
        Diagnostics one;
        one.add(d);
        return format_all(one);
      });
}

}  // namespace contactsim
