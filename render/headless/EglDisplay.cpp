#include "render/headless/EglDisplay.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <array>

namespace sagara::headless {
namespace {

bool start(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
}

/// The first device that starts, graphics cards before software.
EGLDisplay deviceDisplay() {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (queryDevices == nullptr || platformDisplay == nullptr) return EGL_NO_DISPLAY;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        EGLDisplay display = platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (start(display)) return display;
    }
    EGLDisplay display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    return start(display) ? display : EGL_NO_DISPLAY;
}

}  // namespace

EglDisplay* EglDisplay::get() {
    static EglDisplay display;
    static const bool opened = display.open();
    return opened ? &display : nullptr;
}

bool EglDisplay::open() {
    m_display = deviceDisplay();
    if (m_display == EGL_NO_DISPLAY) {
        m_display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        if (!start(m_display)) return false;
    }
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return false;
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             8,
                             EGL_NONE};
    std::array<EGLConfig, 128> configs{};
    EGLint count = 0;
    if (eglChooseConfig(m_display, wanted, configs.data(), static_cast<EGLint>(configs.size()), &count) !=
        EGL_TRUE)
        return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {  // the most colourful come first
        m_config = configs[i];
        if (attribute(EGL_RED_SIZE) == 8 && attribute(EGL_ALPHA_SIZE) == 8) return true;
    }
    return count > 0;
}

EGLContext EglDisplay::createContext(EGLContext share, int major, int minor) const {
    eglBindAPI(EGL_OPENGL_API);  // a state of the thread, and each stage has its own
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    return eglCreateContext(m_display, m_config, share, attributes);
}

bool EglDisplay::makeCurrent(std::uint64_t window, EGLContext context) {
    eglBindAPI(EGL_OPENGL_API);
    if (context == EGL_NO_CONTEXT)
        return eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) == EGL_TRUE;
    const auto found = m_windows.find(window);
    if (found == m_windows.end()) return false;
    return eglMakeCurrent(m_display, found->second.surface, found->second.surface, context) == EGL_TRUE;
}

void EglDisplay::swap(std::uint64_t window) {
    const auto found = m_windows.find(window);
    if (found != m_windows.end()) eglSwapBuffers(m_display, found->second.surface);
}

EGLSurface EglDisplay::newSurface(Size size) const {
    const EGLint attributes[] = {EGL_WIDTH, static_cast<EGLint>(std::max(1u, size.width)), EGL_HEIGHT,
                                 static_cast<EGLint>(std::max(1u, size.height)), EGL_NONE};
    return eglCreatePbufferSurface(m_display, m_config, attributes);
}

std::uint64_t EglDisplay::createWindow(unsigned width, unsigned height) {
    const Size size{width, height};
    m_windows[++m_nextWindow] = {newSurface(size), size};
    return m_nextWindow;
}

void EglDisplay::resizeWindow(std::uint64_t window, unsigned width, unsigned height) {
    const auto found = m_windows.find(window);
    if (found == m_windows.end()) return;
    const Size size{width, height};
    EGLSurface old = found->second.surface;
    found->second = {newSurface(size), size};
    if (eglGetCurrentSurface(EGL_DRAW) == old) makeCurrent(window, eglGetCurrentContext());
    eglDestroySurface(m_display, old);
}

void EglDisplay::destroyWindow(std::uint64_t window) {
    const auto found = m_windows.find(window);
    if (found == m_windows.end()) return;
    eglDestroySurface(m_display, found->second.surface);
    m_windows.erase(found);
}

EglDisplay::Size EglDisplay::sizeOf(std::uint64_t window) const {
    const auto found = m_windows.find(window);
    return found == m_windows.end() ? Size{} : found->second.size;
}

int EglDisplay::attribute(EGLint name) const {
    EGLint value = 0;
    eglGetConfigAttrib(m_display, m_config, name, &value);
    return value;
}

}  // namespace sagara::headless
