#include "recording/read/csv_rows.h"

#include <cmath>
#include <cstddef>

namespace stanok::recording {
namespace {

constexpr std::size_t write_threshold = 1UL << 16;  // bytes
constexpr double whole_max = 1e15;                  // with all of its digits

}  // namespace

void CsvRows::add_known(double value) {
  if (std::isnan(value)) return add_text("");
  if (std::abs(value) >= whole_max || value != std::trunc(value)) return add(value);
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed)
          .ptr;
  add_text({digits.data(), end});
}

void CsvRows::add_text(std::string_view text) {
  if (!is_row_start_) text_ += ',';
  text_ += text;
  is_row_start_ = false;
}

void CsvRows::end_row() {
  text_ += '\n';
  is_row_start_ = true;
  if (text_.size() > write_threshold) write();
}

bool CsvRows::finish() {
  write();
  return is_good_ && std::fflush(csv_) == 0;
}

void CsvRows::write() {
  is_good_ = is_good_ && std::fwrite(text_.data(), 1, text_.size(), csv_) == text_.size();
  text_.clear();
}

}  // namespace stanok::recording
