// Members of ZIP files by libzip, with bounds: a small file may unpack to gigabytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stanok::jobs {

struct UnpackedMember {
  std::string name;
  std::string bytes;
};

[[nodiscard]] bool is_zip(std::string_view bytes);

// The members whose names end in `suffix`, in lower case; or what is wrong with the file and what
// to do.
[[nodiscard]] Expected<std::vector<UnpackedMember>, std::string> zip_members(
    std::string_view bytes, std::string_view suffix);

// A ZIP file of one member.
[[nodiscard]] std::string zip_of(const UnpackedMember& member);

}  // namespace stanok::jobs
