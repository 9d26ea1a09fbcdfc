// A file that other processes, also of other computers, see whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stanok::client {

// Written beside its place under a name that no other process of any computer uses, then renamed
// over it; folders are made. False: it cannot be written, and nothing is left.
[[nodiscard]] bool write_whole(const std::filesystem::path& file, std::string_view bytes);
// Empty where there is no such file, or it cannot be read.
[[nodiscard]] std::string bytes_in(const std::filesystem::path& file);

}  // namespace stanok::client
