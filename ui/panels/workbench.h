/// The whole desktop but the platform: fed by ImGui's input, drawn by ImGui, painted by a ViewPainter.
#pragma once

#include "engine/edit/excerpt.h"
#include "ui/panels/autosave.h"
#include "ui/panels/background_work.h"
#include "ui/panels/command_search.h"
#include "ui/panels/context_menu.h"
#include "ui/panels/dialogs.h"
#include "ui/panels/document.h"
#include "ui/panels/exact_panel.h"
#include "ui/panels/export_dialog.h"
#include "ui/panels/file_browser.h"
#include "ui/panels/file_stamp.h"
#include "ui/panels/form.h"
#include "ui/panels/frame_recording.h"
#include "ui/panels/furnishing.h"
#include "ui/panels/history_list.h"
#include "ui/panels/light_panel.h"
#include "ui/panels/live_study.h"
#include "ui/panels/messages_panel.h"
#include "ui/panels/model_import.h"
#include "ui/panels/object_tree.h"
#include "ui/panels/photometry_panel.h"
#include "ui/panels/preferences.h"
#include "ui/panels/preferences_dialog.h"
#include "ui/panels/preferences_keeper.h"
#include "ui/panels/readings.h"
#include "ui/panels/recent_menu.h"
#include "ui/panels/recovery_dialog.h"
#include "ui/panels/selection.h"
#include "ui/panels/several_panel.h"
#include "ui/panels/snap_popup.h"
#include "ui/panels/start_layout_dialog.h"
#include "ui/panels/start_page.h"
#include "ui/panels/viewport.h"

#include <deque>

namespace hanei {

struct WindowLayout;

struct Checks;

/// Needs     a present ImGui context with style::apply() called; one thread. Pictures are exported
///           by after_frame(), which needs an OpenGL context.
class Workbench {
public:
    struct Options {
        bool repeatable = false;  ///< show nothing that differs from run to run (measured times)
        double patience = 60.0;   ///< s a frame waits for a file, which then seems to take no time
    };

    /// `wake` is called from another thread when a frame is due.
    Workbench(ProjectContent content, std::filesystem::path file, ProjectDoor door, std::function<void()> wake,
              Options how);

    void draw(const ViewPainter& paint);  ///< between ImGui::NewFrame and ImGui::Render
    void after_frame();                   ///< after the frame was painted: writes pictures that were asked for

    /// The start page, unless the preferences leave it out or lost work is asked about.
    void offer_start();

    void drop(const std::vector<std::filesystem::path>& files);  ///< from outside, where the pointer is

    void carry_out(CommandId id);
    bool can(CommandId id) const;
    bool is_on(CommandId id) const;  ///< of a command that switches something: it is switched on
    void ask_to_quit();              ///< as the window's close button does
    bool wants_to_quit() const { return quits_; }

    void choose(ObjectId id) { selection_.choose(id); }
    ObjectId chosen() const { return selection_.primary(); }
    const Selection& selection() const { return selection_; }

    const Document& document() const { return document_; }
    const LiveStudy& study() const { return study_; }
    const Viewport& viewport() const { return viewport_; }
    const Furnishing& furnishing() const { return furnishing_; }
    const WidgetRegistry& widgets() const { return widgets_; }
    const ExactPanel& exact() const { return exact_; }
    const Dialogs& dialogs() const { return dialogs_; }
    const FileBrowser& browser() const { return browser_; }
    const ModelImport& model_import() const { return model_import_; }
    const PhotometryPanel& photometry() const { return photometry_; }
    const Readings& readings() const { return readings_; }
    const Preferences& preferences() const { return preferences_; }
    const Messages& messages() const { return messages_; }
    const RecoveryDialog& recovery() const { return recovery_; }
    const Checks& checks() const { return *checks_; }
    bool is_busy() const;                                       ///< something goes on whose progress is shown
    bool reads_or_writes() const { return file_work_.busy(); }  ///< a file, beside the frames
    const StartPage& start_page() const { return start_page_; }
    const std::string& message() const { return message_; }
    bool is_snapping() const { return snap_.on; }
    long frames() const { return frames_; }
    std::string title() const;  ///< for the window's frame

private:
    struct Menu;
    static const Menu& menu_of(CommandId id);
    bool can_file(CommandId id) const;
    bool can_edit(CommandId id) const;
    bool can_add(CommandId id) const;
    bool can_room(CommandId id) const;
    bool can_arrange(CommandId id) const;
    bool can_light(CommandId id) const;
    bool can_view(CommandId id) const;
    bool can_look(CommandId id) const;
    bool can_results(CommandId id) const;
    bool can_help(CommandId id) const;
    void do_file(CommandId id);
    void do_edit(CommandId id);
    void do_add(CommandId id);
    void do_room(CommandId id);
    void do_arrange(CommandId id);
    void do_light(CommandId id);
    void do_view(CommandId id);
    void do_look(CommandId id);
    void do_results(CommandId id);
    void do_help(CommandId id);

    void read_keys();
    void follow_study();
    void follow_scale();
    void fit_scale();
    void take_scale_wishes();
    void follow_readings();
    void readings_tabs();
    void pin_at_double_click();
    bool is_flipped() const;  ///< the key for it is held
    void keep_state(bool as_a);
    void compare_tab();
    void profile_tab();
    void settle();
    void propose(Scene scene, std::string step);
    void add(Added added, const char* step);
    void add(AddedSeveral added, std::string step);
    void choose(const ObjectIds& ids);
    void nudge(const Vec3& direction);
    void open_context_menu(const Selection& chosen);
    void popups();
    void copy_chosen();
    void paste();

