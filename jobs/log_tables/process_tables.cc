#include <cerrno>
#include <string>
#include <vector>

#include "jobs/log_tables/log_tables.h"
#include "jobs/log_tables/process_columns.h"
#include "jobs/log_tables/table_faults.h"
#include "jobs/npz/npz_file.h"
#include "recording/read/csv_rows.h"

namespace stanok::jobs {
namespace {

// Calls `visit` for each; the reason why the log cannot be read.
template <class Visit>
std::optional<recording::LogError> for_each_process_row(const std::filesystem::path& log,
                                                        int channel, const Visit& visit) {
  auto rows = ProcessRows::open(log, channel);
  if (!rows) return rows.error();
  while (const auto row = rows->next()) visit(*row);
  return std::nullopt;
}

RowsOrError count_process_rows(const std::filesystem::path& log, int channel) {
  std::int64_t count = 0;
  const auto error =
      for_each_process_row(log, channel, [&](const ProcessRow& /*row*/) { ++count; });
  if (error) return Unexpected<recording::LogError>(*error);
  return count;
}

std::vector<NpyArray> process_arrays(std::int64_t count) {
  std::vector<NpyArray> arrays;
  for (const Column<ProcessRow>& column : process_columns()) {
    const std::string name(column.name);
    arrays.push_back(is_cycle(column) ? npy_array<std::int64_t>(name, {count})
                                      : npy_array<double>(name, {count}));
  }
  return arrays;
}

}  // namespace

RowsOrError write_process_csv(const std::filesystem::path& log, int channel, std::FILE* csv) {
  recording::CsvRows table(csv);
  for (const Column<ProcessRow>& column : process_columns()) table.add_text(column.name);
  table.end_row();
  std::int64_t count = 0;
  const auto error = for_each_process_row(log, channel, [&](const ProcessRow& row) {
    visit_numbers(row, [&](std::size_t /*place*/, auto number) { table.add_known(number); });
    table.end_row();
    ++count;
  });
  if (error) return Unexpected<recording::LogError>(*error);
  if (!table.finish())
    return Unexpected<recording::LogError>(recording::log_error("cannot write CSV", errno));
  return count;
}

RowsOrError write_process_npz(const std::filesystem::path& log, int channel,
                              const std::filesystem::path& npz) {
  auto count = count_process_rows(log, channel);
  if (!count) return count;
  const auto file = NpzFile::create(npz, process_arrays(*count));
  if (!file) return not_written(file.error());
  std::int64_t written = 0;
  const auto error = for_each_process_row(log, channel, [&](const ProcessRow& row) {
    if (written == *count) return;
    visit_numbers(row, [&](std::size_t place, auto number) { (*file)->add(place, number); });
    ++written;
  });
  if (error) return Unexpected<recording::LogError>(*error);
  if (written < *count) return has_changed(log);
  if (const auto fault = (*file)->finish()) return not_written(*fault);
  return count;
}

}  // namespace stanok::jobs
