// Block search: where a run stops before a line, or begins at it.
#include <algorithm>

#include "lang/run/block_search.h"
#include "lang/run/program_run.h"
#include "lang/text/reporter.h"

namespace stanok::lang {

void ProgramRun::stop_before(const StopPlace& place) {
  stop_ = place;
  stop_at_hand_ = false;
}

// The next thing to be executed stands in the line searched for, which was not so just before. The
// run has failed when it cannot be entered there.
bool ProgramRun::reaches_stop() {
  const Frame& frame = frames_.back();
  const std::uint32_t line =
      plain_.at != plain_.end ? plain_.line : file().spans[frame.position].line;
  const bool is_there = frame.file == stop_->file && line == stop_->line && !contour_return_ &&
                        is_called_from(stop_->calls);
  const bool arrives = is_there && !stop_at_hand_;
  stop_at_hand_ = is_there;
  if (!arrives || --stop_->passes > 0) return false;
  stop_.reset();
  if (modal_.compensation.on()) {
    fail("E6042", "a program cannot be entered while radius compensation is active",
         "search for the block before G41 or G42");
  }
  return true;
}

bool ProgramRun::is_called_from(const std::vector<std::uint32_t>& calls) const {
  if (calls.empty()) return true;
  if (frames_.size() != calls.size() + 1) return false;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const Frame& caller = frames_[i];
    if (program_->files[caller.file]->spans[caller.position - 1].line != calls[i]) return false;
  }
  return true;
}

// Text of a file outside braces and subprograms; what stands before it is left out.
std::optional<Diagnostic> ProgramRun::start_at(std::shared_ptr<const Program> program,
                                               const AxisValues& position_B,
                                               const StopPlace& place) {
  start(std::move(program), position_B);
  frames_.back().file = place.file;
  const CompiledFile& current = file();
  const auto begins_behind = [&](std::uint32_t line, std::uint32_t entry) {
    return line < current.spans[entry].line;
  };
  const auto next =
      std::upper_bound(current.entries.begin(), current.entries.end(), place.line, begins_behind);
  const auto plain = plain_place(place.line);
  const bool is_entry =
      next != current.entries.begin() && current.spans[*(next - 1)].line == place.line;
  if (plain &&
      std::binary_search(current.entries.begin(), current.entries.end(), plain->position - 1)) {
    plain_ = plain->cursor;
    frames_.back().position = plain->position;
  } else if (is_entry) {
    const auto first = std::lower_bound(
        current.entries.begin(), next, place.line,
        [&](std::uint32_t entry, std::uint32_t line) { return current.spans[entry].line < line; });
    frames_.back().position = *first;
  } else {
    Diagnostic diagnostic =
        diagnostic_at(current.source, "E6042", current.source.words_of_line(place.line),
                      "a program cannot be entered here without calculation",
                      "inside braces, a function or an O-line");
    phase_ = Phase::ended;
    queue_.clear();
    return diagnostic;
  }
  return std::nullopt;
}

}  // namespace stanok::lang
