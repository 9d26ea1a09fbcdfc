#include "recording/read/csv_rows.h"

#include <cstddef>

namespace stanok::recording {
namespace {

constexpr std::size_t write_threshold = 1UL << 16;  // bytes

}  // namespace

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
