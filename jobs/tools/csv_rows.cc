#include "jobs/tools/csv_rows.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"
#include "jobs/tools/foreign_text.h"

namespace stanok::jobs {
namespace {

char separator_of(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n'));
  constexpr std::array separators{',', ';', '\t'};
  return *std::ranges::max_element(
      separators, {}, [&](char separator) { return std::ranges::count(first, separator); });
}

// Reads cell after cell.
class CellReader {
 public:
  CellReader(std::string_view text, char separator, ForeignReader& reader)
      : text_(text), separator_(separator), reader_(reader) {}

  [[nodiscard]] bool is_at_end() const { return at_ == text_.size(); }

  CsvRow row() {
    CsvRow row;
    bool goes_on = true;
    while (goes_on) {
      const ForeignPlace place = here();
      row.push_back({cell(place), place});
      goes_on = !is_at_end() && text_[at_] == separator_;
      if (goes_on) step();
    }
    if (!is_at_end() && text_[at_] == '\r') step();
    if (!is_at_end() && text_[at_] == '\n') step();
    return row;
  }

 private:
  [[nodiscard]] ForeignPlace here() const { return {line_, column_}; }

  void step() {
    const char passed = text_[at_++];
    if (passed == '\n') {
      ++line_;
      column_ = 1;
    } else if (at_ == text_.size() || !continues_character(text_[at_])) {
      ++column_;
    }
  }

  std::string cell(const ForeignPlace& place) {
    std::string text;
    if (!is_at_end() && text_[at_] == '"') text = quoted_cell(place);
    while (!is_at_end() && text_[at_] != separator_ && text_[at_] != '\r' && text_[at_] != '\n') {
      text += text_[at_];
      step();
    }
    return std::string(trimmed(text));
  }

  std::string quoted_cell(const ForeignPlace& place) {
    std::string text;
    step();
    while (!is_at_end()) {
      const char letter = text_[at_];
      step();
      if (letter != '"') {
        text += letter;
      } else if (!is_at_end() && text_[at_] == '"') {
        text += '"';
        step();
      } else {
        return text;
      }
    }
    reader_.fault(place, "a quote that is not closed; write a quote within quotes twice");
    return text;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  char separator_;
  ForeignReader& reader_;
  unsigned line_ = 1;
  unsigned column_ = 1;
};

}  // namespace

CsvRows csv_rows(std::string_view text, ForeignReader& reader) {
  CsvRows found{.separator = separator_of(text), .rows = {}};
  CellReader cells(text, found.separator, reader);
  while (!cells.is_at_end()) {
    CsvRow row = cells.row();
    const bool has_any =
        std::ranges::any_of(row, [](const CsvCell& cell) { return !cell.text.empty(); });
    if (has_any) found.rows.push_back(std::move(row));
  }
  return found;
}

std::optional<double> number_of_cell(std::string_view text, char separator) {
  std::string written(text);
  if (separator != ',' && std::ranges::count(written, ',') == 1 &&
      written.find('.') == std::string::npos) {
    std::ranges::replace(written, ',', '.');
  }
  return number_of_text(written);
}

std::string csv_cell(std::string_view text) {
  const bool is_plain = text.find_first_of(",;\t\"\r\n") == std::string_view::npos;
  if (is_plain) return std::string(text);
  std::string cell = "\"";
  for (const char letter : text) cell += letter == '"' ? "\"\"" : std::string(1, letter);
  return cell + "\"";
}

}  // namespace stanok::jobs
