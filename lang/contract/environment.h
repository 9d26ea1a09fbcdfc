// What the interpreter needs to know of its channel: axes, tables, files. channels implements it.
//
// The interpreter reads through this interface only; it holds no machine state of its own beyond
// the program's.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "lang/contract/command.h"
#include "lang/contract/dialect.h"
#include "lang/contract/tool_alignment.h"

namespace stanok::lang {

enum class ChannelKind { mill, lathe, grind, master };

struct AxisDescription {
  std::string word;  // how programs call it: "X", "B", "X2"
  bool rotary = false;
  double modulo_deg = 0.0;  // > 0: G90 takes the shortest way
  int geometry = -1;        // 0, 1, 2: the channel's X, Y, Z of planes and arcs; -1: none
  int spindle = 0;          // id of the spindle that becomes this axis with M902; 0: always an axis
};

// A G or M code to which the machine file gives a meaning.
struct UserCode {
  enum class Kind {
    macro,               // calls a program; the words of the block are its arguments
    output_before,       // MachineFunction before the motion of its block
    output_after,        // ... behind it
    output_with_motion,  // ... as the motion starts
    output_switched,     // a digital output, and what tells that it has done its work
  };
  char letter = 'G';
  int number = 0;  // in tenths
  Kind kind = Kind::macro;
  bool waits = false;  // output: the program goes on when the axes stand
  int output = -1;     // output_switched
  bool on = false;
  int feedback = -1;       // digital input that becomes what the output is; -1: none
  double timeout_s = 0.0;  // until then
  std::string program;     // macro: its file
  std::string function;    // macro: a function of the file, folded; empty: the file itself
};

// A letter that stands for a named address: E for dS.
struct AddressAlias {
  char letter = 'E';
  std::string address;
};

// How much a program may ask for; the machine file has the keys. What else is bounded: limits.h.
struct ProgramBounds {
  std::size_t bytes = 256UL << 20;      // of its text, with all files
  std::uint64_t steps = 1'000'000'000;  // of a run, see Interpreter::renew_steps
  std::uint64_t blocks = 0;             // of a dry run, which ends there; 0: any
};

// How G37 measures: the way up to `before_mm` before the place goes at rapid, from there up to
// `within_mm` behind it at the feed. What touches farther than that from the place is no tool.
struct ToolMeasuring {
  double feed_mm_per_min = 100.0;
  double before_mm = 5.0;
  double within_mm = 2.0;
};

// The fixed part of a channel, from the machine file.
struct ChannelDescription {
  int id = 1;
  std::string name;
  ChannelKind kind = ChannelKind::mill;
  TextRules rules;  // of texts that do not say otherwise
  AxisList<AxisDescription> axes;
  std::vector<int> spindles;                // ids; the first is the master spindle
  std::vector<int> spindles_with_position;  // those of them that can follow or lead an axis
  // What a T word does; nothing: as customary for the kind, that is true on lathe channels.
  std::optional<bool> tool_word_changes_tool;
  std::optional<bool> tool_word_has_edge;  // T0102: tool 1, edge 2
  bool tool_word_has_offset = false;       // T0102: tool 1, lengths of row 2
  std::vector<int> channels;               // ids of all channels of the machine
  std::vector<std::pair<int, int>>
      schemes;                 // (channel, scheme id) of all channels, for constant checks
  bool plain_corners = false;  // A, C and R of G1 say `,A`, `,C` and `,R` in Fanuc texts
  bool has_force_control = false;
  double arc_radius_tolerance_mm = 0.01;
  ToolMeasuring tool_measuring;
  double finest_resolution_mm = 0.0;  // of its linear axes; 0: not known
  std::vector<UserCode> user_codes;
  std::vector<AddressAlias> address_alias;
  ProgramBounds bounds;
};

struct Tool {
  int number = 0;
  std::array<double, 3> length_mm{};  // X, Y, Z, with the wear
  double radius_mm = 0.0;
  int orientation = 0;       // of a lathe tool's tip, 1 to 8; 0 and 9: the centre of its nose
  double overhang_mm = 0.0;  // along the radial axis
  std::array<double, 3> wear_mm{};  // of the lengths; there is none along Y
};

inline constexpr int reference_point_count = 4;  // 1: G28, 2 to 4: G30 P

// Common variables of the Fanuc dialect that are kept through power-off.
inline constexpr int kept_variable_first = 500;
inline constexpr int kept_variable_last = 999;
// Parts made and parts wanted, which are kept too.
inline constexpr int parts_variable_first = 3901;
inline constexpr int parts_variable_last = 3902;
// Of the Haas dialect; its #10500 to #10999 are #500 to #999.
inline constexpr int haas_variable_first = 10000;
inline constexpr int haas_variable_last = 10499;

// The place of a kept variable among all of them; -1: it is none.
[[nodiscard]] constexpr int kept_variable_place(int number) {
  constexpr int common = kept_variable_last - kept_variable_first + 1;
  constexpr int parts = parts_variable_last - parts_variable_first + 1;
  if (number >= kept_variable_first && number <= kept_variable_last)
    return number - kept_variable_first;
  if (number >= parts_variable_first && number <= parts_variable_last)
    return common + number - parts_variable_first;
  if (number >= haas_variable_first && number <= haas_variable_last)
    return common + parts + number - haas_variable_first;
  return -1;
}
inline constexpr int kept_variables = kept_variable_place(haas_variable_last) + 1;
[[nodiscard]] constexpr bool is_kept_variable(int number) {
  return kept_variable_place(number) >= 0;
}
// The number of the variable at a place.
[[nodiscard]] constexpr int kept_variable_at(int place) {
  for (const int first : {haas_variable_first, parts_variable_first, kept_variable_first}) {
    if (place >= kept_variable_place(first)) return first + place - kept_variable_place(first);
  }
  return kept_variable_first;
}

// How the machine's axes count: M = per_mm * (B + length of the tool) + zero, mm and deg. The sign
// of `per_mm` is that of the axis, its amount is 2 where the axis counts diameters.
struct MachineReading {
  AxisValues zero{};
  AxisValues per_mm{};

