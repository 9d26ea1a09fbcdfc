// #feedlaw: laws with the addresses of a block are read as that block, `#feedlaw (linear, 60, 0.1,
// 0.05)` as `S_n=60 dS=0.1 dl=0.05`; off and curve are statements of their own.
#include <algorithm>
#include <utility>

#include "lang/feed_law/feed_law_words.h"
#include "lang/tree/directive_parser.h"

namespace stanok::lang {
namespace {

constexpr std::string_view no_law = "off";
constexpr std::string_view name_of_curve = "curve";

std::string signature_of(const LawForm& form) {
  std::string text = "`#feedlaw (" + std::string(form.directive);
  for (const LawAddress address : form.must()) text += ", " + std::string(name_of(address));
  return text + ")`";
}

std::vector<std::string_view> law_names() {
  std::vector<std::string_view> names{no_law, name_of_curve};
  for (const LawForm& form : law_forms()) {
    if (!form.directive.empty()) names.push_back(form.directive);
  }
  return names;
}

const LawForm* form_called(std::string_view directive) {
  const auto forms = law_forms();
  const auto found = std::find_if(forms.begin(), forms.end(), [directive](const LawForm& form) {
    return form.directive == directive;
  });
  return found == forms.end() ? nullptr : &*found;
}

IsoBlock block_of(const LawForm& form, std::vector<Expression> arguments) {
  IsoBlock block;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    IsoWord word;
    word.span = arguments[i].span;
    word.name = word_name(form.must()[i]);
    word.value = std::move(arguments[i]);
    block.words.push_back(std::move(word));
  }
  return block;
}

}  // namespace

MaybeStatement DirectiveParser::parse_feed_law(const Span& name) {
  cursor_.set_line_ends(LineEnds::significant);
  if (!cursor_.expect("(", "`#feedlaw`")) return std::nullopt;
  const Token law = scanner_.take(cursor_.line_ends());
  if (law.kind != TokenKind::name) {
    cursor_.report_unexpected(law, "the name of a feed law");
    return std::nullopt;
  }
  std::vector<Expression> arguments;
  const bool good = cursor_.accept(",") ? expressions_.parse_list(")", arguments)
                                        : cursor_.expect(")", "the name of the feed law");
  if (!good || !cursor_.finish_line()) return std::nullopt;
  return feed_law_statement(name, law, std::move(arguments));
}

MaybeStatement DirectiveParser::feed_law_statement(const Span& name, const Token& law,
                                                   std::vector<Expression> arguments) {
  const std::string wanted = folded(law.text);
  const std::size_t given = arguments.size();
  Statement statement;
  if (wanted == no_law || wanted == name_of_curve) {
    const bool right = wanted == no_law ? given == 0 : given == 2 || given == 3;
    if (!right) {
      return refuse_law_arguments(name, given,
                                  wanted == no_law
                                      ? "`#feedlaw (off)`"
                                      : "`#feedlaw (curve, distances, feeds)` or "
                                        "`#feedlaw (curve, distances, feeds, speeds)`");
    }
    statement.kind = FeedLawDirective{std::move(arguments)};
    return statement;
  }
  const LawForm* const form = form_called(wanted);
  if (form == nullptr) {
    Diagnostic& diagnostic = reporter_.error(
        "E3023", law.span, "unknown feed law `" + std::string(law.text) + "`", "no such law");
    const std::string_view nearest = nearest_name(law.text, law_names());
    if (!nearest.empty()) diagnostic.help.push_back("did you mean `" + std::string(nearest) + "`?");
    return std::nullopt;
  }
  if (given != form->must_count) return refuse_law_arguments(name, given, signature_of(*form));
  statement.kind = block_of(*form, std::move(arguments));
  return statement;
}

MaybeStatement DirectiveParser::refuse_law_arguments(const Span& name, std::size_t given,
                                                     const std::string& signature) {
  reporter_
      .error("E3005", name, "this feed law does not take " + std::to_string(given) + " values",
             "the number of arguments is wrong")
      .help.push_back("write " + signature);
  return std::nullopt;
}

}  // namespace stanok::lang
