// ISO blocks: words, parameter settings and comments.
//
// Owner: Parser. Owns nothing; the channel decides which names are axes, the dialect which letters
// stand for named addresses.
#pragma once

#include <string_view>

#include "lang/tree/bracket_parser.h"
#include "lang/tree/expression_parser.h"
#include "lang/tree/token_cursor.h"
#include "lang/words/channel_dialect.h"
#include "lang/words/channel_words.h"

namespace stanok::lang {

class IsoParser {
 public:
  // All must outlive this. `channel` nullptr: no name is an axis.
  IsoParser(TokenCursor& cursor, BracketParser& brackets, ExpressionParser& expressions,
            const ChannelWords* channel, const ChannelDialect& dialect)
      : cursor_(cursor),
        brackets_(brackets),
        expressions_(expressions),
        channel_(channel),
        dialect_(dialect),
        source_(cursor.source()),
        reporter_(cursor.reporter()),
        scanner_(cursor.scanner()) {}

  MaybeStatement parse_iso();
  // Whether `name`, which stands here, begins a word with `=`.
  [[nodiscard]] bool is_named_address(std::string_view name) const;

 private:
  bool parse_iso_part(IsoBlock& block);
  bool parse_word(IsoBlock& block);
  bool parse_corner_word(IsoBlock& block);
  bool parse_sign_word(IsoBlock& block, std::string name);
  bool parse_long_word(IsoBlock& block, std::string_view name);
  bool parse_plain_value(IsoWord& word);
  bool apply_aliases(IsoBlock& block);
  bool parse_parameter_setting(IsoBlock& block);
  [[nodiscard]] bool begins_variable() const;
  bool add_word(IsoBlock& block, IsoWord word);
  bool translate_code(IsoWord& word);
  static int argument_set(const IsoBlock& block, const IsoWord& word);
  static void replace_argument(IsoBlock& block, const IsoWord& word);
  bool add_argument(IsoBlock& block, IsoWord word, int set);
  bool end_at_semicolon(const IsoBlock& block);
  bool end_iso_in_braces();

  TokenCursor& cursor_;
  BracketParser& brackets_;
  ExpressionParser& expressions_;
  const ChannelWords* channel_;
  const ChannelDialect& dialect_;
  const Source& source_;
  Reporter& reporter_;
  Scanner& scanner_;
};

}  // namespace stanok::lang
