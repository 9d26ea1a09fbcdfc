#include "channels/cycle/load_desk.h"

#include <algorithm>
#include <utility>

namespace stanok::channels {

void LoadDesk::begin(const ShortText& text, Job job) RT_SAFE {
  outcome_ = Outcome::pending;
  job_ = job;
  if (job == Job::line) return link_.tell(LineLoad{.load_in_use = program_, .line = text});
  link_.tell(ProgramLoad{.number = ++begun_, .load_in_use = program_, .program = text});
}

void LoadDesk::begin_search(const BlockSearch& search) RT_SAFE {
  outcome_ = Outcome::pending;
  job_ = Job::search;
  link_.tell(search);
}

void LoadDesk::take(const LoadDone& load) RT_SAFE {
  outcome_ = load.succeeded ? Outcome::succeeded : Outcome::failed;
  text_ = load.text;
  if (load.succeeded && job_ == Job::search) next_start_ = Start::in_the_middle;
  if (!load.succeeded || job_ != Job::program) return;
  next_start_ = Start::at_first_block;
  program_ = load.number;
  digest_ = load.digest;
  run_.apply(Change::loaded);
}

void LoadDesk::begin_run() RT_SAFE {
  start_ = std::exchange(next_start_, Start::at_first_block);
}

void LoadDesk::note_end() RT_SAFE {
  if (!has_run_before()) ended_[ended_count_++ % ended_max] = digest_;
}

bool LoadDesk::has_run_before() const RT_SAFE {
  const auto end = ended_.begin() + std::min(ended_count_, ended_max);
  return std::find(ended_.begin(), end, digest_) != end;
}

void LoadDesk::end() RT_SAFE {
  if (outcome_ == Outcome::pending) outcome_ = Outcome::failed;
  next_start_ = Start::at_first_block;
}

}  // namespace stanok::channels
