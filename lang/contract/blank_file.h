// What a program knows of the STL file of its blank (#workpiece): where it lies and how large it
// is, no triangles.
//
// `Files::read` answers the name of an STL file with this as a text, so that it is kept, recorded
// and compared as the texts of programs are. Lengths are in units of the file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::lang {

struct BlankFile {
  std::uint64_t fingerprint = 0;  // of its bytes
  std::array<double, 3> low{};    // smallest corner of the box around it
  std::array<double, 3> high{};
};

// Whether a name ends as those of STL files do.
[[nodiscard]] bool names_stl_file(std::string_view name);

[[nodiscard]] std::string text_of(const BlankFile& file);
// Nothing: the text is none that `text_of` made.
[[nodiscard]] std::optional<BlankFile> read_blank_file(std::string_view text);

}  // namespace stanok::lang
