// The module stanok._native.
#include "python/native/bindings.h"
#include "python/native/faults.h"

PYBIND11_MODULE(_native, module) {
  module.doc() = "Libraries of stanok; use the package stanok instead";
  stanok::python::register_faults(module);
  stanok::python::bind_machine(module);
  stanok::python::bind_simulation(module);
  stanok::python::bind_programs(module);
  stanok::python::bind_logs(module);
  stanok::python::bind_process(module);
  stanok::python::bind_kinematics(module);
  stanok::python::bind_grinding(module);
  stanok::python::bind_cutting(module);
  stanok::python::bind_protocol(module);
}
