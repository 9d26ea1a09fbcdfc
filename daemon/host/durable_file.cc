#include "daemon/host/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/file_descriptor.h"
#include "base/place.h"
#include "base/system_error.h"
#include "recording/format/log_description.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;

constexpr ::mode_t file_mode = 0640;
constexpr std::string_view mark = "# stanok";

std::string with_heading(const DurableKind& kind, std::string_view text) {
  std::string whole(mark);
  whole.append(" ").append(kind.name).append(" ").append(std::to_string(kind.version));
  whole.append(" checksum ").append(text_checksum(text)).append("\n").append(text);
  return whole;
}

int write_new(const fs::path& file, std::string_view bytes) {
  const FileDescriptor made(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, file_mode));
  if (made.number() < 0) return errno;
  if (const int error = write_bytes(made.number(), bytes); error != 0) return error;
  return ::fsync(made.number()) == 0 ? 0 : errno;
}

// A link first: the file itself is never away.
int keep_previous(const fs::path& file) {
  const fs::path link = file.string() + ".link";
  ::unlink(link.c_str());
  if (::link(file.c_str(), link.c_str()) != 0) return errno == ENOENT ? 0 : errno;
  return ::rename(link.c_str(), previous_copy(file).c_str()) == 0 ? 0 : errno;
}

// Why a copy cannot be used; its text otherwise.
struct Copy {
  bool exists = false;
  bool is_good = false;
  bool is_newer = false;
  int version = 0;
  std::string text;
  std::string fault;
};

Copy read_copy(const fs::path& file, const DurableKind& kind) {
  Copy copy;
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream.is_open()) {
    copy.exists = errno != ENOENT;
    copy.fault = "cannot be opened: " + system_error_text(errno);
    return copy;
  }
  copy.exists = true;
  std::string heading;
  std::getline(stream, heading);
  copy.text.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  std::istringstream words(heading);
  std::string hash;
  std::string program;
  std::string name;
  std::string word;
  std::string sum;
  int& version = copy.version;
  words >> hash >> program >> name >> version >> word >> sum;
  const bool is_ours = hash + " " + program == mark && name == kind.name && word == "checksum";
  copy.is_newer = is_ours && version > kind.version;
  copy.is_good = is_ours && version >= 1 && !copy.is_newer && sum == text_checksum(copy.text);
  if (copy.is_newer) {
    copy.fault = "has version " + std::to_string(version) +
                 ", which is newer than this stanok supports (" + std::to_string(kind.version) +
                 ")";
  } else if (!is_ours) {
    copy.fault = "does not begin with its kind and checksum";
  } else if (!copy.is_good) {
    copy.fault = "does not match the checksum that it states";
  }
  return copy;
}

}  // namespace

std::string text_checksum(std::string_view text) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx",
                static_cast<unsigned long long>(recording::text_hash(text)));
  return digits;
}

// Each new one is an entry of the one above it.
int make_folder_durably(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  if (error) return error.value();
  fs::path made;
  for (const fs::path& part : whole) {
    const fs::path above = made;
    made /= part;
    if (!fs::create_directory(made, error) || part.empty()) {
      if (error) return error.value();
      continue;
    }
    if (const int fault = sync_folder(above); fault != 0) return fault;
  }
  return 0;
}

int write_bytes(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return ENOSPC;
    bytes.remove_prefix(checked_size(count));
  }
  return 0;
}

int sync_folder(const fs::path& folder) {
  const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() < 0) return errno;
  return ::fsync(opened.number()) == 0 ? 0 : errno;
}

fs::path previous_copy(const fs::path& file) {
  return file.string() + ".previous";
}

std::optional<std::string> write_durably(const fs::path& file, const DurableKind& kind,
                                         std::string_view text) {
  const fs::path made = file.string() + ".new";
  if (const int error = write_new(made, with_heading(kind, text)); error != 0) {
    ::unlink(made.c_str());
    return made.string() + ": " + system_error_text(error);
  }
  if (const int error = keep_previous(file); error != 0)
    return previous_copy(file).string() + ": " + system_error_text(error);
  if (::rename(made.c_str(), file.c_str()) != 0)
    return file.string() + ": " + system_error_text(errno);
  if (const int error = sync_folder(file.parent_path()); error != 0)
    return file.parent_path().string() + ": " + system_error_text(error);
  return std::nullopt;
}

Expected<std::optional<DurableText>, std::string> read_durably(const fs::path& file,
                                                               const DurableKind& kind) {
  using Result = Expected<std::optional<DurableText>, std::string>;
  Copy copy = read_copy(file, kind);
  if (copy.is_good) return Result(DurableText{std::move(copy.text), copy.version, ""});
  if (copy.is_newer) {
    return Unexpected<std::string>(file.string() + " " + copy.fault +
                                   "; start the newer stanok, or move the file away");
  }
  Copy previous = read_copy(previous_copy(file), kind);
  if (previous.is_good) {
    const std::string what = copy.exists ? " " + copy.fault : " is missing";
    return Result(DurableText{std::move(previous.text), previous.version,
                              file.string() + what + "; its previous copy is used"});
  }
  if (!copy.exists && !previous.exists) return Result(std::nullopt);
  return Unexpected<std::string>((copy.exists ? file : previous_copy(file)).string() + " " +
                                 (copy.exists ? copy.fault : previous.fault) +
                                 ", and there is no good previous copy; restore it, or move it "
                                 "away to start with the values of the machine file");
}

}  // namespace stanok::daemon
