#include "channels/cycle/load_desk.h"

namespace stanok::channels {

void LoadDesk::begin(const ShortText& text, Job job) RT_SAFE {
  outcome_ = Outcome::pending;
  job_ = job;
  Notice notice;
  notice.kind = job == Job::line ? NoticeKind::load_line : NoticeKind::load;
  notice.load = program_;
  if (job == Job::program) notice.number = ++begun_;
  notice.text = ReasonText(text.view());
  link_.tell(notice);
}

void LoadDesk::begin_search(Notice start, const ShortText& target) RT_SAFE {
  outcome_ = Outcome::pending;
  job_ = Job::search;
  start.kind = NoticeKind::search;
  start.text = ReasonText(target.view());
  link_.tell(start);
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
