// OverlaidFiles: program files of which one has a text that is not saved yet.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lang/contract/environment.h"

namespace stanok::runtime {

class OverlaidFiles final : public lang::Files {
 public:
  // `files` outlives it; without a text all is as it is there. A program of that name need not be
  // there.
  OverlaidFiles(const lang::Files& files, std::string name, std::optional<std::string> text)
      : files_(files), name_(std::move(name)), text_(std::move(text)) {}

  [[nodiscard]] Expected<std::shared_ptr<const lang::SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override {
    auto found = files_.read(name, from);
    if (!text_ || name != name_) return found;
    auto source = std::make_shared<lang::SourceText>();
    source->name = name_;
    source->path = found ? (*found)->path : name_;
    source->text = *text_;
    return std::shared_ptr<const lang::SourceText>(std::move(source));
  }

 private:
  const lang::Files& files_;
  std::string name_;
  std::optional<std::string> text_;
};

}  // namespace stanok::runtime
