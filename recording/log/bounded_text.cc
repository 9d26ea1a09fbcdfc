#include "recording/log/bounded_text.h"

#include <fstream>
#include <system_error>

namespace stanok::recording {
namespace {

namespace fs = std::filesystem;

fs::path put_aside(const fs::path& file) {
  return file.parent_path() / (file.stem().string() + ".1" + file.extension().string());
}

bool write(const fs::path& file, std::string_view head, std::string_view line) {
  std::ofstream out(file, std::ios::app | std::ios::binary);
  out << head << line << std::flush;
  return out.good();
}

}  // namespace

std::string append_line(const BoundedText& text, std::string_view line) {
  std::error_code fault;
  fs::create_directories(text.file.parent_path(), fault);
  std::error_code none;
  auto size = static_cast<std::int64_t>(fs::file_size(text.file, none));
  if (none) size = 0;
  if (size > 0 && size + static_cast<std::int64_t>(line.size()) > text.size_max_bytes) {
    fs::rename(text.file, put_aside(text.file), fault);
    if (fault) return text.file.string() + " cannot be put aside: " + fault.message();
    size = 0;
  }
  if (write(text.file, size == 0 ? text.head : std::string_view(), line)) return {};
  // A full disk may have taken a part of it.
  if (fs::is_regular_file(text.file, none))
    fs::resize_file(text.file, static_cast<std::uintmax_t>(size), none);
  return text.file.string() + " cannot be written";
}

}  // namespace stanok::recording
