#include "runtime/program_files.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "base/file_descriptor.h"
#include "base/place.h"
#include "base/system_error.h"
#include "config/text/text_encoding.h"
#include "lang/contract/blank_file.h"
#include "runtime/workpiece/stl_files.h"
#include "simulation/solid/stl_solid.h"

namespace stanok::runtime {
namespace {

namespace fs = std::filesystem;
using Text = std::shared_ptr<const lang::SourceText>;

Diagnostic diagnostic(const char* code, std::string message, std::string help) {
  Diagnostic d;
  d.code = code;
  d.message = std::move(message);
  if (!help.empty()) d.help = {std::move(help)};
  return d;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

// Why a name may not be used, or an empty text.
std::string fault_of(std::string_view name) {
  if (name.empty()) return "the file name is empty";
  if (name.front() == '/') return "the file name must be relative";
  if (name.find('\\') != std::string_view::npos) return "the file name must use / and not \\";
  if (name.size() > 1 && name[1] == ':') return "the file name must not name a drive";
  for (const char c : name) {
    if (static_cast<unsigned char>(c) < ' ')
      return "the file name must not contain control characters";
  }
  for (const fs::path& part : fs::path(name)) {
    if (part == "..") return "the file name must not contain ..";
  }
  return "";
}

// A file descriptor, or the negative error number: closing the folder may change errno.
int open_beneath(const fs::path& folder, std::string_view name) {
  const FileDescriptor root(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!root.is_open()) return -errno;
  open_how how{};
  how.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  const auto number = static_cast<int>(
      ::syscall(SYS_openat2, root.number(), std::string(name).c_str(), &how, sizeof(how)));
  return number < 0 ? -errno : number;
}

Expected<std::string, Diagnostic> read_all(int file, std::string_view name, std::size_t bytes_max) {
  struct stat status{};
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    return Unexpected<Diagnostic>(
        diagnostic("E7003", std::string(name) + " is not a regular file", ""));
  }
  const std::size_t size = checked_size(status.st_size);
  if (size > bytes_max) return Unexpected<Diagnostic>(lang::too_large(name, size, bytes_max));
  std::string text(size, '\0');
  std::size_t filled = 0;
  while (filled < text.size()) {
    const ssize_t count = ::read(file, text.data() + filled, text.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const std::string reason = system_error_text(errno);
      return Unexpected<Diagnostic>(
          diagnostic("E7004", "cannot read " + std::string(name) + ": " + reason, ""));
    }
    if (count == 0) break;
    filled += checked_size(count);
  }
  text.resize(filled);
  return text;
}

// The text that stands for an STL file.
Expected<std::string, Diagnostic> read_stl(int file, std::string_view name) {
  auto bytes = read_all(file, name, simulation::stl_bytes_max);
  if (!bytes && bytes.error().code == "E8004") {
    struct stat status{};
    const bool is_known = ::fstat(file, &status) == 0;
    const auto refusal = simulation::stl_too_large(is_known ? checked_size(status.st_size) : 0);
    return Unexpected<Diagnostic>(
        diagnostic(refusal.code.c_str(), std::string(name) + ": " + refusal.text, refusal.help));
  }
  return bytes ? blank_text_of(name, *bytes) : bytes;
}

// A file whose name differs in capitals only; the help of "file not found".
std::string similar_name(const fs::path& folder, std::string_view name) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / fs::path(name).parent_path(), ignored)) {
    const std::string candidate = entry.path().filename().string();
    if (lower(candidate) == lower(fs::path(name).filename().string())) {
      return "there is " + (fs::path(name).parent_path() / candidate).string() +
             "; file names are case-sensitive";
    }
  }
  return "";
}

}  // namespace

ProgramFormat program_format(const channels::MachineConfig& machine) {
  return {machine.program_bounds.bytes, machine.program_encoding};
}

ProgramFiles::ProgramFiles(std::vector<fs::path> roots, ProgramFormat format, TextBook* book)
    : roots_(std::move(roots)), format_(std::move(format)), book_(book) {}

std::vector<fs::path> ProgramFiles::folders_for(std::string_view from) const {
  std::vector<fs::path> folders;
  if (!from.empty()) folders.push_back(fs::path(from).parent_path());
  for (const fs::path& root : roots_) {
    for (const char* part : {"", "programs", "subprograms", "cycles"})
      folders.push_back(root / part);
  }
  for (fs::path& folder : folders) {
    if (folder.empty()) folder = ".";
  }
  return folders;
}

Expected<Text, Diagnostic> ProgramFiles::read(std::string_view name, std::string_view from) const {
  auto found = find(name, from);
  if (book_ == nullptr) return found;
  recording::ProgramRead read{.name = std::string(name), .from = std::string(from)};
  if (found) {
    read.found = true;
    read.path = (*found)->path;
    read.text = (*found)->text;
  }
  book_->note(std::move(read));
  return found;
}

Expected<Text, Diagnostic> ProgramFiles::find(std::string_view name, std::string_view from) const {
  if (const std::string fault = fault_of(name); !fault.empty()) {
    return Unexpected<Diagnostic>(diagnostic("E7002", fault + ": " + std::string(name),
                                             "give the file name relative to the program root"));
  }
  const bool is_stl = lang::names_stl_file(name);
  const auto folders = folders_for(from);
  for (const fs::path& folder : folders) {
    const FileDescriptor file(open_beneath(folder, name));
    if (!file.is_open()) {
      const int error = -file.number();
      if (error == EXDEV || error == ELOOP) {
        return Unexpected<Diagnostic>(
            diagnostic("E7002", std::string(name) + " leads outside the program root", ""));
      }
      if (error != ENOENT && error != ENOTDIR) {
        return Unexpected<Diagnostic>(diagnostic(
            "E7004", "cannot open " + std::string(name) + ": " + system_error_text(error), ""));
      }
      continue;
    }
    auto text =
        is_stl ? read_stl(file.number(), name) : read_all(file.number(), name, format_.bytes_max);
    if (!text) return Unexpected<Diagnostic>(text.error());
    auto source = std::make_shared<lang::SourceText>();
    source->name = std::string(name);
    source->path = (folder / name).lexically_normal().string();
    source->text = config::text_from(std::move(*text), format_.encoding);
    return Text(std::move(source));
  }
  std::string help;
  for (const fs::path& folder : folders) {
    if (help.empty()) help = similar_name(folder, name);
  }
  if (help.empty()) help = "check the name and the program root";
  return Unexpected<Diagnostic>(
      diagnostic("E7001", "the file was not found: " + std::string(name), help));
}

}  // namespace stanok::runtime
