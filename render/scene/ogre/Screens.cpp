#include "render/scene/ogre/Screens.h"

#include <OgreRenderWindow.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/extensions/Xrandr.h>
#include <dlfcn.h>

#include <algorithm>
#include <tuple>

namespace sagara::render {
namespace {

/// Of X libraries only as far as OGRE has loaded them already: see render/headless.
template <typename Function>
Function* loaded(const char* library, const char* name) {
    void* const handle = dlopen(library, RTLD_NOW | RTLD_NOLOAD);
    return handle == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(handle, name));
}
#define SAGARA_X11(name) loaded<decltype(name)>("libX11.so.6", #name)
#define SAGARA_XRANDR(name) loaded<decltype(name)>("libXrandr.so.2", #name)

struct XWindow {
    Display* display = nullptr;
    Window window = 0;

    explicit XWindow(Ogre::RenderWindow& of) {
        of.getCustomAttribute("XDISPLAY", &display);
        of.getCustomAttribute("WINDOW", &window);
    }
};

/// Tells the window manager: no frame (Motif's hint, which all know), and the whole screen (EWMH).
void askWindowManager(const XWindow& x) {
    const auto internAtom = SAGARA_X11(XInternAtom);
    const auto changeProperty = SAGARA_X11(XChangeProperty);
    const auto sendEvent = SAGARA_X11(XSendEvent);
    const auto defaultRoot = SAGARA_X11(XDefaultRootWindow);
    if (!internAtom || !changeProperty || !sendEvent || !defaultRoot) return;
    const auto atom = [&](const char* name) { return internAtom(x.display, name, False); };

    constexpr unsigned long kDecorationsTold = 2;
    const unsigned long noFrame[5] = {kDecorationsTold, 0, 0, 0, 0};
    const Atom motif = atom("_MOTIF_WM_HINTS");
    changeProperty(x.display, x.window, motif, motif, 32, PropModeReplace,
                   reinterpret_cast<const unsigned char*>(noFrame), 5);

    constexpr long kAdd = 1, kFromProgram = 1;
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = x.window;
    event.xclient.message_type = atom("_NET_WM_STATE");
    event.xclient.format = 32;
    event.xclient.data.l[0] = kAdd;
    event.xclient.data.l[1] = static_cast<long>(atom("_NET_WM_STATE_FULLSCREEN"));
    event.xclient.data.l[3] = kFromProgram;
    sendEvent(x.display, defaultRoot(x.display), False, SubstructureNotifyMask | SubstructureRedirectMask,
              &event);
}

}  // namespace

std::vector<ScreenArea> screensOf(Ogre::RenderWindow& window) {
    const XWindow x(window);
    const auto getMonitors = SAGARA_XRANDR(XRRGetMonitors);
    const auto freeMonitors = SAGARA_XRANDR(XRRFreeMonitors);
    const auto defaultRoot = SAGARA_X11(XDefaultRootWindow);
    std::vector<ScreenArea> screens;
    if (x.display == nullptr || !getMonitors || !freeMonitors || !defaultRoot) return screens;
    int count = 0;
    XRRMonitorInfo* const monitors = getMonitors(x.display, defaultRoot(x.display), True, &count);
    if (monitors == nullptr) return screens;
    for (int i = 0; i < count; ++i)
        screens.push_back({monitors[i].x, monitors[i].y, monitors[i].width, monitors[i].height});
    freeMonitors(monitors);
    std::sort(screens.begin(), screens.end(), [](const ScreenArea& a, const ScreenArea& b) {
        return std::tie(a.left, a.top) < std::tie(b.left, b.top);
    });
    return screens;
}

void cover(Ogre::RenderWindow& window, const ScreenArea& screen) {
    const XWindow x(window);
    if (x.display == nullptr) return;
    // On that screen first: there the window manager enlarges it. (OGRE's own resize tells only its
    // viewports.)
    if (const auto moveResize = SAGARA_X11(XMoveResizeWindow))
        moveResize(x.display, x.window, screen.left, screen.top, static_cast<unsigned>(screen.width),
                   static_cast<unsigned>(screen.height));
    askWindowManager(x);
    if (const auto sync = SAGARA_X11(XSync)) sync(x.display, False);
    window.windowMovedOrResized();
}

}  // namespace sagara::render
