#include "ui/window/window.h"

#include "engine/base/whole_file.h"
#include "ui/panels/state_text.h"

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <array>
#include <chrono>
#include <cstdio>
#include <imgui.h>
#include <memory>
#include <stdexcept>
#include <thread>

namespace hanei {
namespace {

static_assert(static_cast<int>(Key::escape) == GLFW_KEY_ESCAPE && static_cast<int>(Key::end) == GLFW_KEY_END &&
              static_cast<int>(Key::f1) == GLFW_KEY_F1 && static_cast<int>(Key::keypad_enter) == GLFW_KEY_KP_ENTER &&
              static_cast<int>(Key::keypad_0) == GLFW_KEY_KP_0 &&
              static_cast<int>(Key::left_shift) == GLFW_KEY_LEFT_SHIFT && GLFW_KEY_LAST < key_count);

constexpr int frames_after_input = 3;  // ImGui needs two to settle a popup's size
constexpr std::chrono::duration<double> shortest_frame{1.0 / 60.0};
constexpr double patience = 0.1;                 // s: a file that takes longer is read away from the frames
constexpr double look_at_progress_every = 0.05;  // s, while a study runs

std::string& last_fault() {
    static std::string text;
    return text;
}

struct Library {
    Library() {
        glfwSetErrorCallback([](int, const char* text) { last_fault() = text; });
        if (glfwInit() == GLFW_FALSE)
            throw std::runtime_error("No window: " + last_fault() +
                                     " Without a display, \"hanei render\" draws pictures.");
    }
    ~Library() { glfwTerminate(); }
};

struct CloseWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, CloseWindow>;

WindowHandle open_window(PixelSize size, const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "hanei");
    WindowHandle window(glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr));
    if (!window) throw std::runtime_error("No window with OpenGL 3.3: " + last_fault());
    glfwSetWindowSizeLimits(window.get(), 800, 600, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window.get());
    if (gladLoadGL(glfwGetProcAddress) == 0) throw std::runtime_error("OpenGL's functions cannot be loaded.");
    glfwSwapInterval(0);  // the loop keeps the pace; waiting for a screen would delay input
    return window;
}

/// What the callbacks of a window reach.
struct Reach {
    Desk& desk;
    int frames_due = frames_after_input;
};

Reach& reach_of(GLFWwindow* window) {
    Reach& reach = *static_cast<Reach*>(glfwGetWindowUserPointer(window));
    reach.frames_due = frames_after_input;
    return reach;
}

void connect(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, [](GLFWwindow* from, double x, double y) {
        reach_of(from).desk.input().mouse_move(static_cast<float>(x), static_cast<float>(y));
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* from, int entered) {
        if (entered == GLFW_FALSE) reach_of(from).desk.input().mouse_leave();
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* from, int button, int action, int) {
        reach_of(from).desk.input().mouse_button(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* from, double, double notches) {
        reach_of(from).desk.input().wheel(static_cast<float>(notches));
    });
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int) {
        Reach& reach = reach_of(from);
        if (action != GLFW_REPEAT) reach.desk.input().key(static_cast<Key>(key), action == GLFW_PRESS);
    });
    glfwSetCharCallback(window, [](GLFWwindow* from, unsigned code) { reach_of(from).desk.input().character(code); });
    glfwSetWindowFocusCallback(
        window, [](GLFWwindow* from, int gained) { reach_of(from).desk.input().focus(gained == GLFW_TRUE); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* from) { reach_of(from); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* from, int, int) { reach_of(from); });
    glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** paths) {
        double x = 0.0, y = 0.0;  // no movement is reported while something is dragged from another window
        glfwGetCursorPos(from, &x, &y);
        InputQueue& input = reach_of(from).desk.input();
        input.mouse_move(static_cast<float>(x), static_cast<float>(y));
        input.drop({paths, paths + count});
    });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* from) {
        glfwSetWindowShouldClose(from, GLFW_FALSE);  // unsaved changes are asked about first
        reach_of(from).desk.workbench().ask_to_quit();
    });
}

void share_clipboard(GLFWwindow* window) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.GetClipboardTextFn = [](void* from) { return glfwGetClipboardString(static_cast<GLFWwindow*>(from)); };
    io.SetClipboardTextFn = [](void* to, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(to), text);
    };
}

class Cursors {
public:
    Cursors() {
        shapes_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
        shapes_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
        shapes_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
        shapes_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
    }
    ~Cursors() {
        for (GLFWcursor* shape : shapes_) {
            if (shape != nullptr) glfwDestroyCursor(shape);
        }
    }
    void show(GLFWwindow* window) {
        const int wished = ImGui::GetMouseCursor();
        if (wished == shown_ || wished < 0) return;
        shown_ = wished;
        glfwSetCursor(window, shapes_[static_cast<std::size_t>(wished)]);  // null: the usual arrow
    }

private:
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> shapes_{};
    int shown_ = ImGuiMouseCursor_Arrow;
};

/// Who waits for it is told once why it does not come, and again after it did.
void write_state(const Workbench& workbench, const std::filesystem::path& file, std::string& told) {
    const std::string reason = write_passing_file(file, state_json(workbench)).value_or("");
    if (reason != told && !reason.empty()) std::fprintf(stderr, "%s: %s\n", file.c_str(), reason.c_str());
    told = reason;
}

void wait_for_events(Reach& reach) {
    if (reach.frames_due > 0 || !reach.desk.input().empty() || reach.desk.workbench().viewport().goes_on())
        glfwPollEvents();
    else if (reach.desk.workbench().is_busy())
        glfwWaitEventsTimeout(look_at_progress_every);
    else
        glfwWaitEvents();
}

}  // namespace

void run_window(WindowRequest request) {
    using Clock = std::chrono::steady_clock;
    const Library library;
    const WindowHandle window = open_window(request.size, "Hanei");
    float scale = 1.0F;
    if (request.scale > 0.0F)
        scale = request.scale;
    else
        glfwGetWindowContentScale(window.get(), &scale, nullptr);
    Desk desk({std::move(request.content), request.file, std::move(request.door), [] { glfwPostEmptyEvent(); }, scale,
               false, patience});
    if (request.file.empty()) desk.workbench().offer_start();
    Reach reach{desk};
    glfwSetWindowUserPointer(window.get(), &reach);
    connect(window.get());
    share_clipboard(window.get());
    Cursors cursors;
    std::string title, state_fault;
    Clock::time_point last = Clock::now();
    while (!desk.workbench().wants_to_quit()) {
        wait_for_events(reach);
        PixelSize size;
        glfwGetFramebufferSize(window.get(), &size.width, &size.height);
        if (size.width == 0 || size.height == 0) continue;  // minimised
        std::this_thread::sleep_until(last + std::chrono::duration_cast<Clock::duration>(shortest_frame));
        const Clock::time_point start = Clock::now();
        desk.frame(size, std::chrono::duration<float>(start - last).count());
        last = start;
        reach.frames_due = std::max(0, reach.frames_due - 1);
        glfwSwapBuffers(window.get());
        cursors.show(window.get());
        if (const std::string wished = desk.workbench().title(); wished != title)
            glfwSetWindowTitle(window.get(), (title = wished).c_str());
        if (request.state_file) write_state(desk.workbench(), *request.state_file, state_fault);
    }
}

}  // namespace hanei
