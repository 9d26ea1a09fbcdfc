// From the name of a program to the program: compiling it, and what can be asked of it afterwards.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "lang/contract/command.h"
#include "lang/contract/environment.h"
#include "lang/text/compile_watch.h"

namespace stanok::lang {

class Program;  // a compiled program with all it includes; immutable, shared

// Compiles `name` for a channel: all errors of the text and its includes (up to 100 a file), or the
// program. Warnings are appended to `warnings`. `channel` may be nullptr: channel-dependent checks
// are left out then. Memory that does not suffice is an error of the program (E8002), and so is
// an interruption (E6072).
[[nodiscard]] Expected<std::shared_ptr<const Program>, Diagnostics> compile(
    std::string_view name, const Files& files, const ChannelDescription* channel,
    Diagnostics& warnings, const Interruption& interrupted = {});

// Compiles one line as an operator types it: one complete statement. Functions of `loaded` and of
// what it includes can be called; nullptr: there is no program.
[[nodiscard]] Expected<std::shared_ptr<const Program>, Diagnostics> compile_line(
    std::string_view line, const Program* loaded, const Files& files,
    const ChannelDescription* channel, Diagnostics& warnings, const Interruption& interrupted = {});

// File names of the job, by Origin::file.
[[nodiscard]] std::string_view file_name(const Program& program, std::uint16_t file);
[[nodiscard]] std::vector<std::string> file_names(const Program& program);

// Puts a diagnostic that came up when a block was executed to its place: file, line, the columns of
// its words, source line.
void put_at_block(const Program& program, const Origin& origin, Diagnostic& diagnostic);

// A constant channel_run/channel_load/#kinematics found in a program: `check` follows them.
struct ConstantDispatch {
  RequestKind kind = RequestKind::channel_run;  // channel_run, channel_load, kinematics
  int channel = 0;
  int scheme = 0;       // kinematics
  std::string program;  // channel_run, channel_load
  Place place;
};
[[nodiscard]] const std::vector<ConstantDispatch>& constant_dispatches(const Program& program);

// A variable of all channels. Each program that uses it declares it with the same type and size.
struct SharedVariable {
  std::string name;  // folded
  bool is_text = false;
  bool is_bool = false;
  std::uint32_t rows = 1;
  std::uint32_t columns = 0;  // array of two dimensions
  bool is_array = false;
  Place place;

  [[nodiscard]] std::uint32_t elements() const { return rows * (columns == 0 ? 1 : columns); }
};
// All shared variables that the files of a program declare.
[[nodiscard]] std::vector<SharedVariable> shared_variables(const Program& program);

// Number of lines of the main text, for progress.
[[nodiscard]] std::size_t line_count(const Program& program);

}  // namespace stanok::lang
