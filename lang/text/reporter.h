// Collects what is said about one program text while it is read and compiled.
//
// Up to 100 errors and 100 warnings a text; after that the compiler goes on silently. Errors in
// text after the end of the program (after M2, M30) are kept as warnings, because that text may
// never be reached.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "lang/text/source.h"

namespace stanok::lang {

// What is wrong with a piece of text. Short: a text may have millions that nobody is told of.
struct Fault {
  std::string code;
  Span span;
  std::string message;
  std::string label;
};

class Reporter {
 public:
  explicit Reporter(const Source& source) : source_(source) {}

  // The diagnostic may be completed by the caller (notes, help) until the next report.
  Diagnostic& error(std::string_view code, const Span& span, std::string message,
                    std::string label = {});
  Diagnostic& warning(std::string_view code, const Span& span, std::string message,
                      std::string label = {});

  // A diagnostic made elsewhere.
  void add(Diagnostic diagnostic);

  // Errors from `offset` on are warnings: text that only subprogram calls can reach.
  void soften_from(std::size_t offset) { soft_offset_ = std::min(soft_offset_, offset); }
  [[nodiscard]] bool is_soft(std::size_t offset) const { return offset >= soft_offset_; }

  // A name whose declaration at `offset` is at fault: that it is not known is not told again. What
  // is only a warning there leaves the uses to be errors.
  void spoil(std::string_view name, std::size_t offset) {
    if (!is_soft(offset)) spoilt_.insert(folded(name));
  }
  [[nodiscard]] bool is_spoilt(std::string_view name) const {
    return spoilt_.contains(folded(name));
  }

  // The line of the first error whose text `is_meant`; nothing: there is none.
  [[nodiscard]] std::optional<std::uint32_t> find_error_line(
      const std::function<bool(std::string_view)>& is_meant) const;
  // This is all there is to say about the text, whatever comes later.
  void tell_only(Diagnostic diagnostic);

  // Number of errors reported so far, softened ones included.
  [[nodiscard]] std::size_t error_count() const { return error_count_; }
  // The last error as it was reported first, for text that is an error only when reached.
  [[nodiscard]] const Fault& last_error() const { return last_error_; }
  // False: it came after the hundredth, and what would complete it need not be found out.
  [[nodiscard]] bool is_kept(const Diagnostic& diagnostic) const {
    return &diagnostic != &overflow_;
  }
  // Everything reported, in the order of the text.
  [[nodiscard]] Diagnostics take();

 private:
  [[nodiscard]] bool keeps(Severity severity) const;
  Diagnostic& keep(Diagnostic diagnostic);

  const Source& source_;
  Diagnostics diagnostics_;
  std::set<std::string> spoilt_;
  Fault last_error_;
  Diagnostic overflow_;  // takes what comes after the hundredth error
  std::size_t error_count_ = 0;
  bool is_closed_ = false;  // by tell_only()
  std::size_t errors_kept_ = 0;
  std::size_t warnings_kept_ = 0;
  std::size_t errors_dropped_ = 0;
  std::size_t soft_offset_ = std::numeric_limits<std::size_t>::max();
};

// A diagnostic at `span` of `source`, with the source line for the picture.
[[nodiscard]] Diagnostic diagnostic_at(const Source& source, std::string_view code,
                                       const Span& span, std::string message, std::string label);

// The warning W213 at the end of the text: so many errors are not shown.
[[nodiscard]] Diagnostic more_errors(const Source& source, std::size_t count);

// The candidate that is most like `name` (at most 2 edits, fewer for short names), or an empty
// view.
[[nodiscard]] std::string_view nearest_name(std::string_view name,
                                            const std::vector<std::string_view>& candidates);

}  // namespace stanok::lang
