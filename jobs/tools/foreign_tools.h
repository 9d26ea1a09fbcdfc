// Tools of other programs and controls, as rows of stanok's tables file.
//
// A reader (linuxcnc_table.h, ...) makes ForeignTools of a file; a writer makes files of rows. What
// a format has and the tables file has not, or the other way round, is a NotCarried: nothing is
// dropped without being named. All lengths are mm, all angles deg, as in channels::ToolEdge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "channels/contract/machine_config.h"

namespace stanok::jobs {

enum class LengthUnit : std::uint8_t { mm, inch };

// What a control calls the size of a cutter.
enum class CutterSize : std::uint8_t { radius, diameter };

struct ForeignTool {
  channels::ToolEdge edge;
  std::vector<std::string_view> given;  // the keys of the tables file that the foreign file gives
};

struct NotCarried {
  int tool = 0;  // 0: of the file, not of a tool
  int edge = 1;
  std::string field;  // as the format that has it calls it
  std::string value;
  std::string reason;
};

struct ForeignTools {
  std::vector<ForeignTool> tools;  // by number and edge, ascending
  std::vector<NotCarried> not_carried;
  std::vector<std::string> remarks;  // what was assumed
};

// The bytes of a file; nothing: there is none that can be read.
using FileBytes = std::function<std::optional<std::string>(const std::filesystem::path&)>;

struct ForeignSource {
  std::filesystem::path file;
  std::string bytes;
  std::optional<LengthUnit> unit;    // of a file that does not state it
  std::optional<CutterSize> cutter;  // of a listing, which does not state it
  FileBytes other_file;              // for files that the file names
};

struct WriteChoice {
  std::filesystem::path file;  // its name decides between variants of a format
  LengthUnit unit = LengthUnit::mm;
  std::optional<CutterSize> cutter;
};

struct ForeignFile {
  std::filesystem::path file;
  std::string bytes;
};

}  // namespace stanok::jobs
