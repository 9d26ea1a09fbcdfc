#include "daemon/desk/program_folder.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "base/file_descriptor.h"
#include "base/place.h"
#include "base/system_error.h"
#include "base/utf8.h"
#include "recording/format/log_description.h"
#include "runtime/program_files.h"

namespace stanok::daemon {
namespace {

namespace fs = std::filesystem;
using protocol::Failure;
using protocol::FailureKind;

constexpr ::mode_t for_group = 0664;

Failure cannot_write(const std::string& name, const std::string& reason) {
  return {FailureKind::refused, "E9020", "cannot write " + name + ": " + reason, 0, {}};
}

// The folder that a name stands in, opened beneath the root.
int open_folder(const fs::path& root, const fs::path& folder) {
  const FileDescriptor top(::open(root.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!top.is_open()) return -1;
  open_how how{};
  how.flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  const std::string path = folder.empty() ? "." : folder.string();
  return static_cast<int>(::syscall(SYS_openat2, top.number(), path.c_str(), &how, sizeof(how)));
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(checked_size(count));
  }
  return ::fsync(file) == 0;
}

// 0, or the error number; the file is then as it was.
int replace(int folder, const std::string& name, const std::string& text) {
  const std::string fresh = "." + name + ".new";
  ::unlinkat(folder, fresh.c_str(), 0);  // of a daemon that did not come to the end of it
  const FileDescriptor file(
      ::openat(folder, fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, for_group));
  if (!file.is_open()) return errno;
  const bool is_done = write_all(file.number(), text) &&
                       ::renameat(folder, fresh.c_str(), folder, name.c_str()) == 0;
  const int error = is_done ? 0 : errno;
  if (!is_done) ::unlinkat(folder, fresh.c_str(), 0);
  if (is_done) ::fsync(folder);
  return error;
}

// Where a program of that name is, or would be.
fs::path place_of_program(const fs::path& root, const std::string& name,
                          const std::optional<StoredProgram>& there) {
  return there ? there->path.lexically_relative(root.lexically_normal()) : fs::path(name);
}

}  // namespace

std::string version_of(const std::string& text) {
  std::array<char, 48> version{};
  std::snprintf(version.data(), version.size(), "%016llx-%zx",
                static_cast<unsigned long long>(recording::text_hash(text)), text.size());
  return version.data();
}

Failure failure_of_diagnostic(const Diagnostic& diagnostic) {
  return {FailureKind::program_error, diagnostic.code, diagnostic.message, 0, diagnostic.place};
}

Expected<std::optional<StoredProgram>, Failure> ProgramFolder::look(const std::string& name) const {
  const runtime::ProgramFiles files({root_}, format_);
  const auto found = files.read(name, "");
  if (found) {
    return std::optional(StoredProgram{(*found)->text, version_of((*found)->text), (*found)->path});
  }
  if (found.error().code == "E7001") return std::optional<StoredProgram>();
  return Unexpected<Failure>(failure_of_diagnostic(found.error()));
}

Expected<StoredProgram, Failure> ProgramFolder::read(const std::string& name) const {
  auto there = look(name);
  if (!there) return Unexpected<Failure>(there.error());
  if (*there) return std::move(**there);
  return Unexpected<Failure>(
      Failure{FailureKind::refused, "E7001", "the file was not found: " + name, 0, {}});
}

std::optional<Failure> ProgramFolder::conflict(const std::string& name,
                                               const std::optional<StoredProgram>& there,
                                               const ExpectedVersion& expected) const {
  if (expected.version == "any") return std::nullopt;
  const auto now = there ? std::optional(there->version) : std::nullopt;
  if (now == expected.version) return std::nullopt;
  const std::string known = expected.version ? "version " + *expected.version : "no program";
  const std::string is = now ? "version " + *now : "no program";
  return Failure{FailureKind::refused,
                 "E9019",
                 name + " was changed by somebody else: expected " + known + ", found " + is,
                 0,
                 {}};
}

Expected<std::string, Failure> ProgramFolder::write(const std::string& name,
                                                    const std::string& text,
                                                    const ExpectedVersion& expected) const {
  if (text.size() > format_.bytes_max)
    return Unexpected<Failure>(
        failure_of_diagnostic(lang::too_large(name, text.size(), format_.bytes_max)));
  const auto there = look(name);
  if (!there) return Unexpected<Failure>(there.error());
  if (const auto other = conflict(name, *there, expected)) return Unexpected<Failure>(*other);
  if (*there && expected.version != "any" && !is_utf8((*there)->text))
    return Unexpected<Failure>(cannot_write(
        name, "its text is not UTF-8, and characters would be lost; convert it first"));
  const fs::path place = place_of_program(root_, name, *there);
  const std::string file = place.filename().string();
  if (file.empty() || file.starts_with('.'))
    return Unexpected<Failure>(cannot_write(name, "names of programs must not begin with a dot"));
  const FileDescriptor folder(open_folder(root_, place.parent_path()));
  if (!folder.is_open()) return Unexpected<Failure>(cannot_write(name, system_error_text(errno)));
  if (const int error = replace(folder.number(), file, text); error != 0)
    return Unexpected<Failure>(cannot_write(name, system_error_text(error)));
  return version_of(text);
}

std::optional<Failure> ProgramFolder::remove(const std::string& name,
                                             const ExpectedVersion& expected) const {
  const auto there = look(name);
  if (!there) return there.error();
  if (!*there)
    return Failure{FailureKind::refused, "E7001", "the file was not found: " + name, 0, {}};
  if (const auto other = conflict(name, *there, expected)) return other;
  const fs::path place = place_of_program(root_, name, *there);
  const FileDescriptor folder(open_folder(root_, place.parent_path()));
  if (!folder.is_open() || ::unlinkat(folder.number(), place.filename().c_str(), 0) != 0)
    return cannot_write(name, system_error_text(errno));
  ::fsync(folder.number());
  return std::nullopt;
}

}  // namespace stanok::daemon
