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

void LoadDesk::take(const Item& load_done) RT_SAFE {
  outcome_ = load_done.flag ? Outcome::succeeded : Outcome::failed;
  text_ = load_done.text;
  if (!load_done.flag || job_ != Job::program) return;
  program_ = static_cast<std::int32_t>(load_done.number);
  run_.apply(Change::loaded);
}

void LoadDesk::end() RT_SAFE {
  if (outcome_ == Outcome::pending) outcome_ = Outcome::failed;
}

}  // namespace stanok::channels
