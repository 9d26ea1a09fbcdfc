// ProgramShelf: the programs of a channel, compiled: the one that is loaded, a newer one that the
// cycle has not used yet, and the line that an operator typed last.
//
// Thread: that of the preparation. Owner: the channel's preparation. Invariant: a load that fails
// leaves everything as it was.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "channels/messages/item.h"
#include "channels/preparation/preparation_parts.h"
#include "channels/stores/shared_variables.h"
#include "lang/program/compile.h"

namespace stanok::channels {

class ProgramShelf {
 public:
  // `is_unwanted` ends what is being compiled. All other arguments outlive the shelf.
  ProgramShelf(const ChannelConfig& channel, const lang::ChannelDescription& description,
               const lang::Files& files, SharedVariables& shared, ReportBook& reports,
               lang::Interruption is_unwanted);

  // Compiles program `name` or a line, and says how it ended.
  [[nodiscard]] LoadDone load(const std::string& name, std::int32_t number);
  [[nodiscard]] LoadDone load_line(const std::string& line);
  // The same of a block search: its fault, or the place was found.
  [[nodiscard]] LoadDone search_failed(const Diagnostic& fault);
  [[nodiscard]] LoadDone search_found() const;

  // The cycle uses the load with this number, or has never heard of it: a reset comes between. The
  // program that it has then is the one before.
  void use(std::int32_t number);

  [[nodiscard]] const std::shared_ptr<const lang::Program>& program() const { return program_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::shared_ptr<const lang::Program>& line() const { return line_; }

 private:
  using Compiled = Expected<std::shared_ptr<const lang::Program>, Diagnostics>;
  struct Load {
    std::int32_t number = 0;
    std::shared_ptr<const lang::Program> program;
    std::string name;
  };

  [[nodiscard]] LoadDone done(const std::string& name, const Compiled& compiled,
                              Diagnostics diagnostics);
  [[nodiscard]] Diagnostics declare_shared(const lang::Program& program);

  const ChannelConfig& config_;
  const lang::ChannelDescription& description_;
  const lang::Files& files_;
  SharedVariables& shared_;
  ReportBook& reports_;
  lang::Interruption is_unwanted_;
  Load newest_;
  std::shared_ptr<const lang::Program> program_;
  std::string name_;
  std::shared_ptr<const lang::Program> line_;
};

}  // namespace stanok::channels
