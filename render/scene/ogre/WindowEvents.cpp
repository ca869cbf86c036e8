#include "render/scene/ogre/WindowEvents.h"

#include <OgreRenderWindow.h>
#include <X11/Xlib.h>
#include <dlfcn.h>

namespace sagara::render {
namespace {

struct X11 {
    int (*pending)(Display*) = nullptr;
    int (*nextEvent)(Display*, XEvent*) = nullptr;

    X11() {
        void* library = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
        if (library == nullptr) return;
        pending = reinterpret_cast<int (*)(Display*)>(dlsym(library, "XPending"));
        nextEvent = reinterpret_cast<int (*)(Display*, XEvent*)>(dlsym(library, "XNextEvent"));
    }
};

}  // namespace

bool pumpWindow(Ogre::RenderWindow& window) {
    static const X11 x11;
    Display* display = nullptr;
    window.getCustomAttribute("XDISPLAY", &display);
    if (display == nullptr || x11.pending == nullptr || x11.nextEvent == nullptr) return false;
    bool closed = false;
    while (x11.pending(display) > 0) {
        XEvent event;
        x11.nextEvent(display, &event);
        if (event.type == ConfigureNotify) window.windowMovedOrResized();
        // The only message OGRE's windows ask for is WM_DELETE_WINDOW.
        if (event.type == ClientMessage) closed = true;
    }
    return closed;
}

}  // namespace sagara::render
