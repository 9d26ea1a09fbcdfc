#include "lang/run/text_places.h"

#include <algorithm>

#include "lang/run/call_targets.h"
#include "lang/text/block_number.h"
#include "lang/text/number.h"
#include "lang/tree/plain_block.h"

namespace stanok::lang {
namespace {

bool is_called_from(const Vm& vm, const std::vector<std::uint32_t>& calls) {
  if (calls.empty()) return true;
  const std::vector<CallFrame>& frames = vm.frames();
  if (frames.size() != calls.size() + 1) return false;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const CallFrame& caller = frames[i];
    if (vm.program().files[caller.file]->spans[caller.position - 1].line != calls[i]) return false;
  }
  return true;
}

// The beginning of the first line that is so; nullptr: none is.
template <class IsWanted>
const char* line_that(const Source& source, IsWanted is_wanted) {
  const char* const end = source.text().data() + source.end();
  for (const char* at = source.text().data() + source.begin(); at != end;
       at = behind_line(at, end)) {
    if (is_wanted(source.line_at(source.offset_of(at)))) return at;
  }
  return nullptr;
}

// What stands behind O or : at the beginning of a line.
std::optional<int> program_number(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && is_blank(line[at])) ++at;
  if (at == line.size() || (upper_case(line[at]) != 'O' && line[at] != ':')) return std::nullopt;
  std::string number = "N" + std::string(line.substr(at + 1));
  return block_number(number);
}

}  // namespace

TextPlaces::TextPlaces(Vm& vm, BlockState& state, Parameters& parameters)
    : vm_(vm), state_(state), text_values_(parameters) {
  state_.around.contours = this;
}

Contour TextPlaces::contour(int first, int last) {
  const Source& source = vm_.file().source;
  const char* const end = source.text().data() + source.end();
  Contour contour;
  bool inside = false;
  std::uint32_t line = source.begin_line();
  for (const char* at = source.text().data() + source.begin(); at != end; ++line) {
    const std::size_t offset = source.offset_of(at);
    const std::string_view text = source.line_at(offset);
    const auto number = block_number(text);
    inside = inside || number == first;
    const char* next = at;
    BlockWords words;
    const bool plain = inside && read_line(source, next, words);
    if (inside && !plain) {
      contour.problem = "line " + std::to_string(line) + " of the contour is not a plain block";
      return contour;
    }
    if (inside && !words.empty()) contour.blocks.push_back({words, {vm_.frame().file, line}});
    if (inside && number == last) return contour;
    at = plain ? next : behind_line(at, end);
  }
  contour.problem = inside ? "the contour has no end N" + std::to_string(last)
                           : "the program has no block N" + std::to_string(first);
  return contour;
}

bool TextPlaces::read_line(const Source& source, const char*& at, BlockWords& words) {
  const char* const end = source.text().data() + source.end();
  return read_plain_line(at, end, {Surroundings::file_level, source.rules()}, words,
                         text_values_) &&
         text_values_.settings().empty() &&
         (words.letters & state_.channel_words.dialect().alias_letters()) == 0;
}

// A block number of this text comes first, as controls of Haas search.
Contour TextPlaces::subprogram(int number) {
  const std::uint16_t current = vm_.frame().file;
  if (const char* const at = line_that(
          vm_.file().source, [&](std::string_view line) { return block_number(line) == number; }))
    return blocks_up_to_return(current, at);
  const auto found =
      find_numbered_program(vm_.program(), current, number, SearchedTexts::all).place;
  if (!found) {
    Contour contour;
    contour.problem =
        "there is no subprogram N" + std::to_string(number) + " or O" + std::to_string(number);
    return contour;
  }
  const Source& source = vm_.program().files[found->file]->source;
  const char* at =
      line_that(source, [&](std::string_view line) { return program_number(line) == number; });
  at = at != nullptr ? behind_line(at, source.text().data() + source.end())
                     : source.text().data() + source.begin();
  return blocks_up_to_return(found->file, at);
}

Contour TextPlaces::o_subprogram(int number) {
  const std::uint16_t current = vm_.frame().file;
  std::vector<std::uint16_t> files{current};
  const auto& includes = vm_.file().includes;
  files.insert(files.end(), includes.begin(), includes.end());
  for (const std::uint16_t file : files) {
    const Source& source = vm_.program().files[file]->source;
    const char* const at = line_that(source, [&](std::string_view line) {
      return program_number(line) == number && folded(line).find("sub") != std::string::npos;
    });
    if (at == nullptr) continue;
    return blocks_up_to_return(file, behind_line(at, source.text().data() + source.end()), number);
  }
  Contour contour;
  contour.problem = "there is no `O" + std::to_string(number) + " sub` in this text";
  return contour;
}

