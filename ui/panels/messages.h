/// Errors and warnings of files, studies and exports, collected as they come.
#pragma once

#include "engine/base/diagnostic.h"

#include <chrono>
#include <deque>
#include <string>

namespace hanei {

class Messages {
public:
    struct Entry {
        std::chrono::system_clock::time_point when;
        std::string source;  ///< "File", "Study", "Export", "Autosave", "Preferences"
        Diagnostic finding;
        int count = 1;  ///< how often it came in a row
    };

    /// The same again and again is one entry that counts. Beyond a thousand the oldest go.
    void note(const std::string& source, const Diagnostic& finding);
    void note(const std::string& source, const Diagnostics& findings);
    void clear();

    const std::deque<Entry>& entries() const { return entries_; }  ///< the oldest first

    std::size_t unread_errors() const { return unread_errors_; }
    void mark_read() { unread_errors_ = 0; }

private:
    std::deque<Entry> entries_;
    std::size_t unread_errors_ = 0;
};

}  // namespace hanei
