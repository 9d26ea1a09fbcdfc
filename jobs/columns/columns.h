// The columns of a result, in one table: what each value is called in every face (terminal,
// protocol, Python, files), how it is printed, and what becomes of it where rows are taken together
// for a picture.
//
//   const Columns<Place> columns{{"force_n", 1, Together::peak, force_of}};
//   thinned(places, 1200, columns), csv(places, columns)
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/columns/number_rows.h"

namespace stanok::jobs {

// Rows that are taken together have the value of the first of them, or the one farthest from 0.
enum class Together : unsigned char { first, peak };

template <class Row>
struct Column {
  std::string_view name;  // ends with its unit: force_n
  int decimals = 3;       // in a table of text
  Together together = Together::first;
  double (*value)(const Row&) = nullptr;
  std::string_view unit{};     // as people write it: "mm/min"; empty: none
  std::string_view meaning{};  // where a face tells it
};

template <class Row>
using Columns = std::vector<Column<Row>>;

// Those with these names, in this order. Throws std::invalid_argument where one is missing.
template <class Row>
[[nodiscard]] Columns<Row> columns_named(const Columns<Row>& all,
                                         std::initializer_list<std::string_view> names) {
  Columns<Row> chosen;
  for (const std::string_view name : names) {
    const auto found = std::ranges::find(all, name, &Column<Row>::name);
    if (found == all.end()) throw std::invalid_argument("no column " + std::string(name));
    chosen.push_back(*found);
  }
  return chosen;
}

// At most `most` rows (> 0), each of as many rows that follow one another. The extreme of a column
// that keeps its peaks is that of all rows.
template <class Row>
[[nodiscard]] NumberRows thinned(const std::vector<Row>& rows, std::size_t most,
                                 const Columns<Row>& columns) {
  const std::size_t span = (rows.size() + most - 1) / most;
  NumberRows numbers;
  for (std::size_t begin = 0; begin < rows.size(); begin += span) {
    const std::span<const Row> together(rows.data() + begin, std::min(span, rows.size() - begin));
    std::vector<double>& values = numbers.emplace_back();
    for (const Column<Row>& column : columns) {
      double value = column.value(together.front());
      if (column.together == Together::peak) {
        for (const Row& row : together) value = farther_from_zero(value, column.value(row));
      }
      values.push_back(value);
    }
  }
  return numbers;
}

// A table of text with a line of names, values separated by commas.
template <class Row>
[[nodiscard]] std::string csv(const std::vector<Row>& rows, const Columns<Row>& columns) {
  std::string text;
  std::vector<int> decimals;
  for (const Column<Row>& column : columns) {
    text.append(text.empty() ? "" : ",").append(column.name);
    decimals.push_back(column.decimals);
  }
  text += '\n';
  std::vector<double> values(columns.size());
  for (const Row& row : rows) {
    std::ranges::transform(columns, values.begin(),
                           [&](const Column<Row>& column) { return column.value(row); });
    append_line(text, values, decimals);
  }
  return text;
}

}  // namespace stanok::jobs
