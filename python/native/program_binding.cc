// Programs without a machine that moves: records after block preparation, and what is wrong.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "jobs/dry_run/dry_run.h"
#include "jobs/dry_run/law_fields.h"
#include "jobs/interpret/record_fields.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/json_text.h"
#include "protocol/contract/plane_json.h"
#include "python/native/bindings.h"
#include "python/native/faults.h"
#include "python/native/interruption.h"
#include "python/native/machine_handle.h"
#include "runtime/program_files.h"

namespace stanok::python {
namespace {

namespace py = pybind11;

// A program and where it would run.
struct Program {
  std::string name;
  Roots roots;
  int channel = 1;
  int scheme = -1;              // < 0: the one of the machine file
  std::uint64_t steps_max = 0;  // 0: as the machine file says
};

channels::MachineConfig machine_of(const config::MachineFile& file, const Program& program) {
  channels::MachineConfig machine = file.machine;
  if (program.steps_max > 0) machine.program_bounds.steps = program.steps_max;
  return machine;
}

// Lines of JSON as `stanok interpret` prints them, faults, and blocks.
py::tuple interpret(const config::MachineFile& file, const Program& program) {
  static_cast<void>(channel_of(file, program.channel));
  Interruption interruption;
  std::string records;
  jobs::DryRunResult result;
  {
    const py::gil_scoped_release others_run;
    const channels::MachineConfig machine = machine_of(file, program);
    const runtime::ProgramFiles files(program.roots, runtime::program_format(machine));
    jobs::DryRun run(machine, program.channel, program.scheme, files);
    result = run.run(
        program.name, jobs::Reachability::unchecked,
        [&](const lang::Command& command, const motion::PathBlock* block) {
          protocol::append_json_line(records,
                                     jobs::record_fields(command, block, run.channel().words));
        },
        [](const lang::ProgramRequest&, const lang::Command&) {},
        {.gives_up = interruption.asked()});
  }
  interruption.rethrow();
  return py::make_tuple(py::str(records),
                        py::str(protocol::json_text(faults_json(result.diagnostics))),
                        result.blocks);
}

// Faults, and blocks under a feed law and tilted planes as `stanok check --estimate --json` has
// them.
py::tuple check(const config::MachineFile& file, const Program& program) {
  static_cast<void>(channel_of(file, program.channel));
  Interruption interruption;
  jobs::DryRunResult result;
  {
    const py::gil_scoped_release others_run;
    const channels::MachineConfig machine = machine_of(file, program);
    const runtime::ProgramFiles files(program.roots, runtime::program_format(machine));
    result = jobs::check_program(machine, program.channel, program.scheme, program.name, files,
                                 interruption.asked());
  }
  interruption.rethrow();
  const FieldList laws = field_list(result.laws, jobs::law_fields);
  return py::make_tuple(py::str(protocol::json_text(faults_json(result.diagnostics))),
                        py::str(protocol::json_text(protocol::list_json(laws))),
                        py::str(protocol::json_text(protocol::plane_json(result.planes))),
                        result.blocks);
}

}  // namespace

void bind_programs(py::module_& module) {
  py::class_<Program>(module, "Program")
      .def(py::init<>())
      .def_readwrite("name", &Program::name)
      .def_readwrite("roots", &Program::roots)
      .def_readwrite("channel", &Program::channel)
      .def_readwrite("scheme", &Program::scheme)
      .def_readwrite("steps_max", &Program::steps_max);
  module.def("interpret", &interpret, py::arg("machine"), py::arg("program"));
  module.def("check", &check, py::arg("machine"), py::arg("program"));
}

}  // namespace stanok::python
