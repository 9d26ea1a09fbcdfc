// Plunge grinding for Python: the commands of `stanok grind` with their results, and the model.
#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "jobs/grinding/grind_cycle.h"
#include "jobs/grinding/grind_program.h"
#include "jobs/grinding/grind_study.h"
#include "jobs/grinding/grinding_samples.h"
#include "process/grinding/boundary.h"
#include "process/grinding/plunge.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/json_text.h"
#include "python/native/array_rows.h"
#include "python/native/bindings.h"
#include "python/native/column_arrays.h"
#include "python/native/faults.h"
#include "python/native/interruption.h"

namespace stanok::python {
namespace {

namespace py = pybind11;
using jobs::GrindCycle;
using jobs::GrindInput;
using nlohmann::ordered_json;
using process::InfeedLaw;

// What the functions are given besides what a job on cycles is asked for.
struct GrindOptions : jobs::GrindRequest {
  std::vector<std::string> variations;
  std::string part = "1/1";
  jobs::GrindMachine machine;
  double gauge_margin_mm = 0.0;
};

// Thrown through what computes, when the interpreter was interrupted.
struct Interrupted {};

GrindInput input_or_raise(Expected<GrindInput, Diagnostics> input) {
  if (input) return std::move(*input);
  raise("GrindingError", faults_json(input.error()));
}

[[noreturn]] void raise_findings(const process::Findings& findings) {
  ordered_json faults = ordered_json::array();
  for (const process::Finding& finding : findings)
    faults.push_back(fault_json(finding.code, finding.text));
  raise("GrindingError", faults);
}

py::dict samples_of(const process::GrindingProcess& process, const process::PlungeRun& run) {
  return column_arrays(jobs::grinding_samples(process, run), jobs::grinding_columns());
}

py::str text_of(const Fields& fields) {
  return py::str(protocol::json_text(protocol::fields_json(fields)));
}

// Runs `job` while other threads of Python go on; Ctrl-C ends it where it can be ended.
template <class Job>
auto without_lock(Interruption& interruption, const Job& job) {
  try {
    const py::gil_scoped_release others_run;
    return job();
  } catch (const Interrupted&) {
    interruption.rethrow();
    throw;
  }
}

void let_interrupt(process::DesignRequest& request, Interruption& interruption) {
  request.optimiser.on_iteration = [asked = interruption.asked()](const process::Iteration&) {
    if (asked()) throw Interrupted();
  };
}

// Report as JSON, samples, and the control file as a text.
py::tuple report_of(const GrindInput& input, const GrindCycle& cycle) {
  return py::make_tuple(text_of(jobs::cycle_fields(cycle)),
                        samples_of(cycle.request.process, cycle.design.verification.run),
                        py::str(jobs::control_text(input, cycle)));
}

py::tuple design(const GrindOptions& options, const process::Spread& spread) {
  GrindInput input = input_or_raise(jobs::grind_input(options));
  Interruption interruption;
  let_interrupt(input.request, interruption);
  const auto cycle =
      without_lock(interruption, [&] { return jobs::designed_cycle(input.request, spread); });
  interruption.rethrow();
  if (!cycle) raise_findings(cycle.error());
  return report_of(input, *cycle);
}

py::tuple verify(const GrindOptions& options) {
  GrindInput input = input_or_raise(jobs::control_input(options));
  Interruption interruption;
  let_interrupt(input.request, interruption);
  const GrindCycle cycle = without_lock(
      interruption, [&] { return jobs::assessed_cycle(input.request, input.control->law); });
  interruption.rethrow();
  return report_of(input, cycle);
}

// The headings, and the rows of the part as `stanok grind study --part` prints them.
py::tuple study(const GrindOptions& options) {
  std::vector<jobs::Variation> variations;
  for (const std::string& text : options.variations) {
    const auto variation = jobs::read_variation(text);
    if (!variation)
      throw std::invalid_argument("'" + text +
                                  "' is not KEY=FROM:TO:COUNT with a key of the process file");
    variations.push_back(*variation);
  }
  if (jobs::study_size(variations) > jobs::study_points_max)
    throw std::invalid_argument("more than a million designs");
  const auto part = jobs::read_study_part(options.part);
  if (!part)
    throw std::invalid_argument("'" + options.part +
                                "' is not a part K of N of a study, with K from 1 to N");
  const GrindInput input = input_or_raise(jobs::grind_input(options));
  Interruption interruption;
  const auto points = without_lock(interruption, [&] {
    return jobs::run_study(input.request, variations, *part,
                           [asked = interruption.asked()](std::size_t) {
                             if (asked()) throw Interrupted();
                           });
  });
  return py::make_tuple(jobs::study_csv(variations, jobs::StudyPart(), {}),
                        jobs::study_csv(variations, *part, points));
}

std::string program(const GrindOptions& options, const std::string& title) {
  const GrindInput input = input_or_raise(jobs::control_input(options));
  const InfeedLaw& law = input.control->law;
  const jobs::GrindProgram made =
      jobs::grind_program({.process = input.request.process,
                           .law = law,
                           .machine = options.machine,
                           .title = title,
                           .spark_out_revolutions = input.request.simulation.spark_out_revolutions,
                           .gauge_margin_mm = options.gauge_margin_mm});
  for (const std::string& warning : made.warnings) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  }
  return made.text;
}

InfeedLaw law_of(const Matrix& rows) {
  expect_columns(rows, 2, "law");
  InfeedLaw law;
  for (py::ssize_t k = 0; k < rows.shape(0); ++k)
    law.push_back({.x_mm = row_of(rows, k)[0], .feed_mm_per_s = row_of(rows, k)[1]});
  bool is_law = law.size() >= 2;
  for (std::size_t k = 0; k < law.size(); ++k) {
    const bool falls = k == 0 || law[k].x_mm <= law[k - 1].x_mm;
    is_law = is_law && falls && std::isfinite(law[k].x_mm) && law[k].feed_mm_per_s > 0.0 &&
             law[k].feed_mm_per_s <= process::feed_max_mm_per_s;
  }
  if (!is_law)
    throw std::invalid_argument(
        "law must have two rows (X mm, feed mm/s) at least; X never rises, feeds are above 0 and "
        "at most 1 mm/s");
  return law;
}

py::tuple plunge(const GrindOptions& options, const Matrix& rows,
                 process::InfeedTravel::AtEnd at_end) {
  GrindInput input = input_or_raise(jobs::grind_input(options));
  const InfeedLaw law = law_of(rows);
  input.request.simulation.at_end = at_end;
  Interruption interruption;
  const process::PlungeRun run = without_lock(interruption, [&] {
    return process::simulate_plunge(input.request.process, law, input.request.simulation);
  });
  return py::make_tuple(text_of(jobs::plunge_fields(run)), samples_of(input.request.process, run));
}

// D(H), mm2/rad.
py::array_t<double> boundary(const GrindOptions& options, const py::array_t<double>& allowance_mm) {
  const GrindInput input = input_or_raise(jobs::grind_input(options));
  const process::Boundary line(input.request.process);
  return py::vectorize([&line](double allowance) { return line.at(allowance); })(allowance_mm);
}

void bind_options(py::module_& module) {
  py::class_<GrindOptions>(module, "GrindOptions")
      .def(py::init<>())
      .def_readwrite("input", &GrindOptions::input)
      .def_readwrite("exact", &GrindOptions::exact)
      .def_readwrite("burn_margin", &GrindOptions::burn_margin)
      .def_readwrite("spark_out_revolutions", &GrindOptions::spark_out_revolutions)
      .def_readwrite("time_step_s", &GrindOptions::time_step_s)
      .def_readwrite("points", &GrindOptions::points)
      .def_readwrite("at_mm", &GrindOptions::at_mm)
      .def_readwrite("decimals", &GrindOptions::decimals)
      .def_readwrite("feedback", &GrindOptions::feedback)
      .def_readwrite("iterations", &GrindOptions::iterations)
      .def_readwrite("force", &GrindOptions::force)
      .def_readwrite("variations", &GrindOptions::variations)
      .def_readwrite("part", &GrindOptions::part)
      .def_readwrite("gauge_margin_mm", &GrindOptions::gauge_margin_mm)
      .def("set_machine", [](GrindOptions& options, const std::string& file, int channel,
                             double wheel_speed_m_per_s) {
        options.machine = {
            .machine_file = file, .channel = channel, .wheel_speed_m_per_s = wheel_speed_m_per_s};
      });
}

}  // namespace

void bind_grinding(py::module_& module) {
  bind_options(module);
  module.def(
      "grind_design",
      [](const GrindOptions& options, double stiffness, double force_factor, double allowance_mm) {
        return design(
            options,
            {.stiffness = stiffness, .force_factor = force_factor, .allowance_mm = allowance_mm});
      },
      py::arg("options"), py::arg("stiffness"), py::arg("force_factor"), py::arg("allowance_mm"));
  module.def("grind_verify", &verify, py::arg("options"));
  module.def("grind_study", &study, py::arg("options"));
  module.def("grind_program", &program, py::arg("options"), py::arg("title"));
  module.def(
      "grind_plunge",
      [](const GrindOptions& options, const Matrix& law, bool goes_on) {
        using AtEnd = process::InfeedTravel::AtEnd;
        return plunge(options, law, goes_on ? AtEnd::goes_on : AtEnd::stands);
      },
      py::arg("options"), py::arg("law"), py::arg("goes_on"));
  module.def("grind_boundary", &boundary, py::arg("options"), py::arg("allowance_mm"));
}

}  // namespace stanok::python
