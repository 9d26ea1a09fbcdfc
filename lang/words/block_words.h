// The words of one ISO block with their values computed: what the two readers of a block (the fast
// one for plain lines, the compiled one for all others) hand to its execution.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lang/contract/code_number.h"
#include "lang/contract/dialect.h"

namespace stanok::lang {

// Bit k stands for the k-th letter, A = 0.
using LetterSet = std::uint32_t;

// A = 0.
[[nodiscard]] constexpr std::size_t place_in_alphabet(char upper) {
  return static_cast<std::size_t>(upper - 'A');
}
[[nodiscard]] constexpr LetterSet letter_bit(char upper) {
  return LetterSet{1} << (place_in_alphabet(upper) & 31U);
}
[[nodiscard]] constexpr LetterSet letters_of(std::string_view uppers) {
  LetterSet set = 0;
  for (const char letter : uppers) set |= letter_bit(letter);
  return set;
}

// A value for each letter, read by it.
template <class Value>
struct LetterArray : std::array<Value, 26> {
  [[nodiscard]] constexpr Value& operator[](char upper) {
    return std::array<Value, 26>::operator[](place_in_alphabet(upper));
  }
  [[nodiscard]] constexpr const Value& operator[](char upper) const {
    return std::array<Value, 26>::operator[](place_in_alphabet(upper));
  }
};

// Stands for G=expr and M=expr until the value is known.
inline constexpr CodeNumber code_computed_later = -1;

// The codes of one letter in a block, in the order written.
struct CodeList {
  static constexpr std::size_t capacity = 16;  // a line that sets all modes has ten and more
  std::array<CodeNumber, capacity> numbers{};
  std::size_t count = 0;

  void add(CodeNumber number) { numbers[count++] = number; }
  void remove(std::size_t index) {
    std::copy(numbers.data() + index + 1, numbers.data() + count, numbers.data() + index);
    --count;
  }

  [[nodiscard]] const CodeNumber* begin() const { return numbers.data(); }
  [[nodiscard]] const CodeNumber* end() const { return numbers.data() + count; }
  [[nodiscard]] bool has(CodeNumber number) const {
    return std::find(begin(), end(), number) != end();
  }
};

// A word with more than one letter or with an index: X2=50, H1=2, S_n=0.1.
struct NamedWord {
  std::string name;  // upper case for letter + digits, as registered for named addresses
  double value = 0.0;
};

struct BlockWords {
  TextRules rules;         // of the text they stand in
  LetterSet letters = 0;   // all words of one letter but G, M, N and O
  LetterSet whole = 0;     // those of them written as a number without decimal point
  LetterSet left_out = 0;  // words that are not there since their variable is vacant
  LetterArray<double> values{};
  CodeList g;
  CodeList m;
  std::vector<NamedWord> named;
  bool spindle_named = false;  // `$` in this block
  int spindle = 0;

  void clear() {
    letters = 0;
    whole = 0;
    left_out = 0;
    g.count = 0;
    m.count = 0;
    spindle_named = false;
    if (!named.empty()) named.clear();
  }
  [[nodiscard]] bool has(char letter) const { return (letters & letter_bit(letter)) != 0; }
  [[nodiscard]] double value(char letter) const { return values[letter]; }
  [[nodiscard]] bool empty() const {
    return letters == 0 && g.count == 0 && m.count == 0 && named.empty() && !spindle_named;
  }
  // nullptr: the block has none of that name.
  [[nodiscard]] const NamedWord* called(std::string_view name) const {
    const auto found = std::ranges::find(named, name, &NamedWord::name);
    return found == named.end() ? nullptr : &*found;
  }
};

}  // namespace stanok::lang
