#include "process/grinding/control_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/place.h"
#include "process/grinding/boundary.h"
#include "process/grinding/control_line.h"
#include "process/grinding/number_text.h"

namespace stanok::process {
namespace {

constexpr const char* malformed = "E9101";
constexpr const char* out_of_range = "E9102";

constexpr int rows_max = 10000;

// Labels and decimals of the paper's figure 9; the numbers are replaced.
constexpr std::string_view paper_form =
    "0.0 - радиус детали\n"
    "0.0 - ширина заготовки\n"
    "0.0 - радиус шлифовального круга\n"
    "0.0 - жесткость ТОС\n"
    "0.0 - приведенная масса\n"
    "0.0 - коэффициент вязкого трения\n"
    "0.0 - частота вращения заготовки\n"
    "0.000 - Cp\n"
    "0.000 - α } данные силовой характеристики\n"
    "0.000\n"
    "0.000\n"
    "0.000 } данные граничного алгоритма\n"
    "0 - количество точек переключения\n"
    "0.0000 0.0000\n"
    "0.0000 0.0000 } данные УП\n";

std::vector<ControlLine> paper_lines() {
  const std::size_t sheet = process_quantities().size() + 1;
  std::vector<ControlLine> lines;
  for (const std::string_view line : lines_of(paper_form)) {
    lines.push_back(split_line(line, lines.size() < sheet ? 1 : 2));
  }
  return lines;
}

std::string_view without_end(std::string_view line) {
  const std::size_t last = line.find_last_not_of("\r\n");
  return line.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

// Bytes before a number of a line, or before what stands in its place.
std::size_t offset_of(const ControlLine& line, std::size_t number) {
  std::size_t offset = 0;
  const std::size_t before = std::min(number, line.numbers.size());
  for (std::size_t k = 0; k < before; ++k) {
    offset += line.between[k].size() + line.numbers[k].size();
  }
  const std::string& next = line.between[before];
  return offset + std::min(next.find_first_not_of(" \t"), next.size());
}

class ControlReader {
 public:
  ControlReader(std::string_view text, const std::string& name)
      : name_(name), source_(lines_of(text)) {}

  [[nodiscard]] Expected<ControlFile, Diagnostics> read() && {
    read_sheet();
    if (diagnostics_.empty()) read_rows();
    if (diagnostics_.empty()) expect_end();
    if (diagnostics_.empty()) check_limits();
    if (!diagnostics_.empty()) return Unexpected<Diagnostics>(std::move(diagnostics_));
    return std::move(file_);
  }

 private:
  // The next line that is not blank, split; an error when there is none.
  ControlLine* next_line(int numbers_wanted, const std::string& wanted) {
    while (next_ < source_.size() && is_blank(source_[next_])) {
      file_.lines.push_back(split_line(source_[next_++], 0));
    }
    if (next_ == source_.size()) {
      refuse(malformed, "the file ends here; expected " + wanted, 0);
      return nullptr;
    }
    file_.lines.push_back(split_line(source_[next_++], numbers_wanted));
    ControlLine& line = file_.lines.back();
    if (static_cast<int>(line.numbers.size()) < numbers_wanted) {
      refuse(malformed, "expected " + wanted, line.numbers.size());
      return nullptr;
    }
    return &line;
  }

  // The value of a number of the current line; nothing, and an error, when it is none.
  std::optional<double> value(const ControlLine& line, std::size_t index,
                              const std::string& wanted) {
    const std::string& number = line.numbers[index];
    const double value = value_of(number);
    if (std::isfinite(value)) return value;
    const bool has_comma = number.find(',') != std::string::npos;
    refuse(malformed,
           "'" + number + "' is not a number; expected " + wanted +
               (has_comma ? ", with a point and not a comma" : ""),
           index);
    return std::nullopt;
  }

  void read_sheet() {
    for (const ProcessQuantity& quantity : process_quantities()) {
      const std::string wanted = std::string(quantity.key) + ", " + std::string(quantity.meaning) +
                                 ": " + range_text(quantity);
      const ControlLine* line = next_line(1, wanted);
      if (line == nullptr) return;
      sheet_lines_.push_back(next_);
      const auto number = value(*line, 0, wanted);
      if (number) file_.process.*quantity.value = *number;
    }
    if (!diagnostics_.empty()) return;
    for (const ProcessFault& fault : range_faults(file_.process)) refuse_sheet(fault);
    read_count();
  }

  void read_count() {
    const std::string wanted = "the number of intervals, one less than the rows that follow";
    const ControlLine* line = next_line(1, wanted);
    if (line == nullptr) return;
    const auto number = value(*line, 0, wanted);
    if (!number) return;
    if (*number != std::floor(*number) || *number < 1.0 || *number > rows_max) {
      refuse(out_of_range,
             line->numbers[0] + " intervals; expected a whole number from 1 to " +
                 std::to_string(rows_max),
             0);
      return;
    }
    intervals_ = static_cast<int>(*number);
  }

  void read_rows() {
    for (int k = 0; k <= intervals_; ++k) {
      const std::string wanted = "row " + std::to_string(k + 1) + " of " +
                                 std::to_string(intervals_ + 1) + ": X in mm and feed in mm/s";
      const ControlLine* line = next_line(2, wanted);
      if (line == nullptr) return;
      const auto x_mm = value(*line, 0, wanted);
      const auto feed = value(*line, 1, wanted);
      if (!x_mm || !feed) continue;
      check_row(*line, {*x_mm, *feed});
      file_.law.push_back({*x_mm, *feed});
    }
  }

  void check_row(const ControlLine& line, const InfeedRow& row) {
    const std::string x = "X " + line.numbers[0] + " mm";
    if (file_.law.empty() && !(row.x_mm > 0.0 && row.x_mm <= allowance_max_mm)) {
      refuse(out_of_range,
             x + " in the first row; it is the allowance per side: above 0 to " +
                 number_text(allowance_max_mm) + " mm",
             0);
    } else if (!file_.law.empty() && row.x_mm > file_.law.back().x_mm) {
      refuse(out_of_range,
             x + " rises from " + number_text(file_.law.back().x_mm) +
                 "; X falls from row to row, or is the same for a jump of the feed",
             0);
    } else if (row.x_mm < -allowance_max_mm) {
      refuse(out_of_range, x + "; the overrun is at most " + number_text(allowance_max_mm) + " mm",
             0);
    }
    if (row.feed_mm_per_s > 0.0 && row.feed_mm_per_s <= feed_max_mm_per_s) return;
    const double meant = row.feed_mm_per_s / 60.0;
    const bool is_slip = meant > 0.0 && meant <= feed_max_mm_per_s;
    refuse(
        out_of_range,
        "feed " + line.numbers[1] + " mm/s; it must be above 0 and at most " +
            number_text(feed_max_mm_per_s) + " mm/s" +
            (is_slip ? "; " + line.numbers[1] + " mm/min would be " + rounded_text(meant, 5) : ""),
        1);
  }

  void expect_end() {
    for (; next_ < source_.size(); ++next_) {
      file_.lines.push_back(split_line(source_[next_], 0));
      if (is_blank(source_[next_])) continue;
      ++next_;
      refuse(malformed,
             "more lines than the " + std::to_string(intervals_) +
                 " intervals say; expected the end of the file",
             0);
      return;
    }
  }

  void check_limits() {
    if (file_.law.front().x_mm == file_.law.back().x_mm) {
      refuse(out_of_range, "the table does not move: first and last X are the same", 0);
    }
    for (const ProcessFault& fault : boundary_faults(file_.process, file_.allowance_mm())) {
      refuse_sheet(fault);
    }
  }

  // At a number of the line read last.
  void refuse(const char* code, std::string message, std::size_t number) {
    refuse_at(next_, number, code, std::move(message));
  }
  void refuse_sheet(const ProcessFault& fault) {
    std::size_t index = 0;
    while (process_quantities()[index].key != fault.key) ++index;
    refuse_at(sheet_lines_[index], 0, out_of_range, fault.text);
  }

  // `line` from 1; 0: the file has none.
  void refuse_at(std::size_t line, std::size_t number, const char* code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.code = code;
    diagnostic.message = std::move(message);
    diagnostic.place.file = name_;
    if (line > 0) {
      diagnostic.source_line = without_end(source_[line - 1]);
      const ControlLine parts = split_line(diagnostic.source_line, 2);
      const bool is_there = number < parts.numbers.size();
      const int column = static_cast<int>(offset_of(parts, number)) + 1;
      const int width = is_there ? static_cast<int>(parts.numbers[number].size()) : 1;
      diagnostic.place.line = diagnostic.place.end_line = static_cast<int>(line);
      diagnostic.place.column = column;
      diagnostic.place.end_column = column + width;
    }
    diagnostics_.push_back(std::move(diagnostic));
  }

  const std::string& name_;
  std::vector<std::string_view> source_;
  std::size_t next_ = 0;
  std::vector<std::size_t> sheet_lines_;  // line of each quantity, from 1
  int intervals_ = 0;
  ControlFile file_;
  Diagnostics diagnostics_;
};

bool is_row(const ControlLine& line) {
  return line.numbers.size() == 2;
}

// Another number of rows than the table had: the last one as the last one was, the others as the
// first.
std::string table_text(const std::vector<ControlLine>& lines, const InfeedLaw& law) {
  const auto first = std::ranges::find_if(lines, is_row);
  const auto last = std::ranges::find_if(lines.rbegin(), lines.rend(), is_row);
  std::string text;
  for (std::size_t k = 0; k < law.size(); ++k) {
    const ControlLine& like = k + 1 < law.size() ? *first : *last;
    text += line_text(like, {law[k].x_mm, law[k].feed_mm_per_s});
  }
  return text;
}

}  // namespace

Expected<ControlFile, Diagnostics> read_control_text(std::string_view text,
                                                     const std::string& name) {
  return ControlReader(text, name).read();
}

std::string control_text(const ControlFile& file) {
  const std::vector<ControlLine> lines = file.lines.empty() ? paper_lines() : file.lines;
  std::vector<double> sheet;
  for (const ProcessQuantity& quantity : process_quantities()) {
    sheet.push_back(file.process.*quantity.value);
  }
  sheet.push_back(static_cast<double>(file.law.size()) - 1.0);
  const auto rows = checked_size(std::ranges::count_if(lines, is_row));
  std::string text;
  std::size_t quantity = 0;
  std::size_t row = 0;
  for (const ControlLine& line : lines) {
    if (line.numbers.empty()) {
      text += line.between.back();
    } else if (!is_row(line)) {
      text += line_text(line, {sheet[quantity++]});
    } else if (rows == file.law.size()) {
      text += line_text(line, {file.law[row].x_mm, file.law[row].feed_mm_per_s});
      ++row;
    } else if (row++ == 0) {
      text += table_text(lines, file.law);
    }
  }
  return text;
}

}  // namespace stanok::process
