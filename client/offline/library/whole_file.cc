#include "client/offline/library/whole_file.h"

#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace stanok::client {
namespace {

namespace fs = std::filesystem;

// Two computers that share a folder may have processes of the same number.
std::string mark_of_this_process() {
  std::array<char, 256> host{};
  static_cast<void>(::gethostname(host.data(), host.size() - 1));
  return "." + std::string(host.data()) + "." + std::to_string(::getpid());
}

}  // namespace

bool write_whole(const fs::path& file, std::string_view bytes) {
  const fs::path fresh = file.string() + mark_of_this_process();
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  std::ofstream stream(fresh, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  const bool is_written = !stream.fail();
  if (is_written) fs::rename(fresh, file, error);
  if (is_written && !error) return true;
  std::error_code ignored;
  fs::remove(fresh, ignored);
  return false;
}

std::string bytes_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace stanok::client
