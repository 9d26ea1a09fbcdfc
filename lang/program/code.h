// Compiled programs: the code of one program file, for a machine with a stack of values.
//
// The stack is explicit and outlives every instruction, so that interpretation can stop at a
// ProgramRequest in the middle of an expression and go on with the answer.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/contract/command.h"
#include "lang/program/block_index.h"
#include "lang/program/compile.h"
#include "lang/text/source.h"
#include "lang/tree/tree.h"
#include "lang/words/block_words.h"

namespace stanok::lang {

// Stack effects are written (before -> after), top on the right.
enum class Op : std::uint8_t {
  push_number,  // ( -> number): numbers[operand]
  push_text,    // ( -> string): texts[operand]
  push_axis,    // ( -> axis): the axis called texts[operand]
  pop,          // (value -> )
  duplicate,    // the top `count` values once more
  load_local,   // slots of the current function
  store_local,
  load_file,  // slots of the file
  store_file,
  load_reference,  // the variable to which local slot `operand` refers
  store_reference,
  reference_local,  // ( -> reference)
  reference_file,
  element,            // (array index... -> value), `count` indices
  store_element,      // (array index... value -> )
  element_reference,  // (array index... -> reference)
  new_array,          // (size... -> array), `count` dimensions; operand 1: of strings
  fill_array,         // (array value... -> array), operand values
  parameter,          // (n -> #n); extra 1: a vacant one stays vacant
  named_parameter,    // ( -> #<name>): slot `operand` of the program's named parameters
  named_parameter_exists,
  predefined_parameter,  // ( -> value of predefined_parameters()[operand])
  r_parameter,           // ( -> Rn), n = operand
  settings,              // settings[operand], their numbers and values on the stack
  compute,             // (left right -> result): Operation `extra`; unary ones (operand -> result)
  join_texts,          // (string string -> string)
  texts_equal,         // (string string -> bool)
  jump,                // to operand
  jump_if_false,       // (bool -> )
  jump_if_false_keep,  // jumps with the value, else drops it
  jump_if_true_keep,
  jump_if_skipped,  // block skip of level `count` is on
  go_to,            // (n -> ): to block N n of the text
  call,             // callees[operand], arguments on the stack
  return_value,
  return_nothing,
  call_o_sub,         // o_calls[operand], `count` arguments and a computed number on the stack
  return_from_o_sub,  // count 1: (value -> )
  builtin,            // builtins()[operand] with `count` arguments
  system_value,       // system_variables()[operand]; count 1: with an index on the stack
  plain_lines,        // plain_lines[operand]
  block,              // blocks[operand], its computed words on the stack
  message,            // (string -> ): Message::Kind `extra`
  request,            // builtins()[operand] asked from the channel; extra 1: statement form
  request_value,      // system_variables()[operand] asked from the channel
  kinematics,         // (scheme channel -> )
  terminate,          // (code text -> )
  call_file,          // (name -> )
  channel_error,      // ( -> string)
  save_gvector,       // (parts -> string)
  restore_gvector,    // (string -> bool); count 1: statement form
  argument,           // (name -> value), count 1: (name -> bool)
  raise,              // faults[operand]: a faulty statement was reached
  table,              // builtins()[operand] with `count` arguments; extra 1: statement form, 2: the
                      // third argument is a number
  tool_overhang,      // (value axis -> ), `count` of them are there: 0, 1 or 2
  feed_law,           // (array... -> ), `count` of them: 0 no law, else a curve
  adaptive,           // (number... -> ), `count` of them: ForceControl::Kind `extra`
  orientation,        // TurningWay `extra`
  workpiece,          // (number... -> ): extra 0 the workpiece, 1 its position, 2 the workpiece of
                      // the file called texts[operand]
  read_shared,        // (index... -> value): shared[operand], `count` indices
  write_shared,       // (index... value -> )
  combine_shared,     // (index... value -> ): Combination `extra`
  mark,               // (id channel... -> ): builtins()[operand] with `count` arguments
  end_of_text,
};

struct Instruction {
  Op op = Op::end_of_text;
  std::uint8_t count = 0;
  std::uint16_t extra = 0;
  std::uint32_t operand = 0;
};

// Where a value that the code computes goes in a block.
struct ComputedWord {
  enum class Kind : std::uint8_t { letter, g_code, m_code, named, spindle } kind = Kind::letter;
  char letter = 0;
  std::uint16_t index = 0;  // of a code or a named word in the block
};

struct BlockTemplate {
  BlockWords words;  // constants are filled in
  std::vector<ComputedWord> computed;
  Span span;                    // the whole block
  std::vector<IsoWord> places;  // names and spans of the words, without their expressions
};

struct FunctionSignature {
  Type result = Type::none;
  std::string name;
  Span span;
  std::vector<FunctionParameter> parameters;
};

struct FunctionCode {
  FunctionSignature signature;
  std::uint32_t entry = 0;
  std::uint32_t slots = 0;
  bool o_subprogram = false;
};

// A function of this or an included file.
struct Callee {
  std::uint16_t file = 0;
  std::uint32_t function = 0;
};

// A call by an O-line; a computed one finds its subprogram when it is reached.
struct OCallCode {
  Callee callee;
  bool computed = false;
};

// #n=..., #<name>=..., R5=... of one block, in the order written.
struct SettingTarget {
  enum class Kind : std::uint8_t { numbered, named, r_parameter } kind = Kind::numbered;
  std::uint32_t slot = 0;  // named, r_parameter
};

// A statement with a block number that is no plain line.
struct NumberedStatement {
  int number = 0;
  std::uint32_t position = 0;
  std::uint32_t line = 0;
};

// The code of a loop, end excluded: nothing outside jumps into it.
struct LoopCode {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

// GOTO with a number that is known when the program is loaded.
struct ConstantJump {
  int number = 0;
  std::uint32_t position = 0;
  Span span;
};

// A parameter that is a variable here and has a meaning on controls of Fanuc.
enum class ParameterAccess : std::uint8_t { read, set };
struct ParameterUse {
  int number = 0;
  ParameterAccess access = ParameterAccess::read;
  Span span;
};

// The code of one file. `spans` stands parallel to `code`.
struct CompiledFile {
  explicit CompiledFile(Source text) : source(std::move(text)) {}

  Source source;
  std::vector<Instruction> code;
  std::vector<Span> spans;
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::vector<PlainLines> plain_lines;
  std::vector<BlockTemplate> blocks;
  std::vector<SharedVariable> shared;
  std::vector<FunctionCode> functions;
  std::vector<Callee> callees;
  std::vector<OCallCode> o_calls;
  std::vector<std::vector<SettingTarget>> settings;
  std::vector<Fault> faults;
  std::vector<NumberedStatement> numbered_statements;
  std::vector<LoopCode> loops;
  std::vector<ConstantJump> jumps;
  std::vector<ParameterUse> parameter_uses;
  BlockIndex block_index;                                 // empty: nothing jumps to numbers
  std::map<int, std::uint32_t> numbered_programs;         // O number -> instruction
  std::map<std::string, std::uint32_t> function_by_name;  // folded
  std::map<std::string, std::uint32_t> o_subprograms;     // label -> index in functions
  std::vector<std::uint16_t> includes;  // files whose functions can be called here
  std::uint32_t file_slots = 0;
  std::vector<std::uint32_t> entries;  // instructions with which statements of the file begin
};

}  // namespace stanok::lang
