// Tool libraries of other programs where a tables file is expected: what they are is said, instead
// of what is wrong with them as TOML.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::config {

struct ForeignTables {
  std::string what;   // "a LinuxCNC tool table"
  unsigned line = 1;  // where that shows

  [[nodiscard]] toml::source_region place_in(const std::filesystem::path& file) const;
};

// Nothing: the text does not begin like one of them. No text of TOML does.
[[nodiscard]] std::optional<ForeignTables> foreign_tables_in(std::string_view text);

}  // namespace stanok::config
