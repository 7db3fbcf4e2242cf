/// A zip container in memory: what it holds, and its entries one at a time. Nothing is written to disk.
#pragma once

#include "engine/base/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct zip;

namespace hanei {

/// Names are compared letter by letter on every machine. A name that differs from an entry's in the case
/// of its letters alone finds that entry, with a warning, when there is no other.
///
/// Holds     a view of the bytes, which must outlive it.
class GldfContainer {
public:
    /// `name` is what findings call the file. Without a directory of entries there is an error, and none is held.
    GldfContainer(std::string_view bytes, std::string_view name, Diagnostics& findings);

    bool open() const { return archive_ != nullptr; }
    /// In the order of the directory, slashes between folders. Folders and names that lead out of the
    /// container are left out; of several entries of one name the last is held.
    const std::vector<std::string>& entries() const { return names_; }

    /// The name of the entry that is meant by `name`; empty when there is none.
    std::optional<std::string> find(const std::string& name, const std::string& field, Diagnostics& findings) const;

    /// Inflates at most `most_bytes`, whatever size the directory declares, and in all of the container
    /// at most 256 MB: a small container cannot fill the memory.
    /// Returns   empty, with an error in the field `entry`, for one that is encrypted, damaged or too large.
    std::optional<std::string> read(const std::string& entry, std::size_t most_bytes, Diagnostics& findings);

private:
    void list_entries(Diagnostics& findings);
    Diagnostic finding(Severity severity, const std::string& field, std::string message) const;

    struct Close {
        void operator()(zip* archive) const;
    };
    std::string name_;
    std::unique_ptr<zip, Close> archive_;
    std::vector<std::string> names_;
    std::map<std::string, std::uint64_t, std::less<>> places_;
    std::multimap<std::string, std::string> lower_case_;
    std::size_t inflated_ = 0;
};

/// True when a name stays inside the folder it is read from: relative, without "..", drive letter or
/// unprintable bytes. Backslashes count as slashes.
bool stays_inside(std::string_view name);

bool looks_like_zip(std::string_view bytes);

}  // namespace hanei
