// Rows of a text of comma-separated values (RFC 4180), as spreadsheets write them.
//
// The separator is the comma, semicolon or tab that the first row has most of. Cells in quotes may
// have separators and line ends; a quote in them is written twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jobs/tools/foreign_reader.h"

namespace stanok::jobs {

struct CsvCell {
  std::string text;
  ForeignPlace place;
};
using CsvRow = std::vector<CsvCell>;

struct CsvRows {
  char separator = ',';
  std::vector<CsvRow> rows;  // none of them empty
};

// A quote that is not closed is a fault; the rows before it are there.
[[nodiscard]] CsvRows csv_rows(std::string_view text, ForeignReader& reader);

// A number, with a decimal comma where the cells are not separated by commas.
[[nodiscard]] std::optional<double> number_of_cell(std::string_view text, char separator);

// The text as a cell, in quotes where it needs them.
[[nodiscard]] std::string csv_cell(std::string_view text);

}  // namespace stanok::jobs
