// Plain ISO lines: letters with numbers, parameters and bracket expressions, parameter settings,
// block numbers, comments. They are executed straight from the text, which makes them fast and lets
// a program of any length be held as it is.
//
// What is plain is decided when the program is loaded. Everything else (high-level expressions,
// strings, block skip, program flow, faulty lines) goes the way of tokens, tree and code, so that
// this reader never has to explain an error of the text.
#pragma once

#include "lang/contract/environment.h"
#include "lang/tree/text_value.h"
#include "lang/words/block_words.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

// Where the line stands: inside { } a `;` after words is no comment.
enum class Surroundings : std::uint8_t { file_level, braces };

struct LineRules {
  Surroundings surroundings = Surroundings::file_level;
  TextRules text;
};

// Reads the line at `at` into `words` and `values` (its settings) and puts `at` behind its line
// end. False, with `at` unchanged and `words` undefined, when the line is not plain or one of its
// values cannot be computed: values.faulty(). Lines without words are plain too.
[[nodiscard]] bool read_plain_line(const char*& at, const char* end, const LineRules& rules,
                                   BlockWords& words, TextValues& values);

// Whether a block read from a plain line may be executed without its tree: all of its codes exist,
// are supported and leave the flow of the program alone, and the static rules hold.
[[nodiscard]] bool is_plain_block(const BlockWords& words, const ChannelWords* channel,
                                  const ChannelDialect& dialect);

}  // namespace stanok::lang
