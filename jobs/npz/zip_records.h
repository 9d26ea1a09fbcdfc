// The records of a ZIP file with stored members: what stands before each member, and the directory
// behind the last one (PKWARE APPNOTE 6.3.9, sections 4.3 and 4.5.3).
//
// Sizes and places above `plain_max` stand in the fields of ZIP64, others in the plain ones, which
// every reader knows. Times are the first that ZIP has, 1980-01-01: equal members give equal files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stanok::jobs {

struct ZipMember {
  std::string name;         // at most 65,535 bytes
  std::int64_t offset = 0;  // of its local header in the file
  std::int64_t bytes = 0;   // of its content
  std::uint32_t sum = 0;    // CRC-32 of its content
};

inline constexpr std::int64_t zip_plain_max = 0xFFFFFFFE;

// Its length does not depend on the check sum.
[[nodiscard]] std::string zip_local_header(const ZipMember& member,
                                           std::int64_t plain_max = zip_plain_max);

// `offset`: where it will stand. At most 65,534 members.
[[nodiscard]] std::string zip_directory(std::span<const ZipMember> members, std::int64_t offset,
                                        std::int64_t plain_max = zip_plain_max);

}  // namespace stanok::jobs
