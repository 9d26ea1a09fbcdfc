#include "lang/program/kept_files.h"

namespace stanok::lang {

Expected<std::shared_ptr<const SourceText>, Diagnostic> KeptFiles::read(
    std::string_view name, std::string_view from) const {
  if (program_ == nullptr) return files_.read(name, from);
  for (const auto& [key, file] : program_->file_by_name) {
    const auto& [naming_file, known_name] = key;
    if (known_name == name && program_->files[naming_file]->source.path() == from) {
      return program_->files[file]->source.shared_text();
    }
  }
  return files_.read(name, from);
}

}  // namespace stanok::lang
