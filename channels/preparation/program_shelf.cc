#include "channels/preparation/program_shelf.h"

#include <functional>
#include <string_view>
#include <utility>

#include "lang/program/program.h"

namespace stanok::channels {
namespace {

std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    if (d.severity != Severity::error) continue;
    const std::string place = d.place.line > 0 ? d.place.file + ":" + std::to_string(d.place.line) +
                                                     ":" + std::to_string(d.place.column) + ": "
                                               : std::string();
    return d.code + " " + place + d.message;
  }
  return "";
}

// With that of the subprograms, so that a change of any of them makes it another one.
std::uint64_t digest_of(const lang::Program& program) {
  std::uint64_t digest = 0;
  for (const auto& file : program.files)
    digest = 31 * digest + std::hash<std::string_view>{}(file->source.text());
  return digest;
}

LoadDone loaded(const std::string& name) {
  return {.succeeded = true, .text = ShortText(name)};
}

}  // namespace

ProgramShelf::ProgramShelf(const ChannelConfig& channel,
                           const lang::ChannelDescription& description, const lang::Files& files,
                           SharedVariables& shared, ReportBook& reports,
                           lang::Interruption is_unwanted)
    : config_(channel),
      description_(description),
      files_(files),
      shared_(shared),
      reports_(reports),
      is_unwanted_(std::move(is_unwanted)) {}

void ProgramShelf::use(std::int32_t number) {
  if (newest_.number != number || newest_.program == nullptr) return;
  program_ = std::move(newest_.program);
  name_ = std::move(newest_.name);
  newest_ = {};
}

LoadDone ProgramShelf::load(const std::string& name, std::int32_t number) {
  Diagnostics diagnostics;
  auto compiled = lang::compile(name, files_, &description_, diagnostics, is_unwanted_);
  if (compiled) {
    if (auto faults = declare_shared(**compiled); !faults.empty()) {
      compiled = Unexpected<Diagnostics>(std::move(faults));
    }
  }
  if (compiled) newest_ = {number, *compiled, name};
  LoadDone end = done(name, compiled, std::move(diagnostics));
  end.number = number;
  if (compiled) end.digest = digest_of(**compiled);
  return end;
}

LoadDone ProgramShelf::load_line(const std::string& line) {
  Diagnostics diagnostics;
  const auto compiled =
      lang::compile_line(line, program_.get(), files_, &description_, diagnostics, is_unwanted_);
  if (compiled) line_ = *compiled;
  return done(line, compiled, std::move(diagnostics));
}

LoadDone ProgramShelf::search_failed(const Diagnostic& fault) {
  return done("", Unexpected<Diagnostics>({fault}), {});
}

LoadDone ProgramShelf::search_found() const {
  return loaded(name_);
}

LoadDone ProgramShelf::done(const std::string& name, const Compiled& compiled,
                            Diagnostics diagnostics) {
  LoadDone end = loaded(name);
  if (!compiled) {
    diagnostics.insert(diagnostics.end(), compiled.error().begin(), compiled.error().end());
    end.succeeded = false;
    end.text = ShortText(first_error(compiled.error()));
  }
  reports_.add_diagnostics(config_.id, diagnostics);
  return end;
}

Diagnostics ProgramShelf::declare_shared(const lang::Program& program) {
  Diagnostics faults;
  for (const lang::SharedVariable& variable : lang::shared_variables(program)) {
    if (auto fault = shared_.declare(variable)) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace stanok::channels
