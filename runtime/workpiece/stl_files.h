// Reads STL files of blanks, for programs that name them and for the workpieces that they become.
//
// Only regular files of a bounded size are read. Not for the real-time cycle.
#pragma once

#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "base/expected.h"

namespace stanok::runtime {

// The bytes of a file that a program has found; or why there are none.
[[nodiscard]] Expected<std::string, std::string> bytes_of_stl(const std::string& path);

// What a program knows of a file with these bytes (lang/contract/blank_file.h), as a text; or what
// is wrong with it, E7020 to E7023.
[[nodiscard]] Expected<std::string, Diagnostic> blank_text_of(std::string_view name,
                                                              std::string_view bytes);

}  // namespace stanok::runtime
