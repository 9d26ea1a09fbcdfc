// KeptFiles: the texts of a loaded program as they were read for it, everything else from disk.
#pragma once

#include "lang/contract/environment.h"
#include "lang/program/program.h"

namespace stanok::lang {

class KeptFiles final : public Files {
 public:
  // Both outlive it; `program` nullptr: nothing is kept.
  KeptFiles(const Program* program, const Files& files) : program_(program), files_(files) {}

  [[nodiscard]] Expected<std::shared_ptr<const SourceText>, Diagnostic> read(
      std::string_view name, std::string_view from) const override;

 private:
  const Program* program_;
  const Files& files_;
};

}  // namespace stanok::lang
