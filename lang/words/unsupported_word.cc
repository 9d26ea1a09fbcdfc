#include "lang/words/unsupported_word.h"

#include <algorithm>
#include <array>

namespace stanok::lang {
namespace {

constexpr auto unsupported_rows = std::to_array<UnsupportedWord>({
    {"G2.4", "an arc through a point, clockwise", "use G2 with centre or radius"},
    {"G3.4", "an arc through a point, counter-clockwise", "use G3 with centre or radius"},
    {"G17.1", "a plane of other axes", "use G17, G18 or G19, the planes of X, Y and Z"},
    {"G18.1", "a plane of other axes", "use G17, G18 or G19, the planes of X, Y and Z"},
    {"G19.1", "a plane of other axes", "use G17, G18 or G19, the planes of X, Y and Z"},
    {"G34", "a thread of variable lead", "use G33, section by section"},
});

}  // namespace

std::span<const UnsupportedWord> unsupported_words() {
  return unsupported_rows;
}

const UnsupportedWord* find_unsupported_word(std::string_view word) {
  const auto row = std::find_if(unsupported_rows.begin(), unsupported_rows.end(),
                                [word](const UnsupportedWord& one) { return one.word == word; });
  return row == unsupported_rows.end() ? nullptr : &*row;
}

}  // namespace stanok::lang
