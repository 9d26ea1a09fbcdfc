// The columns of the rows of the process (process_rows.h): what `stanok log export --process`,
// .npz files and Python give.
//
// Names are those of process.status in the protocol, where it has the value. What a row does not
// have is not a number.
#pragma once

#include <cstddef>
#include <cstdint>

#include "jobs/columns/columns.h"
#include "jobs/log_tables/process_rows.h"

namespace stanok::jobs {

[[nodiscard]] const Columns<ProcessRow>& process_columns();

// The only column of whole numbers, which every row has: the cycle.
[[nodiscard]] bool is_cycle(const Column<ProcessRow>& column);

// Calls `visit` with the place of each column and its number: a double, or the cycle as
// std::int64_t.
template <class Visit>
void visit_numbers(const ProcessRow& row, const Visit& visit) {
  std::size_t place = 0;
  for (const Column<ProcessRow>& column : process_columns()) {
    if (is_cycle(column)) {
      visit(place, row.cycle);
    } else {
      visit(place, column.value(row));
    }
    ++place;
  }
}

}  // namespace stanok::jobs