Contour TextPlaces::blocks_up_to_return(std::uint16_t file, const char* at,
                                        std::optional<int> o_number) {
  const Source& source = vm_.program().files[file]->source;
  const char* const end = source.text().data() + source.end();
  Contour contour;
  for (std::uint32_t line = source.line_number(source.offset_of(at)); at != end; ++line) {
    BlockWords words;
    const std::string_view text = source.line_at(source.offset_of(at));
    if (o_number && program_number(text) == o_number) return contour;
    if (!read_line(source, at, words)) {
      contour.problem = "its line " + std::to_string(line) + " is not a plain block";
      return contour;
    }
    if (words.m.has(m(99)) || words.m.has(m(30))) return contour;
    if (!words.empty()) contour.blocks.push_back({words, {file, line}});
  }
  return contour;
}

std::optional<TextPlaces::PlainPlace> TextPlaces::plain_place(std::uint32_t line) const {
  const CompiledFile& current = vm_.file();
  const char* const text = current.source.text().data();
  for (std::size_t i = 0; i < current.code.size(); ++i) {
    if (current.code[i].op != Op::plain_lines) continue;
    const PlainLines& lines = current.plain_lines[current.code[i].operand];
    PlainCursor cursor{text + lines.begin, text + lines.end, lines.first_line,
                       rules_of(current, lines)};
    for (; !cursor.at_end() && cursor.line < line; ++cursor.line) {
      cursor.at = behind_line(cursor.at, cursor.end);
    }
    if (cursor.line == line) return PlainPlace{cursor, static_cast<std::uint32_t>(i) + 1};
  }
  return std::nullopt;
}

// A contour is plain text: the run goes on in the piece that holds it.
void TextPlaces::go_to(const PlainPlace& place) {
  vm_.plain() = place.cursor;
  vm_.frame().position = place.position;
}

void TextPlaces::go_behind_line(std::uint32_t line) {
  if (const auto place = plain_place(line + 1)) go_to(*place);
}

void TextPlaces::run_contour(std::uint32_t first, std::uint32_t last) {
  const auto begin = plain_place(first);
  const auto end = plain_place(last + 1);
  if (!begin || !end) return;
  contour_return_ = ContourReturn{vm_.plain(), state_.modal.position_W};
  vm_.plain() = begin->cursor;
  vm_.plain().end = end->cursor.at;
}

// Back to the start point, away from the contour first.
void TextPlaces::leave_contour() {
  vm_.plain() = contour_return_->plain;
  const AxisValues start_W = contour_return_->start_W;
  contour_return_.reset();
  ModalState& modal = state_.modal;
  const ChannelWords& words = state_.channel_words;
  for (const AxisIndex axis : {words.geometry_axis(0), words.geometry_axis(2)}) {
    if (!axis.exists() || modal.position_W[axis] == start_W[axis]) continue;
    Move move;
    move.words = axis_bit(axis);
    move.path = modal.path;
    modal.position_W[axis] = start_W[axis];
    move.end = modal.position_W;
    state_.queue.emit(move);
  }
}

void TextPlaces::go_to_number_on_stack() {
  const auto number = vm_.pop_integer("the number of a block");
  if (number) go_to_block(*number);
}

void TextPlaces::go_to_block(int number) {
  CallFrame& frame = vm_.frame();
  if (frame.function != nullptr) {
    return vm_.fail("E3024", "a function has no block numbers to go to", "use `if` and `while`");
  }
  const CompiledFile& current = vm_.file();
  const std::uint32_t from = frame.position == 0 ? 0 : frame.position - 1;
  const auto found = current.block_index.find(number, from);
  if (const auto fault = fault_of_jump(number, found)) {
    return vm_.fail(fault->code, fault->message, fault->label);
  }
  const NumberedBlock& block = *found.block;
  vm_.plain() = {};
  frame.position = block.position;
  if (block.offset == NumberedBlock::no_text) return;
  const PlainLines& lines = current.plain_lines[current.code[block.position].operand];
  const char* const text = current.source.text().data();
  vm_.plain() = {text + block.offset, text + lines.end, block.line, rules_of(current, lines)};
  ++frame.position;
}

bool TextPlaces::enter(std::uint32_t line) {
  const CompiledFile& current = vm_.file();
  const std::vector<std::uint32_t>& entries = current.entries;
  const auto plain = plain_place(line);
  if (plain && std::binary_search(entries.begin(), entries.end(), plain->position - 1)) {
    go_to(*plain);
    return true;
  }
  const auto begins_before = [&](std::uint32_t entry, std::uint32_t wanted) {
    return current.spans[entry].line < wanted;
  };
  const auto first = std::lower_bound(entries.begin(), entries.end(), line, begins_before);
  if (first == entries.end() || current.spans[*first].line != line) return false;
  vm_.frame().position = *first;
  return true;
}

bool SearchStop::is_reached(Vm& vm, const TextPlaces& texts) {
  const CallFrame& frame = vm.frame();
  const PlainCursor& plain = vm.plain();
  const std::uint32_t line = plain.at_end() ? vm.file().spans[frame.position].line : plain.line;
  const bool is_there = frame.file == place_->file && line == place_->line && !texts.in_contour() &&
                        is_called_from(vm, place_->calls);
  const bool arrives = is_there && !was_there_;
  was_there_ = is_there;
  if (!arrives || --place_->passes > 0) return false;
  place_.reset();
  return true;
}

}  // namespace stanok::lang
