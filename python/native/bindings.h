// What the module stanok._native is put together from; each file tells the interpreter its
// functions.
//
// The module is the narrow side of the package: it gives numbers as arrays and all else as texts of
// JSON; names, types and documentation are in python/stanok, whose functions are what people call.
#pragma once

#include <pybind11/pybind11.h>

namespace stanok::python {

void bind_machine(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_programs(pybind11::module_& module);
void bind_logs(pybind11::module_& module);
void bind_process(pybind11::module_& module);
void bind_kinematics(pybind11::module_& module);
void bind_grinding(pybind11::module_& module);
void bind_cutting(pybind11::module_& module);
void bind_protocol(pybind11::module_& module);

}  // namespace stanok::python
