#include "web/server/page_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace stanok::web {
namespace {

namespace fs = std::filesystem;

constexpr auto media_types = std::to_array<std::pair<std::string_view, std::string_view>>({
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".webmanifest", "application/manifest+json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".ico", "image/vnd.microsoft.icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".txt", "text/plain; charset=utf-8"},
    {".md", "text/plain; charset=utf-8"},
});

std::string media_type_of(const fs::path& file) {
  const std::string extension = file.extension().string();
  const auto* const row = std::find_if(media_types.begin(), media_types.end(),
                                       [&](const auto& one) { return one.first == extension; });
  return std::string(row == media_types.end() ? "application/octet-stream" : row->second);
}

std::shared_ptr<const std::string> content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::make_shared<const std::string>(std::istreambuf_iterator<char>(stream),
                                             std::istreambuf_iterator<char>());
}

fs::file_time_type time_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? fs::file_time_type{} : time;
}

// A folder of the installation, else of the source tree of a build.
fs::path beside_the_program(const char* installed, const char* in_the_tree) {
  std::error_code ignored;
  const fs::path programs = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* candidate : {installed, in_the_tree}) {
    const fs::path folder = (programs / candidate).lexically_normal();
    if (fs::is_directory(folder, ignored)) return folder;
  }
  return (programs / installed).lexically_normal();
}

}  // namespace

PageFiles::PageFiles(fs::path folder, std::string_view front)
    : folder_(std::move(folder)), front_('/' + std::string(front)) {
  read();
}

void PageFiles::read() {
  files_.clear();
  bytes_ = 0;
  read_at_ = time_of(folder_ / front_.substr(1));
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator(folder_, error);
       !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry->symlink_status(error).type() == fs::file_type::regular) add(entry->path());
  }
}

void PageFiles::add(const fs::path& file) {
  std::error_code error;
  bytes_ += fs::file_size(file, error);
  if (error || bytes_ > bytes_max) return;
  const std::string path = '/' + fs::relative(file, folder_, error).generic_string();
  if (path.ends_with(".gz")) {
    files_[path.substr(0, path.size() - 3)].compressed = content_of(file);
    return;
  }
  PageFile& entry = files_[path];
  entry.media_type = media_type_of(file);
  entry.is_hashed = path.starts_with("/assets/");
  entry.content = content_of(file);
}

const PageFile* PageFiles::find(std::string_view path) {
  if (path == "/") path = front_;
  if (path == front_ && time_of(folder_ / front_.substr(1)) != read_at_) read();
  const auto found = files_.find(path);
  // Compressed files alone are none.
  return found == files_.end() || found->second.content == nullptr ? nullptr : &found->second;
}

fs::path usual_page_folder() {
  return beside_the_program("../share/stanok/panel", "../../../panel/dist");
}

fs::path usual_manual_folder() {
  return beside_the_program("../share/doc/stanok/docs", "../../../docs");
}

}  // namespace stanok::web
