// Files that a command writes beside its output.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace stanok::client {

// Throws std::runtime_error when the file cannot be written.
void write_text_file(const std::filesystem::path& file, std::string_view text);

// What is wrong with the name of a picture that gnuplot draws; empty: nothing.
[[nodiscard]] std::string picture_name_fault(const std::string& name);

}  // namespace stanok::client
