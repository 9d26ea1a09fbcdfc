// Imported tools as a text of the tables file: a new one, or into one that exists.
//
// A text that exists is edited in place, value by value, so that its comments and all that it says
// besides stay as they are. The result is read again and compared before it is returned.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "jobs/tools/foreign_tools.h"

namespace stanok::jobs {

// What becomes of a tool that both have.
enum class EqualNumbers : std::uint8_t { refuse, replace };

// Rows with the values that the foreign file gave, no others: `tool load` leaves those alone.
[[nodiscard]] std::string tables_text(std::span<const ForeignTool> tools);

// Leaves only what `tool load` can set in a running daemon: lengths, radius, wear, orientation and
// angles, but no name and no shape.
void keep_offsets(std::vector<ForeignTool>& tools);

struct MergedTables {
  std::string text;
  int added = 0;
  int replaced = 0;
};
// Values of a tool that is replaced become those of the foreign file; what that does not give
// stays. Throws ConfigError: both have a tool and `rule` refuses, or the text cannot be edited.
[[nodiscard]] MergedTables merged_tables(const std::string& text, const std::filesystem::path& file,
                                         std::span<const ForeignTool> tools, EqualNumbers rule);

}  // namespace stanok::jobs
