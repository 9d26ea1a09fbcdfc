// Cuts for Python: what their logs tell (`stanok process identify`), and up to which depth they do
// not chatter (`stanok process lobes`).
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "config/files/chatter_file.h"
#include "config/files/grinding_file.h"
#include "jobs/cutting/identification.h"
#include "jobs/lobes/lobes_fields.h"
#include "protocol/contract/fields_json.h"
#include "protocol/contract/json_text.h"
#include "python/native/bindings.h"
#include "python/native/column_arrays.h"

namespace stanok::python {
namespace {

namespace py = pybind11;

py::str report_text(const Fields& fields) {
  return py::str(protocol::json_text(protocol::fields_json(fields)));
}

// Identifies while other threads of Python go on.
template <class Request>
auto identified(const Request& request) {
  const py::gil_scoped_release others_run;
  return jobs::identify(request);
}

py::tuple identify_turning(const std::filesystem::path& file,
                           const std::vector<std::array<double, 3>>& stock, int channel,
                           int spindle, double coefficient_n) {
  jobs::StockTable table;
  for (const auto& [z_mm, radius_mm, hardness_hb] : stock) {
    const bool falls = table.steps.empty() || z_mm < table.steps.back().z_mm;
    const bool has_hardness = hardness_hb > 0.0;
    if (!falls || !(radius_mm > 0.0) ||
        (!table.steps.empty() && has_hardness != (table.steps.back().hardness_hb > 0.0))) {
      throw std::invalid_argument(
          "stock must be pairs of Z and radius in mm with falling Z, or all of them with a "
          "hardness "
          "in HB");
    }
    table.steps.push_back({.z_mm = z_mm, .radius_mm = radius_mm, .hardness_hb = hardness_hb});
  }
  if (table.steps.empty())
    throw std::invalid_argument("stock is empty; give pairs of Z and radius in mm");
  const auto found = identified(
      jobs::LoggedTurning{.log = file,
                          .reading = {.channel = channel, .spindle = spindle - 1, .stock = table},
                          .coefficient_n = coefficient_n});
  return py::make_tuple(report_text(jobs::identification_fields(found)),
                        column_arrays(found.rows, jobs::turning_row_columns()));
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string() + "; check the path");
  return {std::istreambuf_iterator<char>(file), {}};
}

// The report, the rows, and the file of tool and material with the figures that were found.
py::tuple identify_milling(const std::filesystem::path& file, const std::filesystem::path& cut_file,
                           int channel, int spindle, int tool, double efficiency) {
  const process::CuttingProcess cut = config::read_chatter_file(cut_file);
  if (cut.kind != process::CutKind::milling)
    throw std::invalid_argument(cut_file.string() +
                                " does not describe a milling cut; write kind = \"milling\"");
  const auto found = identified(jobs::LoggedMilling{
      .log = file,
      .reading = {.channel = channel, .spindle = spindle - 1, .cut = cut, .tool = tool},
      .cut_text = text_of_file(cut_file),
      .efficiency = efficiency});
  return py::make_tuple(report_text(jobs::identification_fields(found)),
                        column_arrays(found.rows, jobs::milling_row_columns()),
                        py::str(found.text));
}

// The report, the rows, and the process file with the figures that were found.
py::tuple identify_grinding(const std::filesystem::path& file,
                            const std::filesystem::path& process_file, int channel, int spindle,
                            std::optional<double> touch_mm, double watts_per_newton) {
  const process::DesignRequest sheet = config::read_grinding_file(process_file);
  const auto found =
      identified(jobs::LoggedPlunge{.log = file,
                                    .reading = {.channel = channel,
                                                .spindle = spindle - 1,
                                                .allowance_mm = sheet.allowance_mm,
                                                .touch_mm = touch_mm,
                                                .watts_per_newton = watts_per_newton},
                                    .sheet = sheet.process,
                                    .process_text = text_of_file(process_file)});
  return py::make_tuple(report_text(jobs::identification_fields(found)),
                        column_arrays(found.rows, jobs::plunge_row_columns()), py::str(found.text));
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
  return py::make_tuple(report_text(jobs::lobes_fields(study)),
                        column_arrays(study.limits, jobs::lobes_columns()));
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
