// What the compilation of one file reads besides its tree: the program, the other files' names, the
// channel. Shared by the compilers of all constructs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lang/contract/environment.h"
#include "lang/program/program.h"
#include "lang/text/compile_watch.h"
#include "lang/text/reporter.h"
#include "lang/tree/tree.h"
#include "lang/words/channel_dialect.h"

namespace stanok::lang {

struct Constant {
  Type type = Type::number;
  double number = 0.0;
  std::string text;
};

// What a file offers to the files that include it. Names are folded.
struct FileNames {
  std::map<std::string, std::uint32_t> functions;      // index in CompiledFile::functions
  std::map<std::string, std::uint32_t> o_subprograms;  // the same, by label
  std::map<std::string, Constant> constants;
};

struct CompilerContext {
  Program& program;
  std::uint16_t file = 0;
  const ChannelDescription* channel = nullptr;  // nullptr: no channel-dependent checks
  const ChannelDialect& dialect;
  std::vector<FileNames>& names;  // of all files, by index
  Reporter& reporter;
  const CompileWatch& watch;

  [[nodiscard]] CompiledFile& compiled() const { return *program.files[file]; }
  [[nodiscard]] FileNames& own_names() const { return names[file]; }
};

// Whether a call may name its own channel.
enum class OwnChannel : std::uint8_t { allowed, refused };

}  // namespace stanok::lang
