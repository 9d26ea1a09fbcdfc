#include "lang/program/block_index.h"

#include <algorithm>
#include <tuple>

#include "lang/program/code.h"
#include "lang/text/block_number.h"

namespace stanok::lang {
namespace {

auto order_of_block(const NumberedBlock& block) {
  return std::tuple(block.number, block.program, block.line);
}

}  // namespace

void BlockIndex::read(const CompiledFile& file) {
  read_ = true;
  takes_next_ = file.source.rules().is_fanuc();
  programs_ = {0};
  for (const auto& [number, position] : file.numbered_programs) programs_.push_back(position);
  std::sort(programs_.begin(), programs_.end());
  for (const NumberedStatement& one : file.numbered_statements) {
    add({one.number, 0, one.position, one.line, NumberedBlock::no_text});
  }
  read_plain_lines(file);
  find_loops(file);
  std::sort(blocks_.begin(), blocks_.end(), [](const NumberedBlock& a, const NumberedBlock& b) {
    return order_of_block(a) < order_of_block(b);
  });
}

void BlockIndex::read_plain_lines(const CompiledFile& file) {
  const std::string_view text = file.source.text();
  for (std::size_t i = 0; i < file.code.size(); ++i) {
    if (file.code[i].op != Op::plain_lines) continue;
    const PlainLines& lines = file.plain_lines[file.code[i].operand];
    const char* const end = text.data() + lines.end;
    std::uint32_t line = lines.first_line;
    for (const char* at = text.data() + lines.begin; at != end; at = behind_line(at, end), ++line) {
      const std::size_t offset = file.source.offset_of(at);
      const auto number = block_number(text.substr(offset, lines.end - offset));
      if (number) add({*number, 0, static_cast<std::uint32_t>(i), line, offset});
    }
  }
}

void BlockIndex::add(NumberedBlock block) {
  block.program = program_of(block.position);
  blocks_.push_back(block);
}

std::uint32_t BlockIndex::program_of(std::uint32_t position) const {
  return *std::prev(std::upper_bound(programs_.begin(), programs_.end(), position));
}

// Loops lie in one another or apart: who is in the innermost one around a block is in all others
// around it. One pass over blocks and loops in the order of the text.
void BlockIndex::find_loops(const CompiledFile& file) {
  std::vector<LoopCode> loops = file.loops;
  std::sort(loops.begin(), loops.end(), [](const LoopCode& a, const LoopCode& b) {
    return std::tuple(a.begin, b.end) < std::tuple(b.begin, a.end);
  });
  std::sort(blocks_.begin(), blocks_.end(),
            [](const NumberedBlock& a, const NumberedBlock& b) { return a.position < b.position; });
  std::vector<LoopCode> open;
  auto next = loops.begin();
  for (NumberedBlock& block : blocks_) {
    const auto close = [&](std::uint32_t position) {
      while (!open.empty() && open.back().end <= position) open.pop_back();
    };
    for (; next != loops.end() && next->begin <= block.position; ++next) {
      close(next->begin);
      open.push_back(*next);
    }
    close(block.position);
    if (open.empty()) continue;
    block.loop_begin = open.back().begin;
    block.loop_end = open.back().end;
  }
}

std::optional<JumpFault> fault_of_jump(int number, const BlockIndex::Found& found) {
  const std::string name = "N" + std::to_string(number);
  switch (found.missing) {
    case BlockIndex::Missing::none:
      return std::nullopt;
    case BlockIndex::Missing::unknown:
      return JumpFault{"E3024", "this program has no block " + name,
                       "a jump stays between its own O number and the next one"};
    case BlockIndex::Missing::twice:
      return JumpFault{"E3024",
                       name + " appears twice, in lines " + std::to_string(found.block->line) +
                           " and " + std::to_string(found.second_line),
                       "it is not clear which block is meant"};
    case BlockIndex::Missing::inside_loop:
      return JumpFault{"E3024", name + " is inside a loop",
                       "a loop can be entered only at its beginning"};
  }
  return std::nullopt;
}

BlockIndex::Found BlockIndex::find(int number, std::uint32_t from) const {
  const std::tuple wanted(number, program_of(from), 0U);
  const auto found = std::lower_bound(
      blocks_.begin(), blocks_.end(), wanted,
      [](const NumberedBlock& block, const auto& key) { return order_of_block(block) < key; });
  const auto is_meant = [&](auto block) {
    return block != blocks_.end() && block->number == number &&
           block->program == std::get<1>(wanted);
  };
  if (!is_meant(found)) return {};
  auto meant = found;
  if (is_meant(std::next(found))) {
    if (!takes_next_) return {&*found, Missing::twice, std::next(found)->line};
    meant = std::partition_point(found, blocks_.end(), [&](const NumberedBlock& block) {
      return order_of_block(block) < std::tuple(number, program_of(from) + 1, 0U) &&
             block.position <= from;
    });
    if (!is_meant(meant)) meant = found;
  }
  if (from < meant->loop_begin || from >= meant->loop_end)
    return {&*meant, Missing::inside_loop, 0};
  return {&*meant, Missing::none, 0};
}

}  // namespace stanok::lang
