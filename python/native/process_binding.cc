// What logs tell of the cutting process, for Python: an array for each column of
// jobs/log_tables/process_columns.h, and what the columns mean.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <tuple>
#include <type_traits>

#include "jobs/log_tables/process_columns.h"
#include "python/native/bindings.h"
#include "python/native/faults.h"

namespace stanok::python {
namespace {

namespace py = pybind11;

// Name, unit and meaning of each.
std::vector<std::tuple<std::string, std::string, std::string>> process_column_texts() {
  std::vector<std::tuple<std::string, std::string, std::string>> list;
  for (const auto& column : jobs::process_columns())
    list.emplace_back(column.name, column.unit, column.meaning);
  return list;
}

struct ProcessArrays {
  std::vector<std::int64_t> cycle;
  std::vector<std::vector<double>> numbers;  // of each column, empty for the cycle
};

Expected<ProcessArrays, recording::LogError> read_process_rows(const std::filesystem::path& file,
                                                               int channel) {
  auto rows = jobs::ProcessRows::open(file, channel);
  if (!rows) return Unexpected<recording::LogError>(rows.error());
  ProcessArrays arrays;
  arrays.numbers.resize(jobs::process_columns().size());
  while (const auto row = rows->next()) {
    jobs::visit_numbers(*row, [&]<class Number>(std::size_t place, Number number) {
      if constexpr (std::is_same_v<Number, std::int64_t>) {
        arrays.cycle.push_back(number);
      } else {
        arrays.numbers[place].push_back(number);
      }
    });
  }
  return arrays;
}

template <class Number>
py::array array_of_numbers(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::dict process_rows(const std::filesystem::path& file, int channel) {
  Expected<ProcessArrays, recording::LogError> arrays =
      Unexpected<recording::LogError>(recording::LogError{});
  {
    const py::gil_scoped_release others_run;
    arrays = read_process_rows(file, channel);
  }
  if (!arrays) {
    raise("LogError", nlohmann::ordered_json::array({fault_json("", arrays.error().text)}));
  }
  py::dict by_name;
  for (std::size_t k = 0; k < jobs::process_columns().size(); ++k) {
    const auto& column = jobs::process_columns()[k];
    by_name[py::str(std::string(column.name))] = jobs::is_cycle(column)
                                                     ? array_of_numbers(arrays->cycle)
                                                     : array_of_numbers(arrays->numbers[k]);
  }
  return by_name;
}

}  // namespace

void bind_process(py::module_& module) {
  module.def("process_columns", &process_column_texts);
  module.def("process_rows", &process_rows, py::arg("file"), py::arg("channel"));
}

}  // namespace stanok::python