  MachineReading() { per_mm.fill(1.0); }

  [[nodiscard]] double in_machine(AxisIndex axis, double with_length_B) const {
    return per_mm[axis] * with_length_B + zero[axis];
  }
  [[nodiscard]] double in_base(AxisIndex axis, double machine) const {
    return (machine - zero[axis]) / per_mm[axis];
  }
  // A place in M is `counts` times what a program has in mm.
  [[nodiscard]] double counts(AxisIndex axis) const { return std::abs(per_mm[axis]); }
};

// The tables of the machine as the program sees them at this moment.
class Tables {
 public:
  virtual ~Tables() = default;
  // Offset vector of a work offset (1 = G54 ...), per axis of the channel; nothing if it does not
  // exist.
  [[nodiscard]] virtual std::optional<AxisValues> work_offset(int number) const = 0;
  // Rotation of a work offset in the XY plane, deg (G10 L2 R).
  [[nodiscard]] virtual double work_offset_rotation(int) const { return 0.0; }
  [[nodiscard]] virtual std::optional<Tool> tool(int number) const = 0;
  // Edge from 1; edge 1 is what tool() returns.
  [[nodiscard]] virtual std::optional<Tool> tool_edge(int number, int edge) const {
    return edge == 1 ? tool(number) : std::nullopt;
  }
  // The number of the newest write of tools and offsets that is read here.
  [[nodiscard]] virtual std::uint64_t version() const { return 0; }
  // A length with what has changed of its row since it was read, as far as that counts at once.
  [[nodiscard]] virtual ToolLength in_force(const ToolLength& length) const { return length; }
  // How the axes of the channel count in its active scheme, without tip transformation.
  [[nodiscard]] virtual MachineReading machine_reading() const = 0;
  // Axes of the channel that take part in its active scheme.
  [[nodiscard]] virtual AxisSet axes_of_scheme() const { return static_cast<AxisSet>(~0U); }
  // Rotary axes through which the active scheme leads the tool tip (G43.4).
  [[nodiscard]] virtual AxisSet leading_axes() const { return static_cast<AxisSet>(~0U); }
  // Where the rotary axes of the active scheme have to stand for a direction of the tool.
  [[nodiscard]] virtual Alignment alignment(const AlignmentWish&) const { return {}; }
  // X, Y and Z of the spindle as they lie in B with the axes at `position_B`.
  [[nodiscard]] virtual std::array<Direction, 3> spindle_axes(const AxisValues&) const {
    return {Direction{1.0, 0.0, 0.0}, Direction{0.0, 1.0, 0.0}, Direction{0.0, 0.0, 1.0}};
  }
  // Where a point of the rotary table, at `point_B` when the table stands at its angles, is with
  // the table at those of `position_B`; nothing: no table of the active scheme turns.
  [[nodiscard]] virtual std::optional<AxisValues> carried_by_table(const AxisValues&,
                                                                   const AxisValues&) const {
    return std::nullopt;
  }
  // Reference point 1 (G28) to reference_point_count (G30 P4) in M, per axis of the channel.
  [[nodiscard]] virtual AxisValues reference_point(int which) const = 0;
  // #500 to #999, #3901 and #3902 of the Fanuc dialect, kept through power-off; NaN: vacant.
  [[nodiscard]] virtual double common_variable(int number) const = 0;
  virtual void set_common_variable(int number, double value) = 0;
  // Of G28.1 and its like; survives power-off.
  virtual void store_reference_point(int which, const AxisValues& point_M) = 0;
};

// A program text as read once for a load; later changes on disk have no effect on a run.
struct SourceText {
  std::string name;  // as shown in diagnostics
  std::string path;  // where it was found
  std::string text;
};

// The error E8004: `name` has `bytes`, or makes a program of so many; `bytes_max` are allowed.
[[nodiscard]] Diagnostic too_large(std::string_view name, std::size_t bytes, std::size_t bytes_max);

// Finds and reads program files (docs/reference/language.md#files-and-numbered-programs).
class Files {
 public:
  virtual ~Files() = default;
  // `from` is the path of the text that names the file, empty for the operator. The error is E7xxx.
  // The text of an STL file says what is known of it (blank_file.h).
  [[nodiscard]] virtual Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const = 0;
};

}  // namespace stanok::lang
