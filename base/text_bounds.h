// How deep and how long a text may be before a parser that recurses sees it.
//
// Parsers of trees (TOML, JSON) and the trees themselves go down the stack once for each level. The
// depth is measured here in one pass without recursion, by the marks of the syntax outside of
// strings and comments; a text that is no valid TOML or JSON may be measured wrongly only behind
// the place where its parser gives up. Programs are bounded by lang/text/limits.h.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stanok {

struct TextBounds {
  std::size_t bytes = 0;
  int nesting = 0;    // of braces and brackets
  int key_parts = 0;  // of a dotted key, a.b.c has three; TOML
};

// Machine files have three levels, tables of 32,000 tools with all edges 20 MiB.
inline constexpr TextBounds toml_bounds{.bytes = 32UL << 20, .nesting = 16, .key_parts = 16};
// Requests have three levels, states of a machine six; a line is bounded by the reader of frames.
inline constexpr TextBounds json_bounds{.bytes = 64UL << 20, .nesting = 64};

// What is too much, at the place where it becomes so. Line and column count from 1, in bytes.
struct TextExcess {
  unsigned line = 1;
  unsigned column = 1;
  std::string text;  // "nested deeper than 16 levels"
};

// Nothing: the text may be parsed.
[[nodiscard]] std::optional<TextExcess> toml_excess(std::string_view text,
                                                    const TextBounds& bounds = toml_bounds);
[[nodiscard]] std::optional<TextExcess> json_excess(std::string_view text,
                                                    const TextBounds& bounds = json_bounds);

}  // namespace stanok
