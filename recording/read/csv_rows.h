// CsvRows: rows of comma-separated numbers, gathered before they are written. Numbers have as many
// digits as are needed to read the same bits.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace stanok::recording {

class CsvRows {
 public:
  // `csv` outlives the rows.
  explicit CsvRows(std::FILE* csv) : csv_(csv) {}

  template <class Number>
  void add(Number value) {
    std::array<char, 32> digits{};  // enough for every double and 64-bit integer
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    add_text({digits.data(), end});
  }
  // Nothing for what is not a number; whole numbers without an exponent.
  void add_known(std::int64_t value) { add(value); }
  void add_known(double value);
  void add_text(std::string_view text);
  void end_row();
  // False when something could not be written, errno says why.
  bool finish();

 private:
  void write();

  std::FILE* csv_;
  std::string text_;
  bool is_row_start_ = true;
  bool is_good_ = true;
};

}  // namespace stanok::recording
