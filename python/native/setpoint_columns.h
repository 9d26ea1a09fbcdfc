// Setpoints of one channel as columns: one array for each field of setpoint_t, a row for each
// cycle.
//
// What a run gives and what a log holds go through the same message and the same columns, so that a
// simulation in memory and its log have the same bits. Rows are those of `stanok log export`; a
// field of the axes becomes a matrix, a row of as many numbers as the channel has axes.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <stanok_messages/setpoint_t.hpp>
#include <string>
#include <variant>
#include <vector>

#include "recording/read/setpoint_fields.h"

namespace stanok::python {

using stanok::setpoint_t;

class SetpointColumns {
 public:
  // Throws std::invalid_argument for a name that is none; see `names`.
  explicit SetpointColumns(const std::vector<std::string>& names);

  // The first setpoint says how many axes there are.
  void add(const setpoint_t& setpoint, double time_s);
  [[nodiscard]] std::int64_t rows() const { return rows_; }

  // The arrays by name; the columns are empty afterwards.
  [[nodiscard]] pybind11::dict take();

  // Of all columns, in the order of `stanok log export`.
  [[nodiscard]] static std::vector<std::string> names();

 private:
  using Values =
      std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>,
                   std::vector<std::int16_t>, std::vector<std::int8_t>>;
  struct Column {
    const recording::SetpointField* field;
    Values values;
  };

  [[nodiscard]] static Values values_for(const recording::SetpointField::Source& source);
  void append(Column& column, const setpoint_t& setpoint, double time_s) const;

  std::vector<Column> columns_;
  std::int64_t rows_ = 0;
  int axis_count_ = 0;
};

}  // namespace stanok::python
