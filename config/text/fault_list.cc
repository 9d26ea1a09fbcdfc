// FaultList, and the reading of a TOML file into a tree.
#include "config/text/fault_list.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <istream>
#include <memory>
#include <string_view>
#include <tuple>

#include "base/place.h"
#include "base/system_error.h"
#include "base/text_bounds.h"

namespace stanok::config {
namespace {

// No more of a file than shows that it is too long.
std::string read_beginning(std::istream& stream) {
  constexpr std::size_t piece = 64UL << 10;
  std::string text;
  while (stream && text.size() <= toml_bounds.bytes) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    stream.read(text.data() + before, static_cast<std::streamsize>(piece));
    text.resize(before + checked_size(stream.gcount()));
  }
  return text;
}

}  // namespace

void FaultList::add(const toml::source_region& place, std::string text) {
  keep({.file = place.path ? *place.path : std::string(),
        .line = place.begin.line,
        .column = place.begin.column,
        .text = std::move(text)});
}

void FaultList::add(const std::filesystem::path& file, std::string text) {
  keep({.file = file.string(), .text = std::move(text)});
}

void FaultList::keep(ConfigFault fault) {
  ++found_;
  if (faults_.size() < kept_max) faults_.push_back(std::move(fault));
}

void FaultList::throw_if_any() {
  if (faults_.empty()) return;
  std::vector<std::string> files;  // in the order in which faults were found in them
  for (const ConfigFault& fault : faults_) {
    if (std::ranges::find(files, fault.file) == files.end()) files.push_back(fault.file);
  }
  const auto place = [&](const ConfigFault& fault) {
    return std::tuple(std::ranges::find(files, fault.file) - files.begin(), fault.line,
                      fault.column);
  };
  std::ranges::stable_sort(faults_, {}, place);
  const auto repeated = std::ranges::unique(faults_, {}, to_string);  // a file used twice
  faults_.erase(repeated.begin(), repeated.end());
  if (found_ > kept_max) {
    faults_.push_back({.file = faults_.back().file,
                       .text = "there are more faults than the " + std::to_string(kept_max) +
                               " that are shown; correct these first"});
  }
  throw ConfigError(std::move(faults_));
}

bool FaultList::is_file(const std::filesystem::path& file) const {
  return reads_given_ ? given(file) != nullptr : std::filesystem::is_regular_file(file);
}

const std::string* FaultList::given(const std::filesystem::path& file) const {
  for (const SourceFile& source : given_) {
    if (source.path == file) return &source.text;
  }
  return nullptr;
}

std::optional<std::string> read_text(const std::filesystem::path& file, FaultList& faults) {
  if (faults.reads_given()) {
    const std::string* text = faults.given(file);
    if (text != nullptr) return *text;
    faults.add(file, "the file is not among those that were recorded");
    return std::nullopt;
  }
  if (std::filesystem::is_directory(file)) {
    faults.add(file, "cannot read the file: it is a directory; name the file in it");
    return std::nullopt;
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text = read_beginning(stream);
  if (!stream.is_open() || stream.bad()) {
    faults.add(file, "cannot read the file: " + system_error_text(errno) + "; check the path");
    return std::nullopt;
  }
  faults.note_source({file, text});
  return text;
}

std::optional<toml::table> parse_text(std::string_view text, const std::filesystem::path& file,
                                      FaultList& faults) {
  if (const auto excess = toml_excess(text)) {
    toml::source_region place;
    place.path = std::make_shared<const std::string>(file.native());
    place.begin = {excess->line, excess->column};
    faults.add(place, "cannot be read: " + excess->text + "; the files of a machine have less");
    return std::nullopt;
  }
  try {
    return toml::parse(text, std::string_view(file.native()));
  } catch (const toml::parse_error& error) {
    faults.add(error.source(), "not valid TOML: " + std::string(error.description()));
    return std::nullopt;
  }
}

std::optional<toml::table> parse_file(const std::filesystem::path& file, FaultList& faults) {
  const auto text = read_text(file, faults);
  return text ? parse_text(*text, file, faults) : std::nullopt;
}

}  // namespace stanok::config
