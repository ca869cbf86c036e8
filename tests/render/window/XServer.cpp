#include "XServer.h"

#include <X11/Xutil.h>
#include <X11/extensions/Xrandr.h>

#include <stdexcept>

namespace sagara::test {

XServer::XServer() : m_display(XOpenDisplay(nullptr)) {
    if (m_display == nullptr) throw std::runtime_error("these tests run under xvfb-run");
}
XServer::~XServer() { XCloseDisplay(m_display); }

int XServer::screenWidth() const { return DisplayWidth(m_display, 0); }
int XServer::screenHeight() const { return DisplayHeight(m_display, 0); }

void XServer::splitInTwo() {
    const Window root = DefaultRootWindow(m_display);
    XRRScreenResources* const resources = XRRGetScreenResources(m_display, root);
    for (int i = 0; i < 2; ++i) {
        XRRMonitorInfo* const monitor = XRRAllocateMonitor(m_display, i == 0 ? 1 : 0);
        if (i == 0) monitor->outputs[0] = resources->outputs[0];  // else it stays a monitor of its own
        monitor->name = XInternAtom(m_display, i == 0 ? "left" : "right", False);
        monitor->x = i * screenWidth() / 2;
        monitor->width = screenWidth() / 2;
        monitor->height = screenHeight();
        XRRSetMonitor(m_display, root, monitor);
        XRRFreeMonitors(monitor);
    }
    XRRFreeScreenResources(resources);
    XSync(m_display, False);
}

Window XServer::find(const std::string& title) const {
    Window root, parent, *children = nullptr, found = 0;
    unsigned count = 0;
    XQueryTree(m_display, DefaultRootWindow(m_display), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count; ++i) {
        char* name = nullptr;
        if (XFetchName(m_display, children[i], &name) == 0 || name == nullptr) continue;
        if (title == name) found = children[i];
        XFree(name);
    }
    if (children != nullptr) XFree(children);
    return found;
}

XServer::Geometry XServer::geometry(Window window) const {
    XWindowAttributes a;
    XGetWindowAttributes(m_display, window, &a);
    return {a.x, a.y, a.width, a.height};
}

void XServer::resize(Window window, int width, int height) const {
    XResizeWindow(m_display, window, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XSync(m_display, False);
}

void XServer::askToClose(Window window) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(m_display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(m_display, "WM_DELETE_WINDOW", False));
    XSendEvent(m_display, window, False, NoEventMask, &event);
    XSync(m_display, False);
}

std::vector<unsigned char> XServer::pixels(Window window) const {
    const Geometry g = geometry(window);
    XImage* const image = XGetImage(m_display, window, 0, 0, static_cast<unsigned>(g.width),
                                    static_cast<unsigned>(g.height), AllPlanes, ZPixmap);
    std::vector<unsigned char> pixels;
    for (int y = 0; y < g.height; ++y) {
        for (int x = 0; x < g.width; ++x) {
            const unsigned long p = XGetPixel(image, x, y);
            for (const int shift : {0, 8, 16}) pixels.push_back(static_cast<unsigned char>(p >> shift));
        }
    }
    XDestroyImage(image);
    return pixels;
}

}  // namespace sagara::test
