// BlankedFiles: program texts in which what is at fault is blank, so that the rest can be looked
// at: words that nothing uses, and whole lines with any other error.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "lang/contract/environment.h"

namespace stanok::jobs {

class BlankedFiles : public lang::Files {
 public:
  // `files` outlives this.
  explicit BlankedFiles(const lang::Files& files) : files_(files) {}

  // False: none of them is new.
  [[nodiscard]] bool blank(const Diagnostics& errors);
  [[nodiscard]] bool is_blank(const Place& place) const;
  // Whether a line is blank that may come before this place.
  [[nodiscard]] bool may_miss_before(const Place& place) const;

  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;

 private:
  const lang::Files& files_;
  // By name of file.
  std::map<std::string, std::set<int>> lines_;
  struct Word {
    int line = 0;
    int column = 0;
    int end_column = 0;
    auto operator<=>(const Word&) const = default;
  };
  [[nodiscard]] static bool stands_in(const std::set<Word>& words, int line, int column);

  std::map<std::string, std::set<Word>> words_;
};

}  // namespace stanok::jobs
