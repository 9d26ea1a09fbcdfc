// What is wrong, as exceptions of Python: the classes of python/stanok/errors.py, with code, place
// and remedy.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "config/text/config_error.h"

namespace stanok::python {

// A diagnostic as `stanok check --json` has it, with the remedy besides: what the diagnostic itself
// says, else the catalogue.
[[nodiscard]] nlohmann::ordered_json fault_json(const Diagnostic& diagnostic);
[[nodiscard]] nlohmann::ordered_json faults_json(const Diagnostics& diagnostics);
// A code of the catalogue with a text and no place.
[[nodiscard]] nlohmann::ordered_json fault_json(const std::string& code, const std::string& text);

// Throws pybind11::error_already_set with an exception of this class of stanok.errors. The GIL is
// held.
[[noreturn]] void raise(const char* exception_class, const nlohmann::ordered_json& faults);
// ConfigError becomes MachineFileError.
void register_faults(pybind11::module_& module);

}  // namespace stanok::python
