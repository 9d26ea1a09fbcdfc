#include "python/native/faults.h"

#include <exception>

#include "base/catalogue.h"
#include "protocol/contract/diagnostic_json.h"
#include "protocol/contract/json_text.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using nlohmann::ordered_json;

std::string remedy_of(const std::string& code) {
  const CatalogueRow* const row = find_in_catalogue(code);
  return row == nullptr ? "" : std::string(row->remedy);
}

// "file:line:column: what is wrong; how to correct it".
ordered_json config_fault_json(const config::ConfigFault& fault) {
  const std::size_t end = fault.text.find("; ");
  return {{"code", ""},
          {"severity", "error"},
          {"file", fault.file},
          {"line", fault.line},
          {"column", fault.column},
          {"message", fault.text.substr(0, end)},
          {"remedy", end == std::string::npos ? "" : fault.text.substr(end + 2)}};
}

py::object exception(const char* exception_class, const ordered_json& faults) {
  const py::object type = py::module_::import("stanok.errors").attr(exception_class);
  return type.attr("from_json")(py::str(protocol::json_text(faults)));
}

void set_error(const py::object& error) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

}  // namespace

ordered_json fault_json(const Diagnostic& diagnostic) {
  ordered_json json = protocol::diagnostic_json(diagnostic);
  std::string remedy;
  for (const std::string& help : diagnostic.help) remedy += (remedy.empty() ? "" : "; ") + help;
  json["remedy"] = remedy.empty() ? remedy_of(diagnostic.code) : remedy;
  json["source_line"] = diagnostic.source_line;
  return json;
}

ordered_json faults_json(const Diagnostics& diagnostics) {
  ordered_json list = ordered_json::array();
  for (const Diagnostic& diagnostic : diagnostics) list.push_back(fault_json(diagnostic));
  return list;
}

ordered_json fault_json(const std::string& code, const std::string& text) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.message = text;
  return fault_json(diagnostic);
}

void raise(const char* exception_class, const ordered_json& faults) {
  set_error(exception(exception_class, faults));
  throw py::error_already_set();
}

void register_faults(py::module_& /*module*/) {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 asks for this signature
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const config::ConfigError& error) {
      ordered_json faults = ordered_json::array();
      for (const config::ConfigFault& fault : error.faults())
        faults.push_back(config_fault_json(fault));
      set_error(exception("MachineFileError", faults));
    }
  });
}

}  // namespace stanok::python
