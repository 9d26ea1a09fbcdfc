#include "base/catalogue.h"

#include <algorithm>
#include <array>

namespace stanok {
namespace {

constexpr auto end = Reaction::program_end;

// Sorted by code. One line a row: code, title, reaction, remedy, how to go on.
constexpr auto rows = std::to_array<CatalogueRow>({
    {"E7001", "file not found", end, "check the name and the program root",
     "correct the program and load it again"},
});

}  // namespace

std::span<const CatalogueRow> catalogue() {
  return rows;
}

const CatalogueRow* find_in_catalogue(std::string_view code) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const CatalogueRow& r) { return r.code == code; });
  return row == rows.end() ? nullptr : &*row;
}

}  // namespace stanok
