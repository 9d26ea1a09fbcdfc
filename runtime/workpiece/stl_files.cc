#include "runtime/workpiece/stl_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/file_descriptor.h"
#include "base/place.h"
#include "base/system_error.h"
#include "lang/contract/blank_file.h"
#include "recording/format/log_description.h"
#include "simulation/solid/stl_solid.h"

namespace stanok::runtime {

Expected<std::string, std::string> bytes_of_stl(const std::string& path) {
  const auto refusal = [&path](int error) {
    return Unexpected("cannot read " + path + ": " + system_error_text(error));
  };
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return refusal(errno);
  struct stat status{};
  if (::fstat(file.number(), &status) != 0) return refusal(errno);
  if (!S_ISREG(status.st_mode)) return Unexpected(path + " is not a regular file");
  const std::size_t size = checked_size(status.st_size);
  if (size > simulation::stl_bytes_max)
    return Unexpected(path + ": " + simulation::stl_too_large(size).text);
  std::string bytes(size, '\0');
  std::size_t filled = 0;
  while (filled < size) {
    const ssize_t count = ::read(file.number(), bytes.data() + filled, size - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refusal(errno);
    if (count == 0) break;
    filled += checked_size(count);
  }
  bytes.resize(filled);
  return bytes;
}

Expected<std::string, Diagnostic> blank_text_of(std::string_view name, std::string_view bytes) {
  const auto solid = simulation::solid_of_stl(bytes);
  if (!solid) {
    Diagnostic diagnostic;
    diagnostic.code = solid.error().code;
    diagnostic.message = std::string(name) + ": " + solid.error().text;
    diagnostic.help = {solid.error().help};
    return Unexpected(std::move(diagnostic));
  }
  lang::BlankFile file;
  file.fingerprint = recording::text_hash(bytes);
  std::copy_n(solid->low.data(), 3, file.low.begin());
  std::copy_n(solid->high.data(), 3, file.high.begin());
  return lang::text_of(file);
}

}  // namespace stanok::runtime
