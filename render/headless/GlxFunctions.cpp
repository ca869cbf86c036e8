// GLX as far as OGRE 1.12 calls it: one pixel format, contexts by EGL.
#include <GL/glx.h>

#include <cstdlib>
#include <cstring>

#include "render/headless/EglDisplay.h"

using sagara::headless::EglDisplay;

namespace {

int g_config = 0;  ///< the one pixel format; only its address counts
Display* g_currentDisplay = nullptr;
GLXDrawable g_currentDrawable = 0;

GLXFBConfig* oneConfig(int* count) {
    auto* list = static_cast<GLXFBConfig*>(std::calloc(1, sizeof(GLXFBConfig)));
    *list = reinterpret_cast<GLXFBConfig>(&g_config);
    *count = 1;
    return list;
}

GLXContext createContext(Display*, GLXFBConfig, GLXContext share, Bool, const int* attributes) {
    int major = 3, minor = 3;
    for (; attributes != nullptr && attributes[0] != 0; attributes += 2) {
        if (attributes[0] == GLX_CONTEXT_MAJOR_VERSION_ARB) major = attributes[1];
        if (attributes[0] == GLX_CONTEXT_MINOR_VERSION_ARB) minor = attributes[1];
    }
    return reinterpret_cast<GLXContext>(EglDisplay::get()->createContext(share, major, minor));
}

/// Nobody watches; OGRE insists on having one.
int swapInterval(int) { return 0; }

}  // namespace

extern "C" {

Bool glXQueryVersion(Display*, int* major, int* minor) {
    *major = 1;
    *minor = 4;
    return True;
}
const char* glXGetClientString(Display*, int name) {
    return name == GLX_EXTENSIONS ? "GLX_ARB_create_context GLX_ARB_create_context_profile" : "1.4";
}
GLXFBConfig* glXChooseFBConfig(Display*, int, const int*, int* count) { return oneConfig(count); }
GLXFBConfig* glXGetFBConfigs(Display*, int, int* count) { return oneConfig(count); }
int glXGetFBConfigAttrib(Display*, GLXFBConfig, int name, int* value) {
    const EglDisplay& egl = *EglDisplay::get();
    switch (name) {
        case GLX_RED_SIZE:
            return *value = egl.attribute(EGL_RED_SIZE), Success;
        case GLX_GREEN_SIZE:
            return *value = egl.attribute(EGL_GREEN_SIZE), Success;
        case GLX_BLUE_SIZE:
            return *value = egl.attribute(EGL_BLUE_SIZE), Success;
        case GLX_ALPHA_SIZE:
            return *value = egl.attribute(EGL_ALPHA_SIZE), Success;
        case GLX_DEPTH_SIZE:
            return *value = egl.attribute(EGL_DEPTH_SIZE), Success;
        case GLX_STENCIL_SIZE:
            return *value = egl.attribute(EGL_STENCIL_SIZE), Success;
        case GLX_BUFFER_SIZE:
            return *value = egl.attribute(EGL_BUFFER_SIZE), Success;
        case GLX_FBCONFIG_ID:
        case GLX_VISUAL_ID:
        case GLX_DOUBLEBUFFER:
        case GLX_X_RENDERABLE:
            return *value = 1, Success;
        case GLX_DRAWABLE_TYPE:
            return *value = GLX_WINDOW_BIT | GLX_PBUFFER_BIT, Success;
        case GLX_RENDER_TYPE:
            return *value = GLX_RGBA_BIT, Success;
        default:
            return *value = 0, Success;
    }
}
XVisualInfo* glXGetVisualFromFBConfig(Display*, GLXFBConfig) {
    auto* info = static_cast<XVisualInfo*>(std::calloc(1, sizeof(XVisualInfo)));
    info->visualid = 1;
    info->depth = 24;
    info->bits_per_rgb = 8;
    return info;
}

GLXContext glXCreateNewContext(Display* display, GLXFBConfig config, int, GLXContext share, Bool direct) {
    return createContext(display, config, share, direct, nullptr);
}
void glXDestroyContext(Display*, GLXContext context) { EglDisplay::get()->destroyContext(context); }
Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    if (!EglDisplay::get()->makeCurrent(drawable, context)) return False;
    g_currentDisplay = context != nullptr ? display : nullptr;
    g_currentDrawable = context != nullptr ? drawable : 0;
    return True;
}
GLXContext glXGetCurrentContext() { return reinterpret_cast<GLXContext>(eglGetCurrentContext()); }
Display* glXGetCurrentDisplay() { return g_currentDisplay; }
GLXDrawable glXGetCurrentDrawable() { return g_currentDrawable; }
int glXQueryContext(Display*, GLXContext, int, int* value) { return *value = 1, Success; }
void glXQueryDrawable(Display*, GLXDrawable drawable, int name, unsigned* value) {
    const auto size = EglDisplay::get()->sizeOf(drawable);
    *value = name == GLX_WIDTH ? size.width : name == GLX_HEIGHT ? size.height : 1;
}
void glXSwapBuffers(Display*, GLXDrawable drawable) { EglDisplay::get()->swap(drawable); }

GLXPbuffer glXCreatePbuffer(Display*, GLXFBConfig, const int* attributes) {
    unsigned width = 1, height = 1;
    for (; attributes != nullptr && attributes[0] != 0; attributes += 2) {
        if (attributes[0] == GLX_PBUFFER_WIDTH) width = static_cast<unsigned>(attributes[1]);
        if (attributes[0] == GLX_PBUFFER_HEIGHT) height = static_cast<unsigned>(attributes[1]);
    }
    return EglDisplay::get()->createWindow(width, height);
}
void glXDestroyPbuffer(Display*, GLXPbuffer buffer) { EglDisplay::get()->destroyWindow(buffer); }

__GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) {
    const char* text = reinterpret_cast<const char*>(name);
    if (std::strcmp(text, "glXCreateContextAttribsARB") == 0)
        return reinterpret_cast<__GLXextFuncPtr>(&createContext);
    if (std::strcmp(text, "glXSwapIntervalSGI") == 0) return reinterpret_cast<__GLXextFuncPtr>(&swapInterval);
    if (std::strncmp(text, "glX", 3) == 0) return nullptr;
    return reinterpret_cast<__GLXextFuncPtr>(eglGetProcAddress(text));
}

}  // extern "C"
