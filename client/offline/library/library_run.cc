#include "client/offline/library/library_run.h"

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "client/offline/library/digest.h"
#include "client/offline/library/result_cache.h"
#include "client/offline/library/whole_file.h"
#include "client/offline/library/work_pool.h"
#include "client/terminal/exit_codes.h"
#include "client/terminal/interrupts.h"
#include "client/terminal/output.h"
#include "client/terminal/progress_line.h"

namespace stanok::client {
namespace {

constexpr int jobs_max = 1024;

// Where a result came from: the first byte of what a piece gives.
constexpr char made = 'm';
constexpr char made_and_not_kept = 'n';
constexpr char kept_before = 'k';

class LibraryRun {
 public:
  LibraryRun(const Candidates& candidates, const LibraryOptions& options, const LibraryWork& work,
             const LibraryOutput& output)
      : programs_(candidates.programs), options_(options), work_(work), output_(output) {
    if (!options.cache.empty()) cache_.emplace(options.cache, work.context());
  }

  // False: interrupted.
  bool run() {
    const int jobs =
        options_.jobs > 0 ? options_.jobs : static_cast<int>(std::thread::hardware_concurrency());
    const bool is_whole = is_done_here(jobs) ? run_here() : run_in_processes(jobs);
    progress_.clear();
    tell_of_cache();
    return is_whole;
  }

 private:
  [[nodiscard]] bool is_done_here(int jobs) const {
    return !options_.is_isolated && (jobs == 1 || programs_.size() < 2);
  }

  bool run_here() {
    for (std::size_t k = 0; k < programs_.size(); ++k) {
      show(k);
      take(k, {piece(k), ""});
    }
    return true;
  }

  bool run_in_processes(int jobs) {
    catch_interrupts();
    const PoolCalls calls{
        .work = [this](std::size_t index) { return piece(index); },
        .take = [this](std::size_t index, PieceResult result) { take(index, std::move(result)); },
        .progress = [this](std::size_t done) { show(done); },
        .gives_up = [] { return is_interrupted(); }};
    return do_in_processes(programs_.size(), jobs, calls);
  }

  // The result of a program, with where it came from before it.
  std::string piece(std::size_t index) const {
    const Candidate& program = programs_[index];
    if (!cache_) {
      runtime::TextBook book;
      return made + work_.result(program, book);
    }
    if (const auto kept = cache_->find(program.path, *work_.files(program)))
      return kept_before + *kept;
    runtime::TextBook book;
    const std::string result = work_.result(program, book);
    const bool is_kept = cache_->keep(program.path, book.take(), result);
    return (is_kept ? made : made_and_not_kept) + result;
  }

  void take(std::size_t index, PieceResult piece) {
    progress_.clear();
    const char origin = piece.bytes.empty() ? made : piece.bytes.front();
    if (origin == kept_before) ++from_cache_;
    if (origin == made_and_not_kept) ++not_kept_;
    output_.take(programs_[index], piece.bytes.empty() ? piece.bytes : piece.bytes.substr(1),
                 piece.death);
  }

  void show(std::size_t done) {
    if (programs_.size() < 2) return;
    const std::size_t at = std::min(done, programs_.size() - 1);
    progress_.show(progress_bar(done, programs_.size(), programs_[at].path, bar_columns));
  }

  void tell_of_cache() const {
    if (!cache_) return;
    write_message("cache: " + std::to_string(from_cache_) + " of " +
                  std::to_string(programs_.size()) + " results\n");
    if (not_kept_ > 0) {
      write_message("warning: " + options_.cache +
                    " cannot be written; results are not kept. Check its permissions and the space "
                    "of the disk\n");
    }
  }

  const std::vector<Candidate>& programs_;
  const LibraryOptions& options_;
  const LibraryWork& work_;
  const LibraryOutput& output_;
  std::optional<ResultCache> cache_;
  ProgressLine progress_;
  std::size_t from_cache_ = 0;
  std::size_t not_kept_ = 0;
};

std::string digest_of_this_program() {
  return digest_of(bytes_in("/proc/self/exe"));
}

}  // namespace

void add_library_options(CLI::App& command, LibraryOptions& options) {
  command
      .add_option(
          "--jobs", options.jobs,
          "number of programs at a time, each in its own process (1); 0: one for each processor")
      ->check(CLI::Range(0, jobs_max))
      ->type_name("N");
  command
      .add_option("--cache", options.cache,
                  "keep results in this folder, and reuse them as long as program, machine and "
                  "stanok are the same")
      ->type_name("FOLDER");
}

int run_library(const Candidates& candidates, const LibraryOptions& options,
                const LibraryWork& work, const LibraryOutput& output) {
  return LibraryRun(candidates, options, work, output).run() ? output.finish() : exit_interrupted;
}

std::string context_of(const config::MachineFile& machine, const std::vector<std::string>& asked) {
  Digest digest;
  digest.add(digest_of_this_program());
  for (const config::SourceFile& source : machine.sources)
    digest.add(source.path.string()).add(source.text);
  for (const std::string& text : asked) digest.add(text);
  return digest.text();
}

}  // namespace stanok::client
