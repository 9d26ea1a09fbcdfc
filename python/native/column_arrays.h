// Rows of a job as arrays of Python: one for each column of its table, by its name.
#pragma once

#include <pybind11/numpy.h>

#include <algorithm>
#include <string>
#include <vector>

#include "jobs/columns/columns.h"

namespace stanok::python {

template <class Row>
[[nodiscard]] pybind11::dict column_arrays(const std::vector<Row>& rows,
                                           const jobs::Columns<Row>& columns) {
  pybind11::dict arrays;
  for (const jobs::Column<Row>& column : columns) {
    pybind11::array_t<double> array(static_cast<pybind11::ssize_t>(rows.size()));
    std::ranges::transform(rows, array.mutable_data(), column.value);
    arrays[pybind11::str(std::string(column.name))] = std::move(array);
  }
  return arrays;
}

}  // namespace stanok::python
