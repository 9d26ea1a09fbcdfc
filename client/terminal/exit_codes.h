// Exit codes of every command (docs/reference/command-line.md, "Exit codes").
//
// 6 and 7 follow from the code of a diagnostic: exit_code_of in
// client/terminal/diagnostic_output.h.
#pragma once

namespace stanok::client {

inline constexpr int exit_failed = 1;
inline constexpr int exit_usage = 2;
inline constexpr int exit_no_connection = 3;
inline constexpr int exit_until_reached = 4;
inline constexpr int exit_log_with_losses = 8;
inline constexpr int exit_log_was_cut = 9;
inline constexpr int exit_interrupted = 130;

}  // namespace stanok::client
