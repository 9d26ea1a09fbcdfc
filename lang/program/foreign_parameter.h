// Parameters of texts in the dialects stanok and linuxcnc that a control of Fanuc gives a meaning
// and these dialects do not: variables of the program, 0 until it sets them. A program that only
// reads one, or only sets it, was written for that control.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/program/program.h"

namespace stanok::lang {

struct ForeignParameter {
  std::uint16_t file = 0;
  Span span;
  std::string message;
  std::string label;
  std::vector<std::string> help;
};

// Each number once, where it stands first; those whose number is computed are not known.
[[nodiscard]] std::vector<ForeignParameter> foreign_parameters(const Program& program);

}  // namespace stanok::lang
