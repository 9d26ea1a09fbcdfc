// The tables of docs/reference/configuration.md, made from the key tables that read the files.
#pragma once

#include <string>
#include <vector>

#include "config/text/key_table.h"

namespace stanok::config {

// One TOML table of a file, as documented.
struct KeySection {
  std::string title;  // "[[axis]]"
  std::vector<KeyRow> rows;
};

// All tables of the machine file, the files it names and the process file, in the order of the
// documentation.
[[nodiscard]] std::vector<KeySection> key_sections();

// A section as Markdown: heading, then one row per key with unit, default, values and meaning.
[[nodiscard]] std::string to_markdown(const KeySection& section);

}  // namespace stanok::config
