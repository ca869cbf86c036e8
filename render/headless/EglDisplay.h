#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <map>

namespace sagara::headless {

/// The one EGL display of the process, its one pixel format, and a pixel buffer for every "window". Used by
/// one thread at a time, as Xlib without XInitThreads is.
class EglDisplay {
public:
    /// Null when no display can be had.
    static EglDisplay* get();

    EGLContext createContext(EGLContext share, int major, int minor) const;
    void destroyContext(EGLContext context) const { eglDestroyContext(m_display, context); }
    bool makeCurrent(std::uint64_t window, EGLContext context);
    void swap(std::uint64_t window);

    std::uint64_t createWindow(unsigned width, unsigned height);
    void resizeWindow(std::uint64_t window, unsigned width, unsigned height);
    void destroyWindow(std::uint64_t window);
    struct Size {
        unsigned width = 0;
        unsigned height = 0;
    };
    Size sizeOf(std::uint64_t window) const;
    int attribute(EGLint name) const;  ///< of the pixel format

private:
    struct Window {
        EGLSurface surface = EGL_NO_SURFACE;
        Size size;
    };
    bool open();
    EGLSurface newSurface(Size size) const;

    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLConfig m_config = nullptr;
    std::map<std::uint64_t, Window> m_windows;
    std::uint64_t m_nextWindow = 0x1000;
};

}  // namespace sagara::headless
