#include "lang/contract/code_number.h"

#include <cstdlib>

namespace stanok::lang {

std::string code_text(char letter, int number) {
  std::string text = letter + std::to_string(number / 10);
  if (number % 10 != 0) text += "." + std::to_string(std::abs(number % 10));
  return text;
}

}  // namespace stanok::lang
