// Cuts for Python: what their logs tell (`stanok process identify`), and up to which depth they do
// not chatter (`stanok process lobes`).
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "client/offline/process/identify/grind_fit_report.h"
#include "client/offline/process/identify/identify_report.h"
#include "client/offline/process/identify/milling_fit_report.h"
#include "client/offline/process/lobes_report.h"
#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "jobs/cutting/found_figures.h"
#include "protocol/contract/json_text.h"
#include "python/native/bindings.h"

namespace stanok::python {
namespace {

namespace py = pybind11;

py::array_t<double> array_of_values(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

template <class Row>
py::array_t<double> column_of(const std::vector<Row>& rows, double Row::* field) {
  py::array_t<double> array(static_cast<py::ssize_t>(rows.size()));
  double* next = array.mutable_data();
  for (const Row& row : rows) *next++ = row.*field;
  return array;
}

template <class Value>
Value fit_or_throw(Expected<Value, std::string> fit) {
  if (!fit) throw std::runtime_error(fit.error());
  return std::move(*fit);
}

py::tuple identify_turning(const std::filesystem::path& file,
                           const std::vector<std::pair<double, double>>& stock, int channel,
                           int spindle, double coefficient_n) {
  std::vector<jobs::StockStep> steps;
  for (const auto& [z_mm, radius_mm] : stock) {
    const bool falls = steps.empty() || z_mm < steps.back().z_mm;
    if (!falls || !(radius_mm > 0.0))
      throw std::invalid_argument("stock must be pairs of Z and radius in mm with falling Z");
    steps.push_back({.z_mm = z_mm, .radius_mm = radius_mm});
  }
  if (steps.empty())
    throw std::invalid_argument("stock is empty; give pairs of Z and radius in mm");
  jobs::CutLog log;
  process::TurningFit fit;
  {
    const py::gil_scoped_release others_run;
    log = jobs::read_cut_log(file, {.channel = channel, .spindle = spindle - 1, .stock = steps});
    fit = fit_or_throw(process::fit_turning(log.record));
  }
  using process::CutRow;
  py::dict arrays;
  arrays["time_s"] = array_of_values(log.time_s);
  arrays["rev_per_min"] = column_of(log.record.rows, &CutRow::rev_per_min);
  arrays["radius_mm"] = column_of(log.record.rows, &CutRow::radius_mm);
  arrays["depth_mm"] = column_of(log.record.rows, &CutRow::depth_mm);
  arrays["travel_mm"] = column_of(log.record.rows, &CutRow::travel_mm);
  arrays["power_w"] = column_of(log.record.rows, &CutRow::power_w);
  arrays["fitted_w"] = array_of_values(fit.fitted_w);
  const client::IdentifyReport report{.log = log, .fit = fit, .coefficient_n = coefficient_n};
  return py::make_tuple(py::str(protocol::json_text(client::to_json(report))), arrays);
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string() + "; check the path");
  return {std::istreambuf_iterator<char>(file), {}};
}

// The report, the rows, and the file of tool and material with the figures that were found.
py::tuple identify_milling(const std::filesystem::path& file, const std::filesystem::path& cut_file,
                           int channel, int spindle, int tool, double efficiency) {
  const jobs::MillingLogRequest request{.channel = channel,
                                        .spindle = spindle - 1,
                                        .cut = config::read_chatter_file(cut_file),
                                        .tool = tool};
  if (request.cut.kind != process::CutKind::milling)
    throw std::invalid_argument(cut_file.string() +
                                " is not of a milling cut; write kind = \"milling\"");
  jobs::MillingLog log;
  process::MillingFit fit;
  {
    const py::gil_scoped_release others_run;
    log = jobs::read_milling_log(file, request);
    fit = fit_or_throw(process::fit_milling(log.record));
  }
  using process::MillingRow;
  py::dict arrays;
  arrays["time_s"] = array_of_values(log.time_s);
  arrays["rev_per_min"] = column_of(log.record.rows, &MillingRow::rev_per_min);
  arrays["removal_mm3_per_s"] = column_of(log.record.rows, &MillingRow::removal_mm3_per_s);
  arrays["rubbing_mm2_per_s"] = column_of(log.record.rows, &MillingRow::rubbing_mm2_per_s);
  arrays["power_w"] = column_of(log.record.rows, &MillingRow::power_w);
  arrays["fitted_w"] = array_of_values(fit.fitted_w);
  const client::MillingFitReport report{.log = log, .fit = fit, .efficiency = efficiency};
  return py::make_tuple(py::str(protocol::json_text(client::to_json(report))), arrays,
                        py::str(client::with_figures(text_of_file(cut_file), report)));
}

// The report, the rows, and the process file with the figures that were found.
py::tuple identify_grinding(const std::filesystem::path& file,
                            const std::filesystem::path& process_file, int channel, int spindle,
                            std::optional<double> touch_mm, double watts_per_newton) {
  const process::DesignRequest sheet = config::read_grinding_file(process_file);
  const jobs::GrindLogRequest request{.channel = channel,
                                      .spindle = spindle - 1,
                                      .allowance_mm = sheet.allowance_mm,
                                      .touch_mm = touch_mm,
                                      .watts_per_newton = watts_per_newton};
  jobs::GrindLog log;
  process::GrindingFit fit;
  {
    const py::gil_scoped_release others_run;
    log = jobs::read_grind_log(file, request);
    fit = fit_or_throw(process::fit_grinding(log.record, sheet.process));
  }
  py::dict arrays;
  arrays["time_s"] = array_of_values(log.time_s);
  arrays["x_mm"] = column_of(log.record.rows, &process::GrindRow::x_mm);
  arrays["power_w"] = column_of(log.record.rows, &process::GrindRow::power_w);
  arrays["fitted_w"] = array_of_values(fit.fitted_w);
  const client::GrindFitReport report{.log = log, .fit = fit};
  return py::make_tuple(py::str(protocol::json_text(client::to_json(report))), arrays,
                        py::str(jobs::with_figures(text_of_file(process_file), fit)));
}

// The report, and the least depth that is not stable by speed.
py::tuple lobes(const std::filesystem::path& file, const std::pair<double, double>& speeds,
                int count, const std::vector<std::pair<double, double>>& cuts,
                const std::string& method) {
  process::LobesRequest request;
  request.process = config::read_chatter_file(file);
  request.speed_from = speeds.first;
  request.speed_to = speeds.second;
  request.count = count;
  if (method == "semi-discretisation") request.method = process::LobesMethod::semi_discretisation;
  for (const auto& [speed, depth_mm] : cuts)
    request.programmed.push_back({.speed_rev_per_min = speed, .depth_mm = depth_mm});
  process::LobesStudy study;
  {
    const py::gil_scoped_release others_run;
    study = process::study_lobes(request);
  }
  py::dict arrays;
  arrays["speed_rev_per_min"] = column_of(study.limits, &process::LimitAt::speed_rev_per_min);
  arrays["depth_mm"] = column_of(study.limits, &process::LimitAt::depth_mm);
  arrays["chatter_hz"] = column_of(study.limits, &process::LimitAt::chatter_hz);
  return py::make_tuple(py::str(protocol::json_text(client::to_json(study))), arrays);
}

}  // namespace

void bind_cutting(py::module_& module) {
  module.def("identify_turning", &identify_turning, py::arg("log"), py::arg("stock"),
             py::arg("channel"), py::arg("spindle"), py::arg("coefficient_n"));
  module.def("identify_milling", &identify_milling, py::arg("log"), py::arg("cut"),
             py::arg("channel"), py::arg("spindle"), py::arg("tool"), py::arg("efficiency"));
  module.def("identify_grinding", &identify_grinding, py::arg("log"), py::arg("process"),
             py::arg("channel"), py::arg("spindle"), py::arg("touch_mm"),
             py::arg("watts_per_newton"));
  module.def("lobes", &lobes, py::arg("file"), py::arg("speeds"), py::arg("count"), py::arg("cuts"),
             py::arg("method"));
}

}  // namespace stanok::python
