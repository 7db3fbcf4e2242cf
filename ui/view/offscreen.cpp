#include "ui/view/offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <glad/gl.h>
#include <stdexcept>
#include <vector>

namespace hanei {

struct OffscreenContext::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext egl = EGL_NO_CONTEXT;
    void* osmesa_library = nullptr;
    void* osmesa = nullptr;
    void (*destroy_osmesa)(void*) = nullptr;
    std::vector<unsigned char> osmesa_pixels;
    std::string description;
};

namespace {

/// The few names of OSMesa's interface; its header is not needed to build.
namespace osmesa {
constexpr int format = 0x22, depth_bits = 0x30, profile = 0x33, core_profile = 0x34, context_major_version = 0x36,
              context_minor_version = 0x37, rgba = 0x1908;
using Create = void* (*)(const int*, void*);
using MakeCurrent = unsigned char (*)(void*, void*, unsigned, int, int);
using Destroy = void (*)(void*);
using GetProcAddress = GLADapiproc (*)(const char*);
}  // namespace osmesa

std::string renderer_name() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name != nullptr ? name : "unknown renderer";
}

std::string egl_fault(const char* what) { return fmt::format("EGL: {} (error {:#x})", what, eglGetError()); }

/// Empty when it worked, else why not.
std::string open_egl(OffscreenContext::Handles& handles) {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display == nullptr) return "EGL: no platform displays";
    handles.display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handles.display == EGL_NO_DISPLAY) return egl_fault("no surfaceless display");
    if (eglInitialize(handles.display, nullptr, nullptr) == EGL_FALSE) return egl_fault("the display does not start");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return egl_fault("no OpenGL");
    const EGLint config_wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (eglChooseConfig(handles.display, config_wish, &config, 1, &configs) == EGL_FALSE || configs < 1) {
        config = EGL_NO_CONFIG_KHR;  // surfaceless drivers may offer none and need none
    }
    const EGLint context_wish[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    handles.egl = eglCreateContext(handles.display, config, EGL_NO_CONTEXT, context_wish);
    if (handles.egl == EGL_NO_CONTEXT) return egl_fault("no OpenGL 3.3 core context");
    if (eglMakeCurrent(handles.display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles.egl) == EGL_FALSE) {
        return egl_fault("the context cannot be used without a surface");
    }
    if (gladLoadGL(eglGetProcAddress) == 0) return "EGL: OpenGL's functions are missing";
    handles.description = "EGL surfaceless, " + renderer_name();
    return {};
}

void close_egl(OffscreenContext::Handles& handles) {
    if (handles.egl == EGL_NO_CONTEXT) return;
    eglMakeCurrent(handles.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(handles.display, handles.egl);
    handles.egl = EGL_NO_CONTEXT;
}

template <class Function>
Function found_in(void* library, const char* name) {
    return reinterpret_cast<Function>(dlsym(library, name));
}

std::string open_osmesa(OffscreenContext::Handles& handles) {
    handles.osmesa_library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (handles.osmesa_library == nullptr) return "OSMesa: libOSMesa.so.8 is not installed";
    const auto create = found_in<osmesa::Create>(handles.osmesa_library, "OSMesaCreateContextAttribs");
    const auto make_current = found_in<osmesa::MakeCurrent>(handles.osmesa_library, "OSMesaMakeCurrent");
    const auto proc = found_in<osmesa::GetProcAddress>(handles.osmesa_library, "OSMesaGetProcAddress");
    handles.destroy_osmesa = found_in<osmesa::Destroy>(handles.osmesa_library, "OSMesaDestroyContext");
    if (create == nullptr || make_current == nullptr || proc == nullptr || handles.destroy_osmesa == nullptr) {
        return "OSMesa: the library is too old";
    }
    const int wish[] = {osmesa::format,
                        osmesa::rgba,
                        osmesa::depth_bits,
                        24,
                        osmesa::profile,
                        osmesa::core_profile,
                        osmesa::context_major_version,
                        3,
                        osmesa::context_minor_version,
                        3,
                        0};
    handles.osmesa = create(wish, nullptr);
    if (handles.osmesa == nullptr) return "OSMesa: no OpenGL 3.3 core context";
    constexpr int side = 16;  // its own buffer is never drawn into
    handles.osmesa_pixels.resize(4 * side * side);
    if (make_current(handles.osmesa, handles.osmesa_pixels.data(), GL_UNSIGNED_BYTE, side, side) == 0) {
        return "OSMesa: the context cannot be used";
    }
    if (gladLoadGL(proc) == 0) return "OSMesa: OpenGL's functions are missing";
    handles.description = "OSMesa, " + renderer_name();
    return {};
}

}  // namespace

OffscreenContext::OffscreenContext() : handles_(std::make_unique<Handles>()) {
    const std::string no_egl = open_egl(*handles_);
    if (no_egl.empty()) return;
    close_egl(*handles_);
    const std::string no_osmesa = open_osmesa(*handles_);
    if (no_osmesa.empty()) return;
    throw std::runtime_error("No OpenGL without a display. " + no_egl + ". " + no_osmesa + ".");
}

OffscreenContext::~OffscreenContext() {
    close_egl(*handles_);
    if (handles_->osmesa != nullptr) handles_->destroy_osmesa(handles_->osmesa);
}

const std::string& OffscreenContext::description() const { return handles_->description; }

}  // namespace hanei
