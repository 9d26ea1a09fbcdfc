#include "lang/text/reporter.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/nearest_name.h"
#include "lang/text/limits.h"

namespace stanok::lang {

Diagnostic diagnostic_at(const Source& source, std::string_view code, const Span& span,
                         std::string message, std::string label) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.place = source.place(span);
  diagnostic.message = std::move(message);
  diagnostic.label = std::move(label);
  diagnostic.source_line = source.line_at(span.offset);
  return diagnostic;
}

std::string_view nearest_name(std::string_view name,
                              const std::vector<std::string_view>& candidates) {
  const int edits_max = name.size() <= 3 ? 1 : 2;
  return stanok::nearest_name(name, candidates, edits_max);
}

Diagnostic& Reporter::error(std::string_view code, const Span& span, std::string message,
                            std::string label) {
  ++error_count_;
  last_error_ = {std::string(code), span, message, label};
  const Severity severity = is_soft(span.offset) ? Severity::warning : Severity::error;
  if (!keeps(severity)) {
    if (severity == Severity::error && !is_closed_) ++errors_dropped_;
    return overflow_ = {};
  }
  Diagnostic diagnostic = diagnostic_at(source_, code, span, std::move(message), std::move(label));
  diagnostic.severity = severity;
  return keep(std::move(diagnostic));
}

Diagnostic& Reporter::warning(std::string_view code, const Span& span, std::string message,
                              std::string label) {
  if (!keeps(Severity::warning)) return overflow_ = {};
  Diagnostic diagnostic = diagnostic_at(source_, code, span, std::move(message), std::move(label));
  diagnostic.severity = Severity::warning;
  return keep(std::move(diagnostic));
}

std::optional<std::uint32_t> Reporter::find_error_line(
    const std::function<bool(std::string_view)>& is_meant) const {
  for (const Diagnostic& diagnostic : diagnostics_) {
    const bool error = diagnostic.severity == Severity::error;
    if (error && is_meant(diagnostic.source_line))
      return static_cast<std::uint32_t>(diagnostic.place.line);
  }
  return std::nullopt;
}

void Reporter::tell_only(Diagnostic diagnostic) {
  is_closed_ = false;
  diagnostics_.clear();
  errors_kept_ = 0;
  errors_dropped_ = 0;
  add(std::move(diagnostic));
  is_closed_ = true;
}

void Reporter::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::error) ++error_count_;
  keep(std::move(diagnostic));
}

bool Reporter::keeps(Severity severity) const {
  if (is_closed_) return false;
  return (severity == Severity::error ? errors_kept_ : warnings_kept_) < limits::diagnostics;
}

// Errors and warnings have their own limits: warnings never hide an error.
Diagnostic& Reporter::keep(Diagnostic diagnostic) {
  if (!keeps(diagnostic.severity)) return overflow_ = std::move(diagnostic);
  ++(diagnostic.severity == Severity::error ? errors_kept_ : warnings_kept_);
  diagnostics_.push_back(std::move(diagnostic));
  return diagnostics_.back();
}

Diagnostic more_errors(const Source& source, std::size_t count) {
  const auto line = static_cast<std::uint32_t>(source.line_count());
  Diagnostic diagnostic = diagnostic_at(source, "W213", source.words_of_line(line),
                                        std::to_string(count) + " more errors are not shown", {});
  diagnostic.severity = Severity::warning;
  diagnostic.source_line.clear();
  return diagnostic;
}

Diagnostics Reporter::take() {
  std::multimap<std::pair<int, int>, Diagnostic> by_place;
  for (Diagnostic& diagnostic : diagnostics_) {
    const std::pair place(diagnostic.place.line, diagnostic.place.column);
    by_place.emplace(place, std::move(diagnostic));
  }
  diagnostics_.clear();
  Diagnostics ordered;
  for (auto& [place, diagnostic] : by_place) ordered.push_back(std::move(diagnostic));
  if (errors_dropped_ > 0) ordered.push_back(more_errors(source_, errors_dropped_));
  return ordered;
}

}  // namespace stanok::lang
