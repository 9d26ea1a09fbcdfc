#include "jobs/npz/npz_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <zlib.h>

#include <cerrno>
#include <utility>

#include "base/assert.h"
#include "base/place.h"
#include "base/system_error.h"

namespace stanok::jobs {
namespace {

constexpr std::size_t held_bytes_max = std::size_t{128} << 10;  // of each array

NpzError npz_error(const std::filesystem::path& file, int error) {
  std::string text = "cannot write " + file.string() + ": ";
  text += error == ESPIPE ? "it is written at several places; give a file, not a pipe"
                          : system_error_text(error);
  return {error, text};
}

std::int64_t bytes_of(const NpyArray& array) {
  std::int64_t bytes = array.item_bytes;
  for (const std::int64_t size : array.shape) bytes *= size;
  return bytes;
}

}  // namespace

Expected<std::unique_ptr<NpzFile>, NpzError> NpzFile::create(const std::filesystem::path& file,
                                                             const std::vector<NpyArray>& arrays,
                                                             std::int64_t plain_max) {
  constexpr mode_t readable = 0666;
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readable);
  if (descriptor < 0) return Unexpected<NpzError>(npz_error(file, errno));
  std::unique_ptr<NpzFile> made(new NpzFile(file, descriptor, plain_max));
  made->place(arrays);
  return made;
}

NpzFile::~NpzFile() {
  struct stat status{};
  if (is_finished_ || ::fstat(descriptor_.number(), &status) != 0 || !S_ISREG(status.st_mode))
    return;
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

void NpzFile::place(const std::vector<NpyArray>& arrays) {
  members_.reserve(arrays.size());
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    const NpyArray& array = arrays[k];
    const std::string header = npy_header(array.type, array.shape);
    Member& member = members_.emplace_back();
    member.zip = {.name = array.name + ".npy",
                  .offset = end_,
                  .bytes = static_cast<std::int64_t>(header.size()) + bytes_of(array)};
    member.content =
        end_ + static_cast<std::int64_t>(zip_local_header(member.zip, plain_max_).size());
    end_ = member.content + member.zip.bytes;
    add_bytes(k, header);
  }
}

void NpzFile::add_bytes(std::size_t array, std::span<const char> bytes) {
  Member& member = members_.at(array);
  member.held.append(bytes.data(), bytes.size());
  if (member.held.size() >= held_bytes_max) write_held(member);
}

void NpzFile::write_held(Member& member) {
  const auto* const bytes = reinterpret_cast<const Bytef*>(member.held.data());
  member.zip.sum = static_cast<std::uint32_t>(::crc32_z(member.zip.sum, bytes, member.held.size()));
  write(member.held, member.content + member.written);
  member.written += static_cast<std::int64_t>(member.held.size());
  STANOK_ASSERT(member.written <= member.zip.bytes);
  member.held.clear();
}

void NpzFile::write(std::string_view bytes, std::int64_t offset) {
  while (!error_ && !bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_.number(), bytes.data(), bytes.size(), offset);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = npz_error(file_, errno);
      return;
    }
    bytes.remove_prefix(checked_size(written));
    offset += written;
  }
}

std::optional<NpzError> NpzFile::finish() {
  std::vector<ZipMember> directory;
  for (Member& member : members_) {
    write_held(member);
    STANOK_ASSERT(member.written == member.zip.bytes);
    write(zip_local_header(member.zip, plain_max_), member.zip.offset);
    directory.push_back(member.zip);
  }
  write(zip_directory(directory, end_, plain_max_), end_);
  is_finished_ = !error_;
  return error_;
}

}  // namespace stanok::jobs
