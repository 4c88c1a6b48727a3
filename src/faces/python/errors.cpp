#include <exception>

#include "base/input/diagnostic.hpp"
#include "base/number/effort.hpp"
#include "base/number/parse.hpp"
#include "base/output/output_error.hpp"
#include "faces/python/bind.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

/// Raises an exception class of the package, which is constructed from these arguments.
template <class... Arguments>
void raise(const char* type, const Arguments&... arguments) {
  const py::object cls = py::module_::import("slipproof._errors").attr(type);
  const py::object error = cls(arguments...);
  PyErr_SetObject(cls.ptr(), error.ptr());
}

/// A message may contain bytes of a file. Bytes that are not UTF-8 are decoded as Python decodes file names.
py::object decoded(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

py::list places(const std::vector<Diagnostic>& diagnostics) {
  py::list list;
  for (const Diagnostic& d : diagnostics)
    list.append(py::make_tuple(decoded(d.file), d.line, d.column, decoded(d.message)));
  return list;
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const InputError& error) {
    raise("InputError", places(error.diagnostics()));
  } catch (const NumberError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const TooMuchWork& error) {
    raise("TooMuchWork", error.what());
  } catch (const OutputError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_local_exception_translator(translate);
}

}  // namespace slipproof::python
