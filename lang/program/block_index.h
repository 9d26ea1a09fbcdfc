// Where the block numbers of a file stand: what GOTO and M99 P go to.
//
// Made once, when a program that jumps is loaded. A number means a block of the numbered program in
// which the jump stands (from its O to the next one). Nothing jumps into a loop from outside. Of
// blocks with one number the dialects of Fanuc take the first behind the jump, or else the first of
// the program; elsewhere such a jump is an error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stanok::lang {

struct CompiledFile;

// A block with a number.
struct NumberedBlock {
  static constexpr std::size_t no_text = ~std::size_t{0};

  int number = 0;
  std::uint32_t program = 0;   // from which instruction on its numbered program is
  std::uint32_t position = 0;  // instruction that executes it
  std::uint32_t line = 0;
  std::size_t offset = no_text;  // of a plain line, in the text
  // Instructions of the innermost loop around it: those that may jump there.
  std::uint32_t loop_begin = 0;
  std::uint32_t loop_end = ~std::uint32_t{0};
};

class BlockIndex {
 public:
  // Why there is no block to go to.
  enum class Missing : std::uint8_t { none, unknown, twice, inside_loop };
  struct Found {
    const NumberedBlock* block = nullptr;
    Missing missing = Missing::unknown;
    std::uint32_t second_line = 0;  // twice: of the other one
  };

  // Reads the numbers of all blocks of the file.
  void read(const CompiledFile& file);
  [[nodiscard]] bool is_read() const { return read_; }
  // The block `number` for a jump by the instruction at `from`.
  [[nodiscard]] Found find(int number, std::uint32_t from) const;

 private:
  void read_plain_lines(const CompiledFile& file);
  void find_loops(const CompiledFile& file);
  void add(NumberedBlock block);
  [[nodiscard]] std::uint32_t program_of(std::uint32_t position) const;

  bool read_ = false;
  bool takes_next_ = false;              // of blocks with one number
  std::vector<std::uint32_t> programs_;  // where numbered programs begin, ascending
  std::vector<NumberedBlock> blocks_;    // by number, program and line
};

// What a jump to block `number` is told that found nothing to go to.
struct JumpFault {
  std::string_view code;
  std::string message;
  std::string label;
};
[[nodiscard]] std::optional<JumpFault> fault_of_jump(int number, const BlockIndex::Found& found);

}  // namespace stanok::lang
