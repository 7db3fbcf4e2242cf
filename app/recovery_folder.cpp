#include "app/recovery_folder.h"

#include "engine/base/whole_file.h"
#include "engine/project/json_fields.h"
#include "engine/project/json_text.h"
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <atomic>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace hanei {
namespace {

namespace fs = std::filesystem;
using SystemClock = std::chrono::system_clock;

fs::path lock_of(fs::path work) { return work.replace_extension(".lock"); }

/// The open lock file, or -1 when somebody else holds it.
int take_lock(const fs::path& file) {
    const int lock = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock < 0) return -1;
    if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
    ::close(lock);
    return -1;
}

std::string head_of(const fs::path& original) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(SystemClock::now().time_since_epoch());
    JsonValue head = json_object();
    head.add("hanei_recovery", json_number(1));
    head.add("original", json_text(original.string()));
    head.add("kept_at_s", json_number(static_cast<double>(seconds.count())));
    head.add("process", json_number(::getpid()));
    return one_line(head) + '\n';
}

/// A head that cannot be read leaves its fields as they are: the work is offered all the same.
void read_head(std::string_view line, LostWork& work) {
    JsonReading reading{work.file.string(), {}};
    const std::optional<JsonValue> root = parse_json(line, reading.file, reading.findings);
    if (!root) return;
    Fields fields(reading, *root, "");
    std::string original;
    if (fields.optional("original", original)) work.original = original;
    double seconds = 0.0;
    if (fields.optional("kept_at_s", seconds) && seconds >= 0.0 && seconds < 1e11)
        work.kept_at = SystemClock::time_point(std::chrono::seconds(static_cast<long long>(seconds)));
    fields.optional("process", work.process);
}

/// What a window left that ended while it wrote.
void remove_torn(const fs::path& folder) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        const std::size_t torn = name.find(".work.part");
        const bool is_lock = entry.path().extension() == ".lock";
        if (torn == std::string::npos && !is_lock) continue;
        const fs::path lock_file = is_lock ? entry.path() : folder / (name.substr(0, torn) + ".lock");
        fs::path work = lock_file;
        if (is_lock && fs::exists(work.replace_extension(".work"), none)) continue;
        const int lock = take_lock(lock_file);
        if (lock < 0) continue;
        fs::remove(entry.path(), none);
        if (!fs::exists(work, none)) fs::remove(lock_file, none);
        ::close(lock);
    }
}

}  // namespace

RecoveryFolder::RecoveryFolder(fs::path folder) : folder_(std::move(folder)) {
    static std::atomic<int> windows = 0;  // of this program
    name_ = fmt::format("{}-{}-{}", SystemClock::now().time_since_epoch().count(), ::getpid(), ++windows);
}

RecoveryFolder::~RecoveryFolder() {
    std::error_code none;
    if (own_lock_ >= 0) {
        if (!fs::exists(folder_ / (name_ + ".work"), none)) fs::remove(folder_ / (name_ + ".lock"), none);
        ::close(own_lock_);
    }
    for (const auto& [work, lock] : claimed_) ::close(lock);
}

std::optional<Diagnostic> RecoveryFolder::keep(const Scene& scene, const Settings& settings, const fs::path& original) {
    const fs::path file = folder_ / (name_ + ".work");
    std::error_code failure;
    if (own_lock_ < 0) {
        if (const auto reason = make_folder(folder_)) return about_file(Severity::error, file.string(), 0, {}, *reason);
        fs::permissions(folder_, fs::perms::owner_all, failure);  // work is nobody else's business
        own_lock_ = take_lock(lock_of(file));
    }
    const fs::path whole = original.empty() ? original : fs::absolute(original, failure);
    return write_text_file(file, head_of(whole) + project_text({scene, settings}));
}

void RecoveryFolder::forget() {
    std::error_code none;
    fs::remove(folder_ / (name_ + ".work"), none);
}

std::vector<LostWork> RecoveryFolder::lost() {
    const std::scoped_lock guard(guard_);
    std::vector<LostWork> lost;
    std::error_code none;
    remove_torn(folder_);
    for (const auto& entry : fs::directory_iterator(folder_, none)) {
        LostWork work{entry.path(), {}, {}, 0};
        if (work.file.extension() != ".work" || work.file.stem() == name_) continue;
        if (claimed_.count(work.file) == 0) {
            const int lock = take_lock(lock_of(work.file));
            if (lock < 0) continue;
            claimed_[work.file] = lock;
        }
        Diagnostics findings;
        const std::string text = read_text_file(work.file, findings).value_or("");
        read_head(std::string_view(text).substr(0, text.find('\n')), work);
        lost.push_back(std::move(work));
    }
    std::sort(lost.begin(), lost.end(), [](const LostWork& a, const LostWork& b) { return a.kept_at > b.kept_at; });
    return lost;
}

Opened<ProjectContent> RecoveryFolder::open(const LostWork& work) const {
    Opened<ProjectContent> opened;
    const std::optional<std::string> text = read_text_file(work.file, opened.findings);
    if (!text) return opened;
    const std::size_t head = std::min(text->find('\n'), text->size());
    ProjectRead read = read_project_text(std::string_view(*text).substr(head), work.original);
    opened.findings = std::move(read.findings);
    if (read.project) opened.content = ProjectContent{std::move(read.project->scene), read.project->settings};
    return opened;
}

void RecoveryFolder::discard(const LostWork& work) {
    const std::scoped_lock guard(guard_);
    const auto found = claimed_.find(work.file);
    if (found == claimed_.end()) return;  // not ours to take away
    std::error_code none;
    fs::remove(work.file, none);
    fs::remove(lock_of(work.file), none);
    ::close(found->second);
    claimed_.erase(found);
}

RecoveryDoor recovery_door(const fs::path& folder) {
    const auto kept = std::make_shared<RecoveryFolder>(folder);
    RecoveryDoor door;
    door.keep = [kept](const Scene& scene, const Settings& settings, const fs::path& original) {
        return kept->keep(scene, settings, original);
    };
    door.forget = [kept] { kept->forget(); };
    door.lost = [kept] { return kept->lost(); };
    door.open = [kept](const LostWork& work) { return kept->open(work); };
    door.discard = [kept](const LostWork& work) { kept->discard(work); };
    return door;
}

}  // namespace hanei
