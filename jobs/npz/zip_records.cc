#include "jobs/npz/zip_records.h"

#include <concepts>
#include <cstddef>
#include <initializer_list>

#include "base/assert.h"

namespace stanok::jobs {
namespace {

constexpr std::uint32_t in_zip64 = 0xFFFFFFFF;  // in place of a size: see the extra field
constexpr std::uint16_t plain_version = 20;     // 2.0
constexpr std::uint16_t zip64_version = 45;     // 4.5
constexpr std::uint16_t first_day = 0x21;       // 1980-01-01

// Little endian.
template <std::unsigned_integral Number>
void put_zip_number(std::string& record, Number number) {
  for (std::size_t k = 0; k < sizeof number; ++k)
    record += static_cast<char>(static_cast<std::uint64_t>(number) >> 8 * k & 0xFFU);
}

template <std::unsigned_integral... Numbers>
void put_zip_numbers(std::string& record, Numbers... numbers) {
  (put_zip_number(record, numbers), ...);
}

constexpr std::uint16_t zip_zero = 0;

std::uint16_t two_bytes(std::size_t size) {
  STANOK_ASSERT(size < 0xFFFF);
  return static_cast<std::uint16_t>(size);
}

// What fits stands in the plain field, else in the extra field of ZIP64.
class ZipSizes {
 public:
  explicit ZipSizes(std::int64_t plain_max) : plain_max_(plain_max) {}

  [[nodiscard]] bool fits(std::int64_t size) const { return size <= plain_max_; }
  std::uint32_t plain(std::int64_t size) {
    STANOK_ASSERT(size >= 0);
    if (fits(size)) return static_cast<std::uint32_t>(size);
    put_zip_number(large_, static_cast<std::uint64_t>(size));
    return in_zip64;
  }
  [[nodiscard]] std::uint16_t version() const {
    return large_.empty() ? plain_version : zip64_version;
  }
  [[nodiscard]] std::string extra_field() const {
    std::string field;
    if (large_.empty()) return field;
    put_zip_numbers(field, std::uint16_t{1}, two_bytes(large_.size()));
    return field + large_;
  }

 private:
  std::int64_t plain_max_;
  std::string large_;
};

// From the version that is needed up to the length of the extra field: in both headers of a member.
void put_common(std::string& record, const ZipMember& member, const ZipSizes& sizes,
                std::uint32_t bytes) {
  put_zip_numbers(record, sizes.version(), zip_zero, zip_zero, zip_zero, first_day, member.sum,
                  bytes, bytes, two_bytes(member.name.size()),
                  two_bytes(sizes.extra_field().size()));
}

// Both sizes of a stored member are one.
std::uint32_t plain_bytes(const ZipMember& member, ZipSizes& sizes) {
  static_cast<void>(sizes.plain(member.bytes));
  return sizes.plain(member.bytes);
}

void put_directory_entry(std::string& directory, const ZipMember& member, std::int64_t plain_max) {
  ZipSizes sizes(plain_max);
  const std::uint32_t bytes = plain_bytes(member, sizes);
  const std::uint32_t offset = sizes.plain(member.offset);
  put_zip_numbers(directory, std::uint32_t{0x02014B50}, sizes.version());
  put_common(directory, member, sizes, bytes);
  // Comment, disk, attributes inside and outside.
  put_zip_numbers(directory, zip_zero, zip_zero, zip_zero, std::uint32_t{0}, offset);
  directory += member.name + sizes.extra_field();
}

void put_zip64_end(std::string& directory, std::uint64_t members, std::int64_t offset) {
  const std::uint64_t size = directory.size();
  const std::uint64_t begin = static_cast<std::uint64_t>(offset);
  constexpr std::uint64_t bytes_behind = 44;
  put_zip_numbers(directory, std::uint32_t{0x06064B50}, bytes_behind, zip64_version, zip64_version,
                  std::uint32_t{0}, std::uint32_t{0}, members, members, size, begin);
  put_zip_numbers(directory, std::uint32_t{0x07064B50}, std::uint32_t{0}, begin + size,
                  std::uint32_t{1});
}

}  // namespace

std::string zip_local_header(const ZipMember& member, std::int64_t plain_max) {
  ZipSizes sizes(plain_max);
  const std::uint32_t bytes = plain_bytes(member, sizes);
  std::string header;
  put_zip_number(header, std::uint32_t{0x04034B50});
  put_common(header, member, sizes, bytes);
  return header + member.name + sizes.extra_field();
}

std::string zip_directory(std::span<const ZipMember> members, std::int64_t offset,
                          std::int64_t plain_max) {
  std::string directory;
  for (const ZipMember& member : members) put_directory_entry(directory, member, plain_max);
  const std::uint16_t count = two_bytes(members.size());
  const auto size = static_cast<std::int64_t>(directory.size());
  ZipSizes sizes(plain_max);
  const std::uint32_t plain_size = sizes.plain(size);
  const std::uint32_t plain_offset = sizes.plain(offset);
  if (!sizes.fits(size) || !sizes.fits(offset)) put_zip64_end(directory, count, offset);
  put_zip_numbers(directory, std::uint32_t{0x06054B50}, zip_zero, zip_zero, count, count,
                  plain_size, plain_offset, zip_zero);
  return directory;
}

}  // namespace stanok::jobs
