// FaultList gathers what is wrong in a set of TOML files; readers go on after a fault.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/text/config_error.h"
#include "config/text/source_file.h"

namespace stanok::config {

class FaultList {
 public:
  // More than anybody reads; a text of a megabyte can have 700,000.
  static constexpr std::size_t kept_max = 1000;

  // Files are read from disk, or are those that are given.
  FaultList() = default;
  explicit FaultList(std::vector<SourceFile> given)
      : given_(std::move(given)), reads_given_(true) {}

  [[nodiscard]] bool is_file(const std::filesystem::path& file) const;
  // The text of a file that is given; nothing when none is, or the file is not among them.
  [[nodiscard]] const std::string* given(const std::filesystem::path& file) const;
  [[nodiscard]] bool reads_given() const { return reads_given_; }

  void note_source(SourceFile source) { sources_.push_back(std::move(source)); }
  [[nodiscard]] std::vector<SourceFile>& sources() { return sources_; }

  // A fault at a place of a parsed file: a node (`node.source()`) or a key (`key.source()`).
  void add(const toml::source_region& place, std::string text);
  // A fault of a file as a whole.
  void add(const std::filesystem::path& file, std::string text);

  // How many were found, kept or not.
  [[nodiscard]] std::size_t size() const { return found_; }
  // Throws ConfigError with the faults that were found first (kept_max, and one that says that
  // there are more), file by file in the order of their places, each once; returns when there are
  // none.
  void throw_if_any();

 private:
  void keep(ConfigFault fault);

  std::vector<SourceFile> given_;
  bool reads_given_ = false;
  std::vector<SourceFile> sources_;
  std::vector<ConfigFault> faults_;
  std::size_t found_ = 0;
};

// The text of a file; nothing, and a fault, when it cannot be read.
[[nodiscard]] std::optional<std::string> read_text(const std::filesystem::path& file,
                                                   FaultList& faults);

// The tree of a TOML text; nothing, and a fault, when it is no TOML. Nodes remember `file`.
[[nodiscard]] std::optional<toml::table> parse_text(std::string_view text,
                                                    const std::filesystem::path& file,
                                                    FaultList& faults);

// Both.
[[nodiscard]] std::optional<toml::table> parse_file(const std::filesystem::path& file,
                                                    FaultList& faults);

}  // namespace stanok::config
