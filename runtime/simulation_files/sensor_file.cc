#include "runtime/simulation_files/sensor_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/place.h"

namespace stanok::runtime {
namespace {

using channels::SpindleSensors;

constexpr int no_spindle = -1;  // the column is t

struct Quantity {
  std::string_view name;
  double SpindleSensors::* value;
};
constexpr std::array quantities{Quantity{"power_w", &SpindleSensors::power_w},
                                Quantity{"vibration_um", &SpindleSensors::vibration_um},
                                Quantity{"vibration_hz", &SpindleSensors::vibration_hz}};

struct Column {
  int spindle = no_spindle;  // index in the machine
  double SpindleSensors::* value = nullptr;
};

struct Cell {
  std::string_view text;
  std::size_t column = 1;  // place in the line, in characters
};

// One line of the file; says where it is when it throws.
struct Line {
  const std::string& path;
  int number;
  std::string_view text;

  [[noreturn]] void refuse(const Cell& cell, const std::string& reason) const {
    throw std::runtime_error(path + ":" + std::to_string(number) + ":" +
                             std::to_string(cell.column) + ": " + reason);
  }

  [[nodiscard]] std::vector<Cell> cells() const {
    std::vector<Cell> found;
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      std::string_view cell = text.substr(begin, end - begin);
      const std::size_t first = std::min(cell.find_first_not_of(" \t"), cell.size());
      cell.remove_prefix(first);
      cell = cell.substr(0, cell.find_last_not_of(" \t") + 1);
      found.push_back({cell, begin + first + 1});
      begin = end + 1;
    }
    return found;
  }

  [[nodiscard]] double number_of(const Cell& cell) const {
    double value = 0.0;
    const auto [rest, error] = std::from_chars(cell.text.begin(), cell.text.end(), value);
    if (error != std::errc{} || rest != cell.text.end() || !std::isfinite(value))
      refuse(cell, "'" + std::string(cell.text) + "' is not a number");
    return value;
  }
};

int spindle_of_column(const Line& line, const Cell& cell, std::string_view suffix,
                      const std::vector<channels::SpindleConfig>& spindles) {
  if (spindles.empty()) line.refuse(cell, "the machine has no spindle");
  if (suffix.empty()) return 0;
  const auto spindle = std::find_if(spindles.begin(), spindles.end(), [&](const auto& one) {
    return "." + std::to_string(one.id) == suffix;
  });
  if (spindle == spindles.end())
    line.refuse(cell, "the machine has no spindle " + std::string(suffix.substr(1)));
  return static_cast<int>(spindle - spindles.begin());
}

Column column_of(const Line& line, const Cell& cell,
                 const std::vector<channels::SpindleConfig>& spindles) {
  const std::size_t dot = std::min(cell.text.find('.'), cell.text.size());
  const std::string_view name = cell.text.substr(0, dot);
  for (const Quantity& quantity : quantities) {
    if (quantity.name != name) continue;
    return {spindle_of_column(line, cell, cell.text.substr(dot), spindles), quantity.value};
  }
  line.refuse(cell, "'" + std::string(cell.text) +
                        "' is no sensor; t, power_w, vibration_um and vibration_hz are known");
}

std::vector<Column> head_of(const Line& line,
                            const std::vector<channels::SpindleConfig>& spindles) {
  const std::vector<Cell> cells = line.cells();
  if (cells.front().text != "t") line.refuse(cells.front(), "the first column must be t");
  std::vector<Column> columns(1);
  for (std::size_t k = 1; k < cells.size(); ++k)
    columns.push_back(column_of(line, cells[k], spindles));
  return columns;
}

SensorRow row_of(const Line& line, const std::vector<Column>& columns, std::size_t spindles) {
  const std::vector<Cell> cells = line.cells();
  if (cells.size() != columns.size()) {
    line.refuse(cells.back(), std::to_string(cells.size()) + " values under " +
                                  std::to_string(columns.size()) + " columns");
  }
  SensorRow row;
  row.spindles.resize(spindles);
  row.t = line.number_of(cells[0]);
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (cells[k].text.empty()) continue;
    row.spindles[checked_size(columns[k].spindle)].*columns[k].value = line.number_of(cells[k]);
  }
  return row;
}

}  // namespace

std::vector<SensorRow> read_sensor_file(const std::string& path,
                                        const std::vector<channels::SpindleConfig>& spindles) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<SensorRow> rows;
  std::vector<Column> columns;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.find_first_not_of(" \t") == std::string::npos || text.front() == '#') continue;
    const Line line{path, number, text};
    if (columns.empty()) {
      columns = head_of(line, spindles);
      continue;
    }
    rows.push_back(row_of(line, columns, spindles.size()));
    if (rows.size() > 1 && rows.back().t < rows[rows.size() - 2].t)
      line.refuse({text, 1}, "t goes back; the rows must ascend in time");
  }
  if (columns.empty()) throw std::runtime_error(path + ":1:1: the head line is missing: t,power_w");
  return rows;
}

}  // namespace stanok::runtime
