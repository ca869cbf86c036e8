// Functions of Xlib and XRandR as far as OGRE 1.12 calls them: there is one screen, nobody types, nothing
// fails.
#define XLIB_ILLEGAL_ACCESS  // the display and its screen are ours to fill in
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/Xrandr.h>

#include <cstdlib>
#include <cstring>

#include "render/headless/EglDisplay.h"

using sagara::headless::EglDisplay;

namespace {

constexpr Window kRoot = 1;
constexpr int kScreenWidth = 1920;
constexpr int kScreenHeight = 1080;

XErrorHandler g_errorHandler = nullptr;

template <typename T>
T* zeroed() {
    return static_cast<T*>(std::calloc(1, sizeof(T)));
}

}  // namespace

extern "C" {

Display* XOpenDisplay(const char*) {
    if (EglDisplay::get() == nullptr) return nullptr;
    auto* screen = zeroed<Screen>();
    screen->root = kRoot;
    screen->width = kScreenWidth;
    screen->height = kScreenHeight;
    screen->mwidth = 508;
    screen->mheight = 286;
    screen->root_depth = 24;
    auto* display = static_cast<_XPrivDisplay>(std::calloc(1, sizeof(*_XPrivDisplay{})));
    display->nscreens = 1;
    display->screens = screen;
    screen->display = reinterpret_cast<Display*>(display);
    return screen->display;
}

int XCloseDisplay(Display* display) {
    auto* own = reinterpret_cast<_XPrivDisplay>(display);
    std::free(own->screens);
    std::free(own);
    return 0;
}

char* XDisplayName(const char*) {
    static char name[] = "headless";
    return name;
}

Window XCreateWindow(Display*, Window, int, int, unsigned width, unsigned height, unsigned, int, unsigned,
                     Visual*, unsigned long, XSetWindowAttributes*) {
    return EglDisplay::get()->createWindow(width, height);
}
int XDestroyWindow(Display*, Window window) { return EglDisplay::get()->destroyWindow(window), 1; }
int XResizeWindow(Display*, Window window, unsigned width, unsigned height) {
    return EglDisplay::get()->resizeWindow(window, width, height), 1;
}
Status XGetWindowAttributes(Display* display, Window window, XWindowAttributes* attributes) {
    std::memset(attributes, 0, sizeof *attributes);
    const auto size = EglDisplay::get()->sizeOf(window);
    attributes->width = window == kRoot ? kScreenWidth : static_cast<int>(size.width);
    attributes->height = window == kRoot ? kScreenHeight : static_cast<int>(size.height);
    attributes->depth = 24;
    attributes->root = kRoot;
    attributes->map_state = IsViewable;
    attributes->screen = reinterpret_cast<_XPrivDisplay>(display)->screens;
    return 1;
}
Status XQueryTree(Display*, Window, Window* root, Window* parent, Window** children, unsigned* count) {
    *root = *parent = kRoot;
    *children = nullptr;
    *count = 0;
    return 1;
}

int XMapWindow(Display*, Window) { return 1; }
int XUnmapWindow(Display*, Window) { return 1; }
int XMoveWindow(Display*, Window, int, int) { return 1; }
int XFlush(Display*) { return 1; }
int XSync(Display*, Bool) { return 1; }
Status XSendEvent(Display*, Window, Bool, long, XEvent*) { return 1; }
int XFree(void* data) { return std::free(data), 1; }
Colormap XCreateColormap(Display*, Window, Visual*, int) { return 1; }
Atom XInternAtom(Display*, const char*, Bool) { return 1; }
Bool XQueryExtension(Display*, const char*, int*, int*, int*) { return False; }
int XGetErrorText(Display*, int, char* text, int length) {
    if (length > 0) *text = '\0';
    return 0;
}
XErrorHandler XSetErrorHandler(XErrorHandler handler) {
    XErrorHandler old = g_errorHandler;
    g_errorHandler = handler;
    return old;
}
VisualID XVisualIDFromVisual(Visual*) { return 1; }
XSizeHints* XAllocSizeHints() { return zeroed<XSizeHints>(); }
XWMHints* XAllocWMHints() { return zeroed<XWMHints>(); }
Status XStringListToTextProperty(char**, int, XTextProperty* property) {
    std::memset(property, 0, sizeof *property);
    return 1;
}
void XSetWMProperties(Display*, Window, XTextProperty*, XTextProperty*, char**, int, XSizeHints*, XWMHints*,
                      XClassHint*) {}
Status XSetWMProtocols(Display*, Window, Atom*, int) { return 1; }

// XQueryExtension says there is no XRandR; these are for the linker.
XRRScreenConfiguration* XRRGetScreenInfo(Display*, Window) { return nullptr; }
void XRRFreeScreenConfigInfo(XRRScreenConfiguration*) {}
SizeID XRRConfigCurrentConfiguration(XRRScreenConfiguration*, Rotation*) { return 0; }
short XRRConfigCurrentRate(XRRScreenConfiguration*) { return 60; }
short* XRRConfigRates(XRRScreenConfiguration*, int, int* count) { return *count = 0, nullptr; }
XRRScreenSize* XRRConfigSizes(XRRScreenConfiguration*, int* count) { return *count = 0, nullptr; }
Status XRRSetScreenConfigAndRate(Display*, XRRScreenConfiguration*, Drawable, int, Rotation, short, Time) {
    return 0;
}

}  // extern "C"
