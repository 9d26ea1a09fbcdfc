// Where the subprograms that a text calls by number begin.
//
// Functions of a compiled program and the file that calls; nothing else is read, nothing kept.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "lang/program/program.h"

namespace stanok::lang {

// Where a numbered program stands.
struct NumberedProgramPlace {
  std::uint16_t file = 0;
  std::uint32_t position = 0;
  bool other_file = false;  // found by its name: its variables are new for the call
};

struct NumberedProgramSearch {
  std::optional<NumberedProgramPlace> place;
  // Two included files that both have the number: which one is meant is not known.
  std::optional<std::pair<std::uint16_t, std::uint16_t>> rivals;
};

// In the text of `caller`, then in the included ones (once), then the file of that number.
[[nodiscard]] NumberedProgramSearch find_numbered_program(const Program& program,
                                                          std::uint16_t caller, int number,
                                                          SearchedTexts texts);

// O-line subprogram of a computed label: in the text of `caller`, then in the included ones.
[[nodiscard]] std::optional<Callee> find_o_subprogram(const Program& program, std::uint16_t caller,
                                                      const std::string& label);

}  // namespace stanok::lang
