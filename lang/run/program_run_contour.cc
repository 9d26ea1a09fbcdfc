// Contours that a cycle names by block numbers: found in the text of the file at hand, read as
// plain lines.
#include <optional>

#include "lang/run/program_run.h"
#include "lang/text/block_number.h"
#include "lang/text/number.h"
#include "lang/tree/plain_block.h"

namespace stanok::lang {

// The first N `first` of the file and all that follows up to N `last`.
Contour ProgramRun::contour(int first, int last) {
  const Source& source = file().source;
  const char* const end = source.text().data() + source.end();
  Contour contour;
  bool inside = false;
  std::uint32_t line = source.begin_line();
  for (const char* at = source.text().data() + source.begin(); at != end; ++line) {
    const auto offset = static_cast<std::size_t>(at - source.text().data());
    const std::string_view text = source.line_at(offset);
    const auto number = block_number(text);
    inside = inside || number == first;
    const char* next = at;
    BlockWords words;
    const bool plain = inside &&
                       read_plain_line(next, end, Surroundings::file_level, words, text_values_) &&
                       text_values_.settings().empty() &&
                       (words.letters & channel_words_.dialect().alias_letters()) == 0;
    if (inside && !plain) {
      contour.problem = "line " + std::to_string(line) + " of the contour is no plain block";
      return contour;
    }
    if (inside && !words.empty()) {
      contour.blocks.push_back({words, {frames_.back().file, line}});
    }
    if (inside && number == last) return contour;
    at = plain ? next : behind_line(at, end);
  }
  contour.problem = inside ? "the contour has no end N" + std::to_string(last)
                           : "the program has no block N" + std::to_string(first);
  return contour;
}

std::optional<ProgramRun::PlainPlace> ProgramRun::plain_place(std::uint32_t line) const {
  const CompiledFile& current = file();
  const char* const text = current.source.text().data();
  for (std::size_t i = 0; i < current.code.size(); ++i) {
    if (current.code[i].op != Op::plain_lines) continue;
    const PlainLines& lines = current.plain_lines[current.code[i].operand];
    PlainCursor cursor{text + lines.begin, text + lines.end, lines.first_line, lines.surroundings};
    for (; cursor.at != cursor.end && cursor.line < line; ++cursor.line) {
      cursor.at = behind_line(cursor.at, cursor.end);
    }
    if (cursor.line == line) return PlainPlace{cursor, static_cast<std::uint32_t>(i) + 1};
  }
  return std::nullopt;
}

// A contour is plain text: the run goes on in the piece that holds it.
void ProgramRun::go_behind_line(std::uint32_t line) {
  const auto place = plain_place(line + 1);
  if (!place) return;
  plain_ = place->cursor;
  frames_.back().position = place->position;
}

void ProgramRun::run_contour(std::uint32_t first, std::uint32_t last) {
  const auto begin = plain_place(first);
  const auto end = plain_place(last + 1);
  if (!begin || !end) return;
  contour_return_ = ContourReturn{plain_, modal_.position_W};
  plain_ = begin->cursor;
  plain_.end = end->cursor.at;
}

// Back to the start point, away from the contour first.
void ProgramRun::leave_contour() {
  plain_ = contour_return_->plain;
  const AxisValues start_W = contour_return_->start_W;
  contour_return_.reset();
  for (const std::size_t coordinate : {std::size_t{0}, std::size_t{2}}) {
    const int found = channel_words_.geometry_axis(coordinate);
    const auto axis = static_cast<std::size_t>(found);
    if (found < 0 || modal_.position_W[axis] == start_W[axis]) continue;
    Move move;
    move.words = axis_bit(axis);
    move.path = modal_.path;
    modal_.position_W[axis] = start_W[axis];
    move.end = modal_.position_W;
    queue_.emit(move);
  }
}

}  // namespace stanok::lang
