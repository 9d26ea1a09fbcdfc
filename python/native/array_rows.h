// Matrices of Python as rows of axes, and back.
#pragma once

#include <pybind11/numpy.h>

#include <stdexcept>
#include <string>

#include "base/axis_index.h"

namespace stanok::python {

using Matrix = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// Throws std::invalid_argument where `matrix` is not (n, columns).
inline void expect_columns(const Matrix& matrix, int columns, const char* name) {
  if (matrix.ndim() == 2 && matrix.shape(1) == columns) return;
  throw std::invalid_argument(std::string(name) + " must have the shape (n, " +
                              std::to_string(columns) + ")");
}

[[nodiscard]] inline Matrix matrix_like(const Matrix& matrix) {
  return Matrix({matrix.shape(0), matrix.shape(1)});
}

// The numbers of a row; `columns` of them.
[[nodiscard]] inline const double* row_of(const Matrix& matrix, pybind11::ssize_t row) {
  return matrix.data() + row * matrix.shape(1);
}
[[nodiscard]] inline double* row_of(Matrix& matrix, pybind11::ssize_t row) {
  return matrix.mutable_data() + row * matrix.shape(1);
}

}  // namespace stanok::python
