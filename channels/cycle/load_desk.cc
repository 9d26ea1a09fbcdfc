#include "channels/cycle/load_desk.h"

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
  if (!load.succeeded || job_ != Job::program) return;
  program_ = load.number;
  run_.apply(Change::loaded);
}

void LoadDesk::end() RT_SAFE {
  if (outcome_ == Outcome::pending) outcome_ = Outcome::failed;
}

}  // namespace stanok::channels
