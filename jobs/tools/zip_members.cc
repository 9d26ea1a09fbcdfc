#include "jobs/tools/zip_members.h"

#include <zip.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/place.h"
#include "jobs/tools/foreign_text.h"

namespace stanok::jobs {
namespace {

constexpr zip_uint64_t members_max = 1000;
constexpr std::size_t unpacked_max = 64UL << 20;  // bytes, of all members together

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;
using OpenMember = std::unique_ptr<zip_file_t, CloseFile>;

std::string text_of_error(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

// Reads the bytes where they are; they must outlive it.
Archive opened(std::string_view bytes, std::string& fault) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source != nullptr) {
    if (zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, &error)) return Archive(archive);
    zip_source_free(source);
  }
  fault = "not a ZIP file that can be read (" + text_of_error(error) + "); export it again";
  return nullptr;
}

// The size that the directory names is not believed.
std::optional<std::string> unpacked(zip_t* archive, zip_uint64_t index, std::size_t bytes_max,
                                    std::string& fault) {
  const OpenMember member(zip_fopen_index(archive, index, 0));
  std::string bytes;
  if (member == nullptr) {
    fault = "a member cannot be unpacked (" + std::string(zip_strerror(archive)) +
            "); export the library again, without a password";
    return std::nullopt;
  }
  constexpr std::size_t piece = 64UL << 10;
  for (;;) {
    const std::size_t before = bytes.size();
    bytes.resize(before + piece);
    const zip_int64_t count = zip_fread(member.get(), bytes.data() + before, piece);
    if (count < 0) {
      fault = "a member is damaged (" + std::string(zip_file_strerror(member.get())) +
              "); export the library again";
      return std::nullopt;
    }
    bytes.resize(before + checked_size(count));
    if (bytes.size() > bytes_max) {
      fault = "it unpacks to more than 64 MiB; a tool library is smaller: check the file";
      return std::nullopt;
    }
    if (count == 0) return bytes;
  }
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

Expected<std::vector<UnpackedMember>, std::string> zip_members(std::string_view bytes,
                                                               std::string_view suffix) {
  std::string fault;
  const Archive archive = opened(bytes, fault);
  if (archive == nullptr) return Unexpected<std::string>(fault);
  const auto count =
      static_cast<zip_uint64_t>(std::max<zip_int64_t>(zip_get_num_entries(archive.get(), 0), 0));
  if (count > members_max) {
    return Unexpected<std::string>("it has more than 1000 members; a tool library has one");
  }
  std::vector<UnpackedMember> members;
  std::size_t room = unpacked_max;
  for (zip_uint64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), i, 0);
    if (name == nullptr || !in_lower_case(name).ends_with(suffix)) continue;
    auto content = unpacked(archive.get(), i, room, fault);
    if (!content) return Unexpected<std::string>(fault);
    room -= content->size();
    members.push_back({name, std::move(*content)});
  }
  return members;
}

std::string zip_of(const UnpackedMember& member) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (archive == nullptr) throw std::runtime_error("libzip: " + text_of_error(error));
  zip_source_t* content = zip_source_buffer(archive, member.bytes.data(), member.bytes.size(), 0);
  const zip_int64_t index = zip_file_add(archive, member.name.c_str(), content, ZIP_FL_ENC_UTF_8);
  // The first time that ZIP has: equal libraries give equal files.
  constexpr zip_uint16_t first_date = 1U << 5U | 1U;
  zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, first_date, 0);
  if (zip_close(archive) != 0) throw std::runtime_error("libzip cannot write a file in memory");
  zip_stat_t stat;
  zip_source_stat(target, &stat);
  std::string bytes(stat.size, '\0');
  zip_source_open(target);
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

}  // namespace stanok::jobs
