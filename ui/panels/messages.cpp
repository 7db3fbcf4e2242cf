#include "ui/panels/messages.h"

namespace hanei {

void Messages::note(const std::string& source, const Diagnostic& finding) {
    constexpr std::size_t most_entries = 1000;
    if (finding.severity == Severity::error) ++unread_errors_;
    const auto now = std::chrono::system_clock::now();
    if (!entries_.empty() && entries_.back().source == source && entries_.back().finding == finding) {
        entries_.back().when = now;
        ++entries_.back().count;
        return;
    }
    entries_.push_back({now, source, finding});
    if (entries_.size() > most_entries) entries_.pop_front();
}

void Messages::note(const std::string& source, const Diagnostics& findings) {
    for (const Diagnostic& finding : findings) note(source, finding);
}

void Messages::clear() {
    entries_.clear();
    unread_errors_ = 0;
}

}  // namespace hanei
