#include "web/server/page_files.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "web/access/secret_text.h"

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

bool is_text(std::string_view media_type) {
  return media_type.starts_with("text/") || media_type.starts_with("application/json") ||
         media_type.ends_with("+xml") || media_type.ends_with("+json") ||
         media_type == "application/wasm";
}

// RFC 1952. nullptr: it saves less than a packet.
std::shared_ptr<const std::string> gzip(const std::string& content) {
  constexpr std::size_t saved_min = 1400;
  constexpr int window_of_gzip = 15 + 16;  // zlib.h, deflateInit2
  constexpr int memory_level = 9;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_of_gzip, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    return nullptr;
  std::string small(deflateBound(&stream, content.size()), '\0');
  // zlib changes nothing of its input.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(small.data());
  stream.avail_out = static_cast<uInt>(small.size());
  const bool is_done = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  small.resize(stream.total_out);
  deflateEnd(&stream);
  if (!is_done || small.size() + saved_min > content.size()) return nullptr;
  return std::make_shared<const std::string>(std::move(small));
}

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
  for (auto& [path, file] : files_) {
    if (file.content != nullptr) finish(file);
  }
}

void PageFiles::finish(PageFile& file) {
  if (file.compressed == nullptr && is_text(file.media_type)) file.compressed = gzip(*file.content);
  const SecretHash hash = hash_of(*file.content);
  constexpr std::size_t tag_bytes = 16;
  for (std::size_t k = 0; k < tag_bytes; ++k) file.tag += fmt::format("{:02x}", hash[k]);
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
