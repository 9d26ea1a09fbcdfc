#include "tests/support/declared_names.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace stanok::testing {
namespace {

struct Token {
  std::string text;
  bool begins_line = false;  // in the first column
};

// Behind the comment, literal or directive that begins at `at`; `at` itself where code does.
std::size_t behind_no_code(std::string_view text, std::size_t at) {
  const auto behind = [&](std::string_view mark, std::size_t from) {
    const std::size_t found = text.find(mark, from);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  const auto behind_line = [&](std::size_t from) {
    while (from < text.size() && text[from] != '\n') from += text[from] == '\\' ? 2 : 1;
    return std::min(from, text.size());
  };
  const std::string_view here = text.substr(at);
  const bool begins_line = at == 0 || text[at - 1] == '\n';
  if (here.starts_with("//") || (begins_line && here[0] == '#')) return behind_line(at);
  if (here.starts_with("/*")) return behind("*/", at + 2);
  if (here.starts_with("R\"")) {
    const std::string mark(here.substr(2, here.find('(') - 2));
    return behind(")" + mark + "\"", at + 2);
  }
  const bool is_separator = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
  if (here[0] != '"' && (here[0] != '\'' || is_separator)) return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != here[0]) end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = behind_no_code(text, at);
    if (end > at || text[at] == ' ' || text[at] == '\n') {
      at = std::max(end, at + 1);
      continue;
    }
    std::size_t size = 1;
    if (is_of_name(text[at])) {
      while (at + size < text.size() && is_of_name(text[at + size])) ++size;
    } else {
      for (const std::string_view mark : {"::", "->", "<<", "[[", "]]"}) {
        if (text.substr(at).starts_with(mark)) size = mark.size();
      }
    }
    tokens.push_back({std::string(text.substr(at, size)), at == 0 || text[at - 1] == '\n'});
    at += size;
  }
  return tokens;
}

bool is_name(const std::string& text) {
  static const std::set<std::string> keywords{"decltype", "alignas", "operator", "noexcept"};
  return is_of_name(text[0]) && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         !keywords.contains(text);
}

class NameReader {
 public:
  explicit NameReader(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  std::set<DeclaredName> names() {
    while (at_ < tokens_.size()) {
      if (!tokens_[at_].begins_line) {
        ++at_;
      } else if (text() == "namespace") {
        open_namespace();
      } else if (text() == "}") {
        close();
      } else {
        read_declaration();
      }
    }
    return std::move(names_);
  }

 private:
  [[nodiscard]] const std::string& text(std::size_t ahead = 0) const {
    static const std::string end = ";";
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].text : end;
  }

  // `namespace fs = ...` opens none.
  void open_namespace() {
    std::string name;
    for (++at_; is_name(text()) || text() == "::"; ++at_) name += text();
    if (text() == "{") scopes_.push_back(name);
    ++at_;
  }

  // A namespace, or the body that was open.
  void close() {
    if (!in_body_ && !scopes_.empty()) scopes_.pop_back();
    in_body_ = false;
    ++at_;
  }

  // Behind the bracket that closes the one here.
  void skip_brackets(const std::string& open, const std::string& closed) {
    int depth = 0;
    do {
      if (text() == open) ++depth;
      if (text() == closed) --depth;
      ++at_;
    } while (depth > 0 && at_ < tokens_.size());
  }

  void read_declaration() {
    const std::size_t begin = at_;
    if (text() == "template") {
      ++at_;
      skip_brackets("<", ">");
    }
    while (text() == "[[") skip_brackets("[[", "]]");
    if (text() == "using") {
      if (text(2) == "=") add(text(1));
    } else if (text() == "enum" || text() == "struct" || text() == "class") {
      read_type();
    } else if (text() != "static_assert" && text() != "extern") {
      read_function_or_variable();
    }
    at_ = std::max(at_, begin + 1);
    go_behind_head();
  }

  void read_type() {
    const bool is_enumeration = text() == "enum";
    ++at_;
    const bool is_scoped = text() == "class" || text() == "struct";
    if (is_scoped) ++at_;
    if (text() == "alignas") {
      ++at_;
      skip_brackets("(", ")");
    }
    while (text() == "[[") skip_brackets("[[", "]]");
    if (is_name(text()) && text(1) != "<") add(text());  // "<": of a specialisation
    if (is_enumeration && !is_scoped) add_enumerators();
  }

  void add_enumerators() {
    std::size_t ahead = 0;
    while (text(ahead) != "{" && text(ahead) != ";") ++ahead;
    for (; text(ahead) != "}" && text(ahead) != ";"; ++ahead) {
      if (text(ahead) != "{" && text(ahead) != ",") continue;
      if (is_name(text(ahead + 1))) add(text(ahead + 1));
    }
  }

  // An index, decltype or alignas, with what is in its brackets.
  bool skip_within_declaration() {
    if (text() == "[") {
      skip_brackets("[", "]");
      return true;
    }
    if (text() != "decltype" && text() != "alignas") return false;
    ++at_;
    skip_brackets("(", ")");
    return true;
  }

  // The name before the first parenthesis, "=", brace or semicolon that is outside of <>.
  void read_function_or_variable() {
    const std::size_t begin = at_;
    std::size_t name = begin;
    int depth = 0;
    for (; at_ < tokens_.size(); ++at_) {
      if (text() == "operator") return;
      if (text() == "<") ++depth;
      if (text() == ">") --depth;
      if (skip_within_declaration()) {
        --at_;
      } else if (depth == 0 && (text() == "=" || text() == "{" || text() == ";")) {
        break;
      } else if (depth == 0 && text() == "(") {
        if (text(1) == "*") name = at_ + (text(2) == "const" ? 3 : 2);  // pointer to a function
        break;
      } else if (depth == 0 && is_name(text())) {
        name = at_;
      }
    }
    // Without a type before it: a macro, a deduction guide. Behind "::": a member.
    if (name > begin && name < tokens_.size() && tokens_[name - 1].text != "::")
      add(tokens_[name].text);
  }

  // To the next line that begins in the first column; a body that is open ends there.
  void go_behind_head() {
    int depth = 0;
    while (at_ < tokens_.size() && !tokens_[at_].begins_line) {
      if (text() == "{") ++depth;
      if (text() == "}") --depth;
      ++at_;
    }
    in_body_ = depth > 0;
  }

  void add(const std::string& name) {
    DeclaredName declared{.scope = {}, .name = name, .is_unnamed = false};
    for (const std::string& scope : scopes_) {
      declared.is_unnamed = declared.is_unnamed || scope.empty();
      if (!scope.empty()) declared.scope += (declared.scope.empty() ? "" : "::") + scope;
    }
    names_.insert(std::move(declared));
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<std::string> scopes_;
  bool in_body_ = false;
  std::set<DeclaredName> names_;
};

}  // namespace

std::set<DeclaredName> declared_names(std::string_view text) {
  return NameReader(tokens_of(text)).names();
}

}  // namespace stanok::testing