    void menu_bar();
    void tool_bar(const ScreenRect& area);
    void view_bar_tools();
    void centre(const ScreenRect& area, const ViewPainter& paint);
    void left(const WindowLayout& layout);
    void right(const ScreenRect& area);
    void bottom(const ScreenRect& area);
    void properties_tab();
    void photometry_tab();
    void light_tab();
    void lay_out_luminaires(CommandId id);
    void arrange(ObjectId luminaire, CommandId id);
    void room_tab();
    void objects_tab();
    void furniture_tab();
    void furnishing_wish(Furnishing::Wish wish);
    void begin_anew(Scene scene);  ///< a project of this scene, in no file yet
    void status_line(const ScreenRect& area);

    bool is_asking() const;  ///< a dialog stands in front
    void read_preferences();
    void keep_preferences();
    void ask_new_project();
    void open_start_page();
    void start_wish(const StartPage::Outcome& outcome);
    void begin_from(const std::filesystem::path& example);
    /// As it is shown, so that what was read meanwhile takes the place of nothing else.
    std::function<bool()> is_as_before() const;
    void offer_recovery();
    void recover(const LostWork& work);
    void follow_recovery();
    void show(Document document);
    void open_file();
    void load(const std::filesystem::path& file);
    void take_project(Opened<ProjectContent> opened, const std::filesystem::path& file);
    void save(bool under_new_name, std::function<void()> then = nullptr);
    void write(const std::filesystem::path& file, const std::function<void()>& then);
    void ask_about_changed_file(const std::function<void()>& then);
    void ask_where_else(const std::filesystem::path& file, const Diagnostic& fault, const std::function<void()>& then);
    void replace_luminaire_file();
    void import_model();
    void read_model(const std::filesystem::path& file, const ModelReading& how, ModelImport::Then then);
    void take_model(ModelImport::Taken taken);
    void start_with_model(ModelImport::Taken taken);
    void export_model();
    void compare_measured();

    /// Luminaire files on their way into the scene.
    struct Arrival {
        std::deque<std::filesystem::path> files;  ///< not read yet
        std::vector<Photometry> read;
        Diagnostics faults;
        Vec2 place{0.0};    ///< in the plan, to hang at
        ObjectId replaced;  ///< the luminaire whose light they replace; nothing: they hang as new ones
        std::function<void(ObjectId)> then{};  ///< with the one that was hung last
    };
    void receive(Arrival arrival);
    void ask_about_model(const std::filesystem::path& file, bool dropped, Arrival lamps_alone);
    void add_luminaire_file(Arrival arrival);  ///< asks for its file
    void read_next();
    void ask_which(const std::filesystem::path& file, std::vector<Photometry> found);
    void finish_arrival();
    double raster() const { return snap_.raster_now(); }  ///< m
    void draw_export();
    void ask_for_values();
    void copy_picture();
    void toggle_recording();
    void record_frame();
    void follow_recording();
    void save_exact();
    std::string project_hash() const;
    std::optional<Task> running_task();
    void tell(const std::string& source, const Diagnostic& finding);  ///< in the list, and in front
    PictureRequest picture_request() const;                           ///< of the view as it is, annotated
    SolutionSnapshot pictured() const;         ///< what the view shows: the present light or a kept one
    PictureRequest pictured_request() const;   ///< of that
    void guarded(std::function<void()> then);  ///< asks about unsaved changes first
    std::filesystem::path folder() const;

    Options how_;
    ProjectDoor door_;
    Document document_;
    LiveStudy study_;
    ExactPanel exact_;
    Viewport viewport_;
    WidgetRegistry widgets_;
    Form form_{widgets_};
    SeveralPanel several_panel_;
    PhotometryPanel photometry_;
    LightPanel light_;
    StartLayoutDialog start_layout_;
    Dialogs dialogs_;
    FileBrowser browser_;
    ModelImport model_import_;
    BackgroundWork file_work_, start_look_;
    StartPage start_page_;

    std::vector<ViewOverlay*> overlays_;  ///< in the order in which they are drawn
    Arrival arrival_;
    Selection selection_;
    ObjectTree tree_;
    Furnishing furnishing_;
    SnapSettings snap_;
    SnapPopup snap_popup_;
    ContextMenu context_menu_;
    CommandSearch search_;
    HistoryList history_list_;
    std::optional<ImVec2> menu_at_;  ///< where the context menu was asked for
    bool quits_ = false;
    bool shows_overview_ = true;  ///< once the view has a size
    unsigned gesture_item_ = 0;   ///< the ImGui item whose gesture the working copy belongs to
    std::string message_;
    long frames_ = 0;
    Preferences preferences_;
    Readings readings_{viewport_.state};
    PreferencesKeeper keeper_;
    PreferencesDialog preferences_dialog_;
    RecentMenu recent_menu_;
    Messages messages_;
    MessagesPanel messages_panel_;
    bool opens_messages_ = false;  ///< with the next frame
    ExportDialog export_dialog_;
    PictureExport export_;
    bool copies_ = false;  ///< the picture, after this frame
    FrameRecording recording_;
    SceneSnapshot recorded_scene_;
    SolutionSnapshot recorded_solution_;
    TimeLeft study_left_;
    RecoveryDialog recovery_;
    std::shared_ptr<Checks> checks_;
    FileStamp stamp_;  ///< of the project's file, as it was read or written here
    Autosave autosave_;
};

}  // namespace hanei
