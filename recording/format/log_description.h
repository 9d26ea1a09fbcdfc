// What a log says about itself: machine, axes, cycle, version, and the fingerprints of the types.
#pragma once

#include <cstdint>
#include <stanok_messages/log_meta_t.hpp>
#include <stanok_messages/log_types_t.hpp>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "recording/format/encode.h"

namespace stanok::recording {

// 1: every message stands in the file; 2: those of a machine at rest may be left out (log_rest_t).
inline constexpr int log_format = 2;

struct AxisDescription {
  std::string name;  // machine-wide, "X2"
  std::string word;  // as programs call it, "X"
  bool rotary = false;
};

struct ChannelDescription {
  int id = 0;
  std::vector<AxisDescription> axes;
};

struct LogDescription {
  std::string machine;
  std::string version;            // of the runtime
  std::string build;              // compiler and flags
  std::string libm;               // C library, see this_libm()
  std::uint64_t config_hash = 0;  // FNV-1a of the machine file
  int format = log_format;
  int cycle_us = 1000;
  std::int64_t utime_start = 0;  // us of cycle 0: 0 on the virtual clock, else wall clock at start
  std::vector<ChannelDescription> channels;
};

// Machine, cycle and axes from the configuration; version and build from the caller.
[[nodiscard]] LogDescription describe(const channels::MachineConfig& config, std::string version,
                                      std::string build);

[[nodiscard]] log_meta_t to_log_meta(const LogDescription& description, const Stamp& stamp);
// utime_start is not in the message and comes back as 0.
// All types that there are; log_meta_t has places for the first of them.
[[nodiscard]] log_types_t to_log_types(const Stamp& stamp);
[[nodiscard]] LogDescription from_log_meta(const log_meta_t& message);

// "glibc 2.36": bit identity of two runs is promised for an equal one.
[[nodiscard]] std::string this_libm();

// FNV-1a, 64 bit: names a text in logs; not a protection against intent.
[[nodiscard]] std::uint64_t text_hash(std::string_view text);

}  // namespace stanok::recording
